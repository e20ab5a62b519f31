// Lights in plain C.
#include "host/draw/draw_lights.h"

#include <algorithm>
#include <utility>

namespace plinian::draw {

namespace {

void copy(const vec3& from, float (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

PlinianDrawLight plain(const DrawLight& from) {
  PlinianDrawLight light{};
  light.size = sizeof(light);
  light.name = from.light.name.c_str();
  light.type = std::uint32_t(from.light.type);
  copy(from.light.toward, light.toward);
  copy(from.light.position, light.position);
  copy(from.light.power(), light.power);
  light.falloff = std::uint32_t(from.light.falloff);
  light.radius = from.light.radius;
  light.cone_angle = from.light.cone_angle;
  light.penumbra = from.light.penumbra;
  return light;
}

PlinianLightMap plain(const GlLightMap& from) {
  return {sizeof(PlinianLightMap), from.glsl->c_str(), from.texels, from.block, from.light};
}

}  // namespace

std::vector<DrawLight> lights_of(const SceneSnapshot& scene, const std::vector<GlLightMap>& maps) {
  std::vector<DrawLight> lights;
  for (const Light& light : scene.lights) lights.push_back({light});
  for (std::size_t i = 0; i < std::min(lights.size(), maps.size()); ++i) lights[i].map = maps[i];
  return lights;
}

PlainLights::PlainLights(std::vector<DrawLight> lights) : from_(std::move(lights)) {
  maps_.reserve(from_.size());  // they stay where they are
  for (const DrawLight& light : from_) {
    lights_.push_back(plain(light));
    if (light.map.glsl) maps_.push_back(plain(light.map));
    map_of_light_.push_back(light.map.glsl ? &maps_.back() : nullptr);
  }
}

void PlainLights::put_into(PlinianDrawContext& context) const {
  context.lights = lights_.data();
  context.light_count = lights_.size();
  context.light_maps = map_of_light_.data();
}

}  // namespace plinian::draw
