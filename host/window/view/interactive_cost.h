// How much of the picture's size is rendered while a hand is on the controls, so that it follows the hand.
#pragma once

#include "core/shared/glue.h"

namespace plinian::window {

/// Learns from each picture what a pixel costs, and says how large the next one may be.
class InteractiveCost {
 public:
  explicit InteractiveCost(double wanted_ms = 70.0) : wanted_ms_(wanted_ms) {}

  /// The size [pixels] at which a picture of a pane that large comes in time: the pane itself, or a part of
  /// it not under a quarter of its sides nor under 64 pixels. Moves by steps, so that it does not flutter.
  ivec2 size(ivec2 pane);
  /// What a pass over a picture of that size took. [ms]
  void took(ivec2 size, double milliseconds);

 private:
  double wanted_ms_;
  double ms_per_pixel_ = 0.0;  // 0: not known yet
  double scale_ = 0.5;         // [-] of the sides
};

}  // namespace plinian::window
