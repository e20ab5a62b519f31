#include "core/integrate/reference_scene.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/shared/light_falloff.h"

namespace plinian {
namespace {

ReferenceScene::LightOptics prepare(const Light& light) {
  const float outer = glm::radians(glm::clamp(0.5f * light.cone_angle, 0.0f, 180.0f));
  const float inner = glm::max(outer - glm::radians(light.penumbra), 0.0f);
  const dvec3 power(light.power());
  if (light.type != LightType::point && !(glm::length(light.toward) > 0.0f))
    throw std::invalid_argument("light '" + light.name + "': its direction `toward` has no length");
  return {.type = light.type,
          .power = power,
          .toward = light.type == LightType::point ? dvec3(0, 1, 0) : glm::normalize(dvec3(light.toward)),
          .position = dvec3(light.position),
          .falloff = static_cast<int>(light.falloff),
          .radius = glm::max(light.radius, 0.0f),
          .cos_inner = std::cos(double(inner)),
          .cos_outer = std::cos(double(outer)),
          .inner_squared_chord = shared::squared_chord(inner),
          .outer_squared_chord = shared::squared_chord(outer),
          .dark = power == dvec3(0.0)};
}

}  // namespace

ReferenceScene::ReferenceScene(const SceneSnapshot& scene, const MarchSteps& steps)
    : ambient(scene.ambient), steps(steps) {
  for (const Medium& medium : scene.media) {
    const dvec3 extinction = double(medium.density_scale) * (dvec3(medium.sigma_s) + dvec3(medium.sigma_a));
    media.push_back({.walk = MediumWalk(medium),
                     .extinction = extinction,
                     .scattering = double(medium.density_scale) * dvec3(medium.sigma_s),
                     .emission = double(medium.density_scale) * double(medium.emission.scale) *
                                 std::exp2(double(medium.emission.exposure)),
                     .weakest_extinction = glm::min(extinction.x, glm::min(extinction.y, extinction.z)),
                     .phase = medium.phase,
                     .temperature_scale = medium.emission.temperature_scale,
                     .temperature_offset = medium.emission.temperature_offset});
  }
  for (const Light& light : scene.lights) lights.push_back(prepare(light));
}

dvec3 ReferenceScene::transmittance(const Ray& ray, double distance) const {
  dvec3 tau(0.0);
  for (const MediumOptics& medium : media) {
    // Every channel has to be past the cut-off before the ray may end.
    const double left = steps.light_cutoff - glm::min(tau.x, glm::min(tau.y, tau.z));
    if (left < 0.0) break;
    if (medium.extinction == dvec3(0.0)) continue;
    // Zero extinction in a channel divides to infinity: that channel never ends the ray.
    tau += medium.extinction * medium.walk.integral(ray, 0.0, distance, left / medium.weakest_extinction);
  }
  return glm::exp(-tau);
}

ReferenceScene::Arrival ReferenceScene::arrival(const LightOptics& light, dvec3 point) const {
  if (light.type == LightType::directional)
    return {light.power * transmittance({point, light.toward}, std::numeric_limits<double>::infinity()),
            light.toward};
  const dvec3 way = light.position - point;
  const double distance = glm::length(way);
  const dvec3 toward = distance > 0.0 ? way / distance : light.toward;
  double share = shared::distance_falloff(light.falloff, static_cast<float>(distance), light.radius);
  if (light.type == LightType::spot)
    share *= shared::spot_edge(vec3(-light.toward), vec3(-toward), light.inner_squared_chord,
                               light.outer_squared_chord);
  if (share == 0.0) return {dvec3(0.0), toward};
  return {light.power * share * transmittance({point, toward}, distance), toward};
}

}  // namespace plinian
