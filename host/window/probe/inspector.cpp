// Probes the scene of the picture that is shown.
#include "host/window/probe/inspector.h"

#include <algorithm>
#include <utility>

namespace plinian::window {

namespace {

Inspection inspect(const Inspected& asked) {
  const SceneSnapshot& scene = asked.picture->scene;
  Inspection result;
  result.pixel = asked.pixel;
  result.threshold = scene.quality.map.threshold;
  try {
    const RayProbe probe(scene);
    for (const Light& light : scene.lights) result.lights.push_back(light.name);
    result.view = probe.view_ray(asked.pixel);
    if (result.view.samples.empty()) return result;
    result.t = asked.t.value_or(result.view.middle());
    if (result.lights.empty()) return result;
    const auto found = std::find(result.lights.begin(), result.lights.end(), asked.light);
    const auto index = found == result.lights.end() ? 0 : found - result.lights.begin();
    result.light = probe.light_ray(result.view.at(result.t), std::size_t(index));
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  return result;
}

}  // namespace

Inspector::Inspector(std::function<void()> wake) : worker_(inspect, std::move(wake)) {}

void Inspector::update(const ViewPicturePtr& picture) {
  if (!on && asked_number_ != 0) {
    asked_number_ = 0;
    worker_.forget();
  }
  if (!on || !place || !picture) return;
  const ivec2 size(picture->scene.width, picture->scene.height);
  const ivec2 pixel = glm::clamp(ivec2(*place * vec2(size)), ivec2(0), size - 1);
  if (picture->number == asked_number_ && pixel == asked_pixel_ && t == asked_t_ && light == asked_light_)
    return;
  asked_number_ = picture->number;
  asked_pixel_ = pixel;
  asked_t_ = t;
  asked_light_ = light;
  worker_.ask({picture, pixel, t, light});
}

}  // namespace plinian::window
