#include "core/scene/frame_layers.h"

#include <ctime>
#include <limits>

namespace plinian {

FrameSums::FrameSums(const SceneSnapshot& scene, std::size_t light_count) {
  const std::size_t pixels = std::size_t(scene.width) * scene.height;
  transmittance.assign(pixels, vec3(0.0f));
  ambient = emission = transmittance;
  depth.assign(pixels, 1e30f);
  lights.assign(light_count, transmittance);
}

void add_passes(FrameSums& sums, const FrameSums& more) {
  const auto add = [](std::vector<vec3>& to, const std::vector<vec3>& from) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
  };
  add(sums.transmittance, more.transmittance);
  add(sums.ambient, more.ambient);
  add(sums.emission, more.emission);
  for (std::size_t l = 0; l < sums.lights.size(); ++l) add(sums.lights[l], more.lights[l]);
}

Frame resolve(FrameSums sums, const SceneSnapshot& scene, int passes) {
  const std::size_t pixels = sums.depth.size();
  Frame frame;
  frame.width = scene.width;
  frame.height = scene.height;
  frame.beauty.assign(pixels, vec3(0.0f));
  const float share = 1.0f / float(passes);
  const auto mean = [&](std::vector<vec3>& sum, vec3 factor) {
    for (vec3& v : sum) v *= factor * share;
    return std::move(sum);
  };
  const auto add = [&](const std::vector<vec3>& layer) {
    for (std::size_t i = 0; i < pixels; ++i) frame.beauty[i] += layer[i];
  };
  frame.transmittance = mean(sums.transmittance, vec3(1.0f));
  frame.depth = std::move(sums.depth);
  for (float& d : frame.depth)
    if (d > 1e29f) d = std::numeric_limits<float>::infinity();
  frame.background.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) frame.background[i] = frame.transmittance[i] * scene.background;
  add(frame.background);
  add(frame.ambient = mean(sums.ambient, scene.ambient));
  add(frame.emission = mean(sums.emission, vec3(1.0f)));
  for (std::size_t l = 0; l < sums.lights.size(); ++l) {
    frame.lights.push_back({scene.lights[l].name, mean(sums.lights[l], vec3(1.0f))});
    add(frame.lights.back().radiance);
  }
  return frame;
}

Frame empty_frame(const SceneSnapshot& scene) {
  FrameSums sums(scene, scene.lights.size());
  for (vec3& t : sums.transmittance) t = vec3(1.0f);
  return resolve(std::move(sums), scene, 1);
}

double processor_milliseconds() {
  return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace plinian
