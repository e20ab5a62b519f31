// How large the light maps of a quick picture are: full where those that the renderer holds serve it, small
// where they would have to be built.
#pragma once

#include <vector>

#include "core/scene/snapshot.h"
#include "core/transmittance/map_key.h"

namespace plinian::window {

class QuickMaps {
 public:
  explicit QuickMaps(double wanted_ms = 60.0) : wanted_ms_(wanted_ms) {}

  /// The resolution [texels] for a quick picture of the scene: that of the scene, or of what was rendered
  /// last, where no map has to be built for it; else half of it, at most 256, or less where that would take
  /// too long, but not under 64 (or what there is).
  int resolution(const SceneSnapshot& scene);
  /// What it took to build the maps of a picture at that resolution. [ms]
  void took(int resolution, double milliseconds);
  /// What was rendered: the renderer holds its maps now.
  void rendered(const SceneSnapshot& scene);
  /// The renderer holds nothing, or nobody knows what.
  void forget() { held_.clear(); }

 private:
  bool are_held(const SceneSnapshot& scene) const;

  double wanted_ms_;
  double ms_per_texel_ = 0.0;  // of a side squared, all maps together; 0: not known yet
  int most_ = 256;             // [texels] that come in time
  SceneSnapshot held_scene_;   // keeps the volumes that the keys tell apart by address
  std::vector<MapKey> held_;
};

}  // namespace plinian::window
