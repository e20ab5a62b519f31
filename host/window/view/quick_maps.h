// Which light maps the renderer holds, and whether they serve a quick picture: then they are as large as they
// are.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/snapshot.h"
#include "core/transmittance/map_key.h"

namespace plinian::window {

class QuickMaps {
 public:
  /// The resolution [texels] at which no map has to be built for the scene: its own, or that of what was
  /// rendered last; none where there is none.
  std::optional<int> serving(const SceneSnapshot& scene) const;
  /// How many of the scene's maps are other ones than those that are held, whatever their resolution.
  int builds(const SceneSnapshot& scene) const;
  /// What was rendered: the renderer holds its maps now, or older ones that serve.
  void rendered(const SceneSnapshot& scene);
  /// The renderer holds nothing, or nobody knows what.
  void forget() { *this = {}; }

 private:
  SceneSnapshot held_scene_;  // keeps the volumes that the keys tell apart by address
  std::vector<MapKey> held_;
};

}  // namespace plinian::window
