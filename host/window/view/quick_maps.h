// How large the light maps of a quick picture are: full where those that the renderer holds serve it, small
// where they would have to be built.
#pragma once

#include <vector>

#include "core/scene/snapshot.h"
#include "core/transmittance/map_key.h"

namespace plinian::window {

class QuickMaps {
 public:
  /// The resolution [texels] for a quick picture of the scene: that of the scene, or of what was rendered
  /// last, where no map has to be built for it; else half of it, at most 256 and at least 64 (or what there
  /// is).
  int resolution(const SceneSnapshot& scene) const;
  /// What was rendered: the renderer holds its maps now.
  void rendered(const SceneSnapshot& scene);
  /// The renderer holds nothing, or nobody knows what.
  void forget() { held_.clear(); }

 private:
  bool are_held(const SceneSnapshot& scene) const;

  SceneSnapshot held_scene_;  // keeps the volumes that the keys tell apart by address
  std::vector<MapKey> held_;
};

}  // namespace plinian::window
