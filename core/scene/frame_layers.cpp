#include "core/scene/frame_layers.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <ctime>
#include <limits>

namespace plinian {
namespace {

template <class Action>
void for_pixels(std::size_t pixels, const Action& action) {
  constexpr std::size_t block = 4096;
  tbb::parallel_for(std::size_t(0), (pixels + block - 1) / block, [&](std::size_t b) {
    for (std::size_t i = b * block, end = std::min(pixels, i + block); i < end; ++i) action(i);
  });
}

}  // namespace

FrameSums::FrameSums(const SceneSnapshot& scene, std::size_t light_count) {
  const std::size_t pixels = std::size_t(scene.width) * scene.height;
  transmittance.assign(pixels, vec3(0.0f));
  ambient = emission = transmittance;
  depth.assign(pixels, 1e30f);
  lights.assign(light_count, transmittance);
}

void set_media_plane(FrameSums& sums, int width, PixelBox box, const std::vector<vec4>& plane, float weight) {
  for_pixels(sums.depth.size(), [&](std::size_t i) { sums.transmittance[i] = vec3(weight); });
  tbb::parallel_for(0, box.size.y, [&](int y) {
    const vec4* from = plane.data() + std::size_t(y) * box.size.x;
    const std::size_t first = std::size_t(box.first.y + y) * width + box.first.x;
    for (int x = 0; x < box.size.x; ++x) {
      sums.transmittance[first + x] = vec3(from[x]);
      sums.depth[first + x] = from[x].w;
    }
  });
}

void add_plane(std::vector<vec3>& layer, int width, PixelBox box, const std::vector<vec4>& plane) {
  tbb::parallel_for(0, box.size.y, [&](int y) {
    const vec4* from = plane.data() + std::size_t(y) * box.size.x;
    vec3* to = layer.data() + std::size_t(box.first.y + y) * width + box.first.x;
    for (int x = 0; x < box.size.x; ++x) to[x] += vec3(from[x]);
  });
}

void add_passes(FrameSums& sums, const FrameSums& more) {
  const auto add = [](std::vector<vec3>& to, const std::vector<vec3>& from) {
    for_pixels(to.size(), [&](std::size_t i) { to[i] += from[i]; });
  };
  add(sums.transmittance, more.transmittance);
  add(sums.ambient, more.ambient);
  add(sums.emission, more.emission);
  for (std::size_t l = 0; l < sums.lights.size(); ++l) add(sums.lights[l], more.lights[l]);
}

Frame resolve(FrameSums sums, const SceneSnapshot& scene, float weight) {
  const std::size_t pixels = sums.depth.size();
  Frame frame;
  frame.width = scene.width;
  frame.height = scene.height;
  frame.beauty.resize(pixels);
  frame.background.resize(pixels);
  const float share = 1.0f / weight;
  for_pixels(pixels, [&](std::size_t i) {
    const auto mean = [&](vec3& sum, vec3 factor) {
      sum *= factor * share;
      return sum;
    };
    vec3 beauty = frame.background[i] = mean(sums.transmittance[i], vec3(1.0f)) * scene.background;
    beauty += mean(sums.ambient[i], scene.ambient);
    beauty += mean(sums.emission[i], vec3(1.0f));
    for (std::vector<vec3>& light : sums.lights) beauty += mean(light[i], vec3(1.0f));
    frame.beauty[i] = beauty;
    if (sums.depth[i] > 1e29f) sums.depth[i] = std::numeric_limits<float>::infinity();
  });
  frame.transmittance = std::move(sums.transmittance);
  frame.ambient = std::move(sums.ambient);
  frame.emission = std::move(sums.emission);
  frame.depth = std::move(sums.depth);
  for (std::size_t l = 0; l < sums.lights.size(); ++l)
    frame.lights.push_back({scene.lights[l].name, std::move(sums.lights[l])});
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
