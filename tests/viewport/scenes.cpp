#include "tests/viewport/scenes.h"

#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "core/image/image.h"
#include "core/scene/preset.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_loader.h"

namespace plinian::test {
namespace {

const std::string root = PLINIAN_SOURCE_DIR;

}  // namespace

Quality shipped_preset(const std::string& name) {
  return load_preset(root + "/presets/" + name + ".json", {}).quality;
}

SceneSnapshot ash_scene(int resolution, int size) {
  SceneDescription description = describe_input("ash");
  set_scene_value(description, "medium.resolution", std::to_string(resolution));
  SceneLoadOptions options;
  options.width = options.height = size;
  SceneSnapshot scene = load_scene(description, options).snapshot;
  scene.width = scene.height = size;
  scene.quality = shipped_preset("fast");
  return scene;
}

bool shared_files_here() {
  return std::filesystem::exists(root + "/../shared/peers/scenes/smoke-dense.json");
}

SceneSnapshot shared_scene(const std::string& name, int size) {
  const bool neutral = name.ends_with(".json");
  SceneSnapshot scene =
      load_scene(describe_input(root + (neutral ? "/../shared/peers/scenes/" : "/../shared/data/") + name))
          .snapshot;
  scene.width = scene.height = size;
  scene.quality = shipped_preset("fast");
  return scene;
}

SceneSnapshot fire_scene(int size) {
  SceneSnapshot scene = shared_scene("densityAndHeat.vdb", size);
  scene.media[0].density_scale = 0.5f;
  scene.media[0].emission.scale = 10.0f;
  for (Light& light : scene.lights) light.exposure -= 2.0f;
  scene.background = vec3(0.0f);
  return scene;
}

SceneSnapshot analytic_scene(int size) {
  SceneSnapshot scene;
  Medium ball;
  ball.name = "ball";
  ball.shape = MediumShape::sphere;
  ball.density_scale = 20.0f;
  scene.media.push_back(ball);
  Medium haze;
  haze.name = "haze";
  haze.shape = MediumShape::box;
  haze.world_from_medium = glm::scale(dmat4(1.0), dvec3(3.0));
  haze.sigma_s = {0.04f, 0.05f, 0.06f};
  haze.sigma_a = vec3(0.01f);
  scene.media.push_back(haze);
  Light key;
  key.name = "key";
  key.toward = glm::normalize(vec3(0.6f, 0.7f, 0.3f));
  key.intensity = 12.566f;
  scene.lights.push_back(key);
  Light lamp;
  lamp.name = "lamp";
  lamp.type = LightType::point;
  lamp.position = {-2.0f, 0.5f, 1.0f};
  lamp.intensity = 20.0f;
  lamp.radius = 0.1f;
  scene.lights.push_back(lamp);
  scene.camera = look_at({2, 1, 7}, {0, 0, 0}, {0, 1, 0}, 40.0);
  scene.ambient = vec3(0.02f);
  scene.background = {0.01f, 0.02f, 0.03f};
  scene.width = scene.height = size;
  scene.quality = shipped_preset("fast");
  scene.quality.map.resolution = 128;  // a ball and a box ask for no more
  return scene;
}

PixelMetrics compare(const Frame& picture, const Frame& reference) {
  return pixel_metrics(pair_pictures(frame_to_image(picture), frame_to_image(reference)));
}

double structural_similarity(const Frame& picture, const Frame& reference) {
  const PicturePair pair = pair_pictures(frame_to_image(picture), frame_to_image(reference));
  return ssim(pair, peak_of(pair));
}

double largest_difference(const Frame& a, const Frame& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.beauty.size(); ++i)
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(double(a.beauty[i][c]) - b.beauty[i][c]));
  return largest;
}

bool all_finite(const Frame& frame) {
  const auto finite = [](const std::vector<vec3>& layer) {
    for (const vec3& v : layer)
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return false;
    return true;
  };
  bool all =
      finite(frame.beauty) && finite(frame.transmittance) && finite(frame.ambient) && finite(frame.emission);
  for (const LightLayer& light : frame.lights) all = all && finite(light.radiance);
  for (const float d : frame.depth) all = all && !std::isnan(d);
  return all;
}

}  // namespace plinian::test
