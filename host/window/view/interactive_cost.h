// How large a picture and its light maps are while a hand is on the controls, so that it follows the hand.
#pragma once

#include <array>
#include <cstddef>

#include "core/shared/glue.h"

namespace plinian::window {

/// Learns from each picture what a pixel and a texel cost, and says how many of either the next one may have.
class InteractiveCost {
 public:
  InteractiveCost() = default;
  /// limit_ms: what a picture may take, maps and all.
  explicit InteractiveCost(double limit_ms) : limit_ms_(limit_ms) {}

  struct Choice {
    double scale = 0.5;    // [-] of the pane's sides, at least a quarter
    int resolution = 256;  // [texels] of maps, at least 64 or what they have at rest
  };
  /// For a picture for which so many maps have to be built, of which one at rest has `full` texels a side:
  /// what loses least and is soonest there. Stays with what it said last where another choice would be little
  /// better, so that pictures do not flutter.
  Choice choose(ivec2 pane, int full, int builds);
  /// The size [pixels] of a picture: not under 64 pixels where the pane has so many.
  static ivec2 size(ivec2 pane, double scale);

  /// What a pass over a picture of that size took. [ms]
  void took_view(ivec2 size, double milliseconds);
  /// What it took to build so many maps of that resolution. [ms]
  void took_maps(int resolution, int builds, double milliseconds);

 private:
  /// The middle of the last few: one that was held up, by a shader that was made or by another program, says
  /// nothing of the next.
  class Recent {
   public:
    void add(double value);
    double middle() const;  // 0: none yet
   private:
    std::array<double, 5> values_{};
    std::size_t count_ = 0;
  };

  double limit_ms_ = 85.0;
  Recent ms_per_pixel_, ms_per_texel_;
  Choice last_;
  bool last_builds_ = false;
};

}  // namespace plinian::window
