// Compares the keys by which renderers decide.
#include "host/window/view/quick_maps.h"

#include <algorithm>

namespace plinian::window {

namespace {

std::vector<MapKey> keys_of(const SceneSnapshot& scene) {
  const FlatScene flat = flatten(scene);
  std::vector<MapKey> keys;
  for (std::size_t i = 0; i < flat.maps.size(); ++i) keys.push_back(map_key(flat, int(i)));
  return keys;
}

}  // namespace

bool QuickMaps::are_held(const SceneSnapshot& scene) const {
  const std::vector<MapKey> wanted = keys_of(scene);
  return std::equal(wanted.begin(), wanted.end(), held_.begin(), held_.end(),
                    [](const MapKey& w, const MapKey& h) { return rebuild_reason(h, w).empty(); });
}

int QuickMaps::resolution(const SceneSnapshot& scene) const {
  const int full = scene.quality.map.resolution;
  if (are_held(scene)) return full;
  SceneSnapshot other = scene;
  other.quality.map.resolution = held_scene_.quality.map.resolution;
  if (!held_.empty() && other.quality.map.resolution < full && are_held(other))
    return other.quality.map.resolution;
  return std::min(full, std::clamp(full / 2, 64, 256));
}

void QuickMaps::rendered(const SceneSnapshot& scene) {
  held_scene_ = scene;
  held_ = keys_of(scene);
}

}  // namespace plinian::window
