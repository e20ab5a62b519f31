#include "host/cli/swim.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/scene/framing.h"
#include "core/scene/placement.h"
#include "host/cli/renderers.h"

namespace plinian::cli {

namespace {

constexpr float media_alpha = 0.01f;  // [-] pixels with less show no medium

/// Frames of a movement as snapshots of their own.
std::vector<SceneSnapshot> movement(const SceneSnapshot& scene, bool orbit, const SwimOptions& options) {
  const dvec3 pivot = scene_bounds(scene.media).centre();
  std::vector<SceneSnapshot> frames;
  for (int i = 0; i < options.frames; ++i) {
    SceneSnapshot& frame = frames.emplace_back(scene);
    const dmat4 turned = turn(options.degrees * i, pivot);
    if (orbit) {
      frame.camera.world_from_camera = turned * frame.camera.world_from_camera;
    } else if (!frame.lights.empty()) {
      Light& key = frame.lights.front();
      key.toward = normalize(vec3(dmat3(turned) * dvec3(key.toward)));
      key.position = vec3(dvec3(turned * dvec4(dvec3(key.position), 1.0)));
    }
  }
  return frames;
}

bool shows_medium(const Frame& frame, std::size_t pixel) {
  const vec3 t = frame.transmittance[pixel];
  return 1.0f - (t.x + t.y + t.z) / 3.0f > media_alpha;
}

/// The larger of 1 and the 99.9th percentile, as in compare.
double peak_of(const Frame& frame) {
  std::vector<float> values;
  for (const vec3& v : frame.beauty) values.push_back(std::max({v.x, v.y, v.z}));
  const auto at = values.begin() + std::ptrdiff_t(0.999 * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return std::max(1.0, double(*at));
}

struct Difference {
  double sum = 0.0, largest = 0.0;
  std::size_t pixels = 0;
  void add(vec3 d) {
    ++pixels;
    sum += double(dot(d, d)) / 3.0;
    largest = std::max(largest, double(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)})));
  }
  double rms() const { return pixels > 0 ? std::sqrt(sum / double(pixels)) : 0.0; }
};

nlohmann::ordered_json decibels(double rms, double peak) {
  if (!(rms > 0.0)) return nullptr;  // identical
  return 20.0 * std::log10(peak / rms);
}

nlohmann::ordered_json judge(const std::vector<Frame>& pictures, const std::vector<Frame>& truths) {
  double worst_error = 0.0, worst_step = 0.0, largest = 0.0, peak = 1.0, ratio = 0.0;
  for (const Frame& truth : truths) peak = std::max(peak, peak_of(truth));
  for (std::size_t n = 0; n < truths.size(); ++n) {
    Difference error, step;
    for (std::size_t i = 0; i < truths[n].beauty.size(); ++i) {
      const vec3 here = pictures[n].beauty[i] - truths[n].beauty[i];
      if (shows_medium(truths[n], i)) error.add(here);
      if (n == 0 || !(shows_medium(truths[n], i) || shows_medium(truths[n - 1], i))) continue;
      step.add(here - (pictures[n - 1].beauty[i] - truths[n - 1].beauty[i]));
    }
    worst_error = std::max(worst_error, error.rms());
    worst_step = std::max(worst_step, step.rms());
    largest = std::max(largest, step.largest);
    if (error.rms() > 0.0) ratio = std::max(ratio, step.rms() / error.rms());
  }
  return {{"psnr", decibels(worst_error, peak)},
          {"psnr_step", decibels(worst_step, peak)},
          {"largest_step", largest},
          {"step_over_error", ratio}};
}

}  // namespace

dmat4 turn(double degrees, const dvec3& pivot) {
  dmat4 there(1.0), back(1.0);
  there[3] = dvec4(pivot, 1.0);
  back[3] = dvec4(-pivot, 1.0);
  return there * rotation_xyz({0.0, degrees, 0.0}) * back;
}

nlohmann::ordered_json measure_swim(const SceneSnapshot& scene, const std::vector<BenchQuality>& qualities,
                                    const SwimOptions& options, const std::function<bool(double)>& progress) {
  const double jobs = 2.0 * options.frames * double(qualities.size() + 1);
  double job = 0.0;
  const auto render = [&](Renderer& renderer, const std::vector<SceneSnapshot>& frames) {
    std::vector<Frame> pictures;
    for (const SceneSnapshot& frame : frames) {
      pictures.push_back(renderer.render(frame, options.passes,
                                         [&](double share) { return progress((job + share) / jobs); }));
      ++job;
    }
    return pictures;
  };

  const auto reference = make_renderer("reference", {.reference_tolerance = options.reference_tolerance});
  std::map<std::string, std::unique_ptr<Renderer>> renderers;
  nlohmann::ordered_json report = nlohmann::ordered_json::object();
  for (const bool orbit : {true, false}) {
    std::vector<SceneSnapshot> frames = movement(scene, orbit, options);
    const std::vector<Frame> truths = render(*reference, frames);
    for (const BenchQuality& one : qualities) {
      std::unique_ptr<Renderer>& renderer = renderers[one.renderer];
      if (!renderer) renderer = make_renderer(one.renderer);
      for (SceneSnapshot& frame : frames) frame.quality = one.quality;
      nlohmann::ordered_json& entry = report[one.renderer][one.name][orbit ? "orbit" : "key_turn"];
      entry = {{"frames", options.frames}, {"degrees", options.degrees}};
      entry.update(judge(render(*renderer, frames), truths));
    }
  }
  return report;
}

}  // namespace plinian::cli
