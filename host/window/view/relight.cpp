// Factors on layers.
#include "host/window/view/relight.h"

#include "host/window/view/same_picture.h"

namespace plinian::window {

namespace {

// What a layer is to be multiplied by; none where nothing can be told of it.
std::optional<vec3> factor(const vec3& before, const vec3& after) {
  vec3 result(1.0f);
  for (int c = 0; c < 3; ++c) {
    if (before[c] == after[c]) continue;
    if (!(before[c] > 0.0f)) return std::nullopt;
    result[c] = after[c] / before[c];
  }
  return result;
}

void add(std::vector<vec3>& sum, const std::vector<vec3>& layer) {
  for (std::size_t i = 0; i < sum.size() && i < layer.size(); ++i) sum[i] += layer[i];
}

void scale(std::vector<vec3>& layer, const vec3& by) {
  for (vec3& value : layer) value *= by;
}

}  // namespace

std::optional<Frame> relit(const Frame& frame, const SceneSnapshot& scene, const SceneSnapshot& wanted) {
  if (scene.lights.size() != wanted.lights.size() || frame.lights.size() != scene.lights.size())
    return std::nullopt;
  SceneSnapshot otherwise = wanted;
  otherwise.ambient = scene.ambient;
  const std::optional<vec3> ambient = factor(scene.ambient, wanted.ambient);
  if (!ambient) return std::nullopt;
  std::vector<vec3> factors;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto by = factor(scene.lights[i].power(), wanted.lights[i].power());
    if (!by) return std::nullopt;
    factors.push_back(*by);
    otherwise.lights[i].colour = scene.lights[i].colour;
    otherwise.lights[i].intensity = scene.lights[i].intensity;
    otherwise.lights[i].exposure = scene.lights[i].exposure;
  }
  if (!same_picture(scene, otherwise)) return std::nullopt;
  // How far maps are off does not depend on how bright lights are.
  if (scene.quality.view.light == LightLookup::error) return frame;
  Frame result = frame;
  scale(result.ambient, *ambient);
  result.beauty.assign(frame.beauty.size(), vec3(0.0f));
  for (std::size_t i = 0; i < factors.size(); ++i) {
    scale(result.lights[i].radiance, factors[i]);
    add(result.beauty, result.lights[i].radiance);
  }
  for (const auto* layer : {&result.ambient, &result.emission, &result.background})
    add(result.beauty, *layer);
  return result;
}

}  // namespace plinian::window
