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

// How many of the wanted maps the held ones, map by map, do not serve.
int missing(const std::vector<MapKey>& held, const std::vector<MapKey>& wanted, float reuse) {
  if (held.size() != wanted.size()) return int(wanted.size());
  int count = 0;
  for (std::size_t i = 0; i < held.size(); ++i) count += !map_power(held[i], wanted[i], reuse);
  return count;
}

}  // namespace

std::optional<int> QuickMaps::serving(const SceneSnapshot& scene) const {
  const float reuse = scene.extinction_reuse;
  const std::vector<MapKey> wanted = keys_of(scene);
  if (missing(held_, wanted, reuse) == 0) return scene.quality.map.resolution;
  const int held = held_scene_.quality.map.resolution;
  if (held_.empty() || held >= scene.quality.map.resolution) return std::nullopt;
  SceneSnapshot other = scene;
  other.quality.map.resolution = held;
  return missing(held_, keys_of(other), reuse) == 0 ? std::optional(held) : std::nullopt;
}

int QuickMaps::builds(const SceneSnapshot& scene) const {
  SceneSnapshot other = scene;
  // The frame of a light depends on it.
  if (!held_.empty()) other.quality.map.resolution = held_scene_.quality.map.resolution;
  return missing(held_, keys_of(other), scene.extinction_reuse);
}

void QuickMaps::rendered(const SceneSnapshot& scene) {
  std::vector<MapKey> now = keys_of(scene);
  for (std::size_t i = 0; i < now.size() && now.size() == held_.size(); ++i)
    if (map_power(held_[i], now[i], scene.extinction_reuse)) now[i] = held_[i];
  held_ = std::move(now);
  held_scene_ = scene;
}

}  // namespace plinian::window
