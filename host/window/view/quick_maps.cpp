// Compares the keys by which renderers decide.
#include "host/window/view/quick_maps.h"

#include <algorithm>
#include <cmath>

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

void QuickMaps::took(int resolution, double milliseconds) {
  const double now = milliseconds / (double(resolution) * resolution);
  ms_per_texel_ = ms_per_texel_ > 0.0 ? 0.6 * ms_per_texel_ + 0.4 * now : now;
}

int QuickMaps::resolution(const SceneSnapshot& scene) {
  const int full = scene.quality.map.resolution;
  if (are_held(scene)) return full;
  SceneSnapshot other = scene;
  other.quality.map.resolution = held_scene_.quality.map.resolution;
  if (!held_.empty() && other.quality.map.resolution < full && are_held(other))
    return other.quality.map.resolution;
  if (ms_per_texel_ > 0.0) {
    const double wanted = std::sqrt(wanted_ms_ / ms_per_texel_);
    int best = 64;
    for (const int step : {96, 128, 192, 256})
      // Going up needs a margin that going down does not.
      if (step <= wanted * (step > most_ ? 0.85 : 1.0)) best = step;
    most_ = best;
  }
  return std::min(full, std::clamp(full / 2, 64, most_));
}

void QuickMaps::rendered(const SceneSnapshot& scene) {
  held_scene_ = scene;
  held_ = keys_of(scene);
}

}  // namespace plinian::window
