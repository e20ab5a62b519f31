#include "core/integrate/dual_march.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numeric>

namespace plinian {
namespace {

constexpr int agreements_needed = 2;  // doublings in a row that change nothing

/// Reports progress from any thread, one call at a time, never backwards; remembers that it was asked to
/// stop.
class ProgressGate {
 public:
  explicit ProgressGate(const Progress& report) : report_(report) {}
  void set(double done) {
    if (!report_ || cancelled_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || done <= last_) return;
    last_ = done;
    if (!report_(done)) cancelled_ = true;
  }
  bool cancelled() const { return cancelled_; }

 private:
  const Progress& report_;
  std::mutex mutex_;
  double last_ = -1.0;
  std::atomic<bool> cancelled_{false};
};

Frame make_frame(const SceneSnapshot& scene) {
  if (scene.width < 1 || scene.height < 1) throw std::invalid_argument("a picture needs at least one pixel");
  const std::size_t pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
  Frame frame;
  frame.width = scene.width;
  frame.height = scene.height;
  frame.depth.assign(pixels, 0.0f);
  for (auto* plane :
       {&frame.beauty, &frame.transmittance, &frame.ambient, &frame.emission, &frame.background})
    plane->assign(pixels, vec3(0.0f));
  for (const Light& light : scene.lights)
    frame.lights.push_back({light.name, std::vector<vec3>(pixels, vec3(0.0f))});
  return frame;
}

/// Writes a ray's result into a pixel. Returns the largest change of a layer's channel [radiance].
double store(const RayRadiance& ray, vec3 background, std::size_t pixel, Frame& frame, bool& finite) {
  double change = 0.0;
  dvec3 beauty(0.0);
  const auto put = [&](vec3& slot, dvec3 value) {
    for (int c = 0; c < 3; ++c) {
      if (!std::isfinite(value[c])) {
        value[c] = 0.0;
        finite = false;
      }
      change = glm::max(change, std::abs(value[c] - double(slot[c])));
    }
    slot = vec3(value);
    beauty += value;
  };
  put(frame.ambient[pixel], ray.ambient);
  put(frame.emission[pixel], ray.emission);
  put(frame.background[pixel], dvec3(background) * ray.transmittance);
  for (std::size_t l = 0; l < ray.lights.size(); ++l) put(frame.lights[l].radiance[pixel], ray.lights[l]);
  frame.beauty[pixel] = vec3(beauty);
  frame.transmittance[pixel] = vec3(ray.transmittance);
  frame.depth[pixel] = static_cast<float>(ray.depth);
  return change;
}

float brightest_channel(vec3 v) {
  return glm::max(v.x, glm::max(v.y, v.z));
}

/// The 99.9th percentile of the brightest channel: a few pixels at a bare lamp do not set the scale.
double peak(const Frame& frame) {
  std::vector<float> values(frame.beauty.size());
  std::transform(frame.beauty.begin(), frame.beauty.end(), values.begin(), brightest_channel);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.999 * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Pixels that are not settled or have such a neighbour.
std::vector<std::uint32_t> unsettled(const std::vector<std::uint8_t>& agreements, int width, int height) {
  std::vector<std::uint32_t> found;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      bool open = false;
      for (int v = glm::max(y - 1, 0); v <= glm::min(y + 1, height - 1); ++v)
        for (int u = glm::max(x - 1, 0); u <= glm::min(x + 1, width - 1); ++u)
          open |= agreements[static_cast<std::size_t>(v) * width + u] < agreements_needed;
      if (open) found.push_back(static_cast<std::uint32_t>(y) * width + x);
    }
  return found;
}

}  // namespace

DualMarch::DualMarch(const DualMarchOptions& options) : options_(options) {}

Frame DualMarch::render(const SceneSnapshot& scene, const Passes& /*passes*/, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Frame frame = make_frame(scene);
  const ReferenceScene march(scene, options_.steps);
  const CameraRays camera = camera_rays(scene.camera, scene.width, scene.height);
  const auto ray_through = [&](std::uint32_t pixel) {
    const double x = 2.0 * (pixel % scene.width + 0.5) / scene.width - 1.0;
    const double y = 1.0 - 2.0 * (pixel / scene.width + 0.5) / scene.height;
    return Ray{dvec3(camera.origin),
               glm::normalize(dvec3(camera.forward) + x * dvec3(camera.right) + y * dvec3(camera.up))};
  };

  pixels_per_level_.clear();
  stats_.begin_picture();
  ProgressGate gate(progress);
  std::atomic<std::int64_t> not_finite{0};
  std::vector<std::uint8_t> agreements(frame.beauty.size(), 0), exact(frame.beauty.size(), 0);
  std::vector<std::uint32_t> open(frame.beauty.size());
  std::iota(open.begin(), open.end(), 0u);
  double scale = 0.0, progress_before = 0.0;

  for (int level = 0; level <= options_.max_doublings && !open.empty(); ++level) {
    // The work of levels to come is not known: each may take half of what the bar has left.
    const double progress_after = level < 3 ? (level == 0   ? 0.1
                                               : level == 1 ? 0.3
                                                            : 0.8)
                                            : progress_before + 0.5 * (1.0 - progress_before);
    std::atomic<std::size_t> done{0};
    constexpr std::size_t grain = 32;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, open.size(), grain),
        [&](const tbb::blocked_range<std::size_t>& range) {
          RayIntegral integral(march);
          for (std::size_t i = range.begin(); i != range.end() && !gate.cancelled(); ++i) {
            const std::uint32_t pixel = open[i];
            const RayRadiance& radiance =
                integral.integrate(ray_through(pixel), double(scene.camera.near_clip), level);
            bool finite = true;
            const double change = store(radiance, scene.background, pixel, frame, finite);
            if (!finite) ++not_finite;
            if (radiance.empty) exact[pixel] = 1;
            if (level == 0) continue;
            const double brightness = glm::max(double(brightest_channel(frame.beauty[pixel])), scale);
            const bool agrees = change <= options_.tolerance * brightness;
            agreements[pixel] = agrees ? static_cast<std::uint8_t>(glm::min(agreements[pixel] + 1, 250)) : 0;
          }
          gate.set(progress_before +
                   (progress_after - progress_before) * double(done += range.size()) / double(open.size()));
        });
    if (gate.cancelled()) throw RenderCancelled();
    pixels_per_level_.push_back(static_cast<std::int64_t>(open.size()));
    progress_before = progress_after;
    if (level == 0) {
      scale = options_.dark_pixel * peak(frame);
      for (std::size_t p = 0; p < exact.size(); ++p)
        if (exact[p]) agreements[p] = agreements_needed;
    }
    open = unsettled(agreements, scene.width, scene.height);
  }

  const auto left =
      std::count_if(agreements.begin(), agreements.end(), [](auto a) { return a < agreements_needed; });
  if (left > 0)
    stats_.warnings.push_back(std::to_string(left) + " pixels had not settled after " +
                              std::to_string(options_.max_doublings) + " doublings of the reference's steps");
  if (not_finite > 0)
    stats_.warnings.push_back(std::to_string(not_finite) + " samples were not finite and read as black");
  stats_.passes = static_cast<int>(pixels_per_level_.size());
  stats_.view_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  gate.set(1.0);
  return frame;
}

}  // namespace plinian
