#include "host/cli/timing.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/scene/framing.h"
#include "core/scene/preset.h"
#include "host/cli/console.h"
#include "host/cli/interruption.h"
#include "host/cli/machine.h"
#include "host/cli/renderers.h"

namespace plinian::cli {

using nlohmann::ordered_json;

namespace {

using Clock = std::chrono::steady_clock;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const std::size_t half = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// One renderer with one quality, its scene, and what was measured of it, by name.
struct Contestant {
  std::string renderer_name, quality_name;
  std::unique_ptr<Renderer> renderer;
  SceneSnapshot scene;
  bool marches_to_light = false;                     // in place of maps: only its orbit frame means anything
  std::map<std::string, std::vector<double>> times;  // [ms], one per run
  std::map<std::string, std::int64_t> map_builds;    // over all runs
  RenderStats last;
};

class Timing {
 public:
  Timing(const SceneSnapshot& scene, const std::vector<BenchQuality>& qualities, const TimingOptions& options)
      : options_(options), scene_(scene), pivot_(scene_bounds(scene_.media).centre()) {
    for (const bool marches : {false, true})
      for (const BenchQuality& quality : qualities)
        if (!skipped_.contains(quality.renderer)) add(quality, marches);
    if (contestants_.empty()) throw std::runtime_error("no renderer runs on this machine");
  }

  void run(const std::function<bool(double)>& progress) {
    const double rounds = options_.runs + 1;
    double done = 0.0;
    for (Contestant& one : contestants_) {  // compiles shaders, uploads volumes, fills caches
      one.renderer->render(one.scene, options_.passes, [&](double) { return progress(0.0); });
      if (!progress(done += 1.0 / (rounds * double(contestants_.size())))) throw RenderCancelled();
    }
    for (int i = 1; i <= options_.runs; ++i) {
      const auto step = [&] {
        if (!progress(1.0 / rounds + (i - 1) / rounds)) throw RenderCancelled();
      };
      each("orbit_frame_ms", step, [&](SceneSnapshot& scene) {
        scene.camera.world_from_camera = turn(1.0 * i, pivot_) * scene.camera.world_from_camera;
      });
      if (!options_.against.empty()) run_against();
      each("albedo_edit_ms", step, [&](SceneSnapshot& scene) {
        for (Medium& medium : scene.media) {
          const vec3 sigma_t = medium.sigma_s + medium.sigma_a;
          medium.sigma_s = sigma_t * 0.6f;
          medium.sigma_a = sigma_t - medium.sigma_s;
        }
      });
      each("extinction_edit_ms", step, [&](SceneSnapshot& scene) {
        for (Medium& medium : scene.media) medium.density_scale *= 1.5f;
      });
      each("light_edit_ms", step, [&](SceneSnapshot& scene) {
        const dmat4 turned = turn(2.0 * i, pivot_);
        for (Light& light : scene.lights) {
          light.toward = normalize(vec3(dmat3(turned) * dvec3(light.toward)));
          light.position = vec3(dvec3(turned * dvec4(dvec3(light.position), 1.0)));
        }
      });
      // A new volume of the same size, as the next frame of a sequence would be. It stays, and its maps with
      // it, so that the next orbit frame finds everything in place.
      std::vector<std::shared_ptr<const BrickVolume>> next;
      for (const Medium& medium : scene_.media)
        next.push_back(medium.volume ? std::make_shared<const BrickVolume>(*medium.volume) : nullptr);
      const auto replace = [&](SceneSnapshot& scene) {
        for (std::size_t m = 0; m < scene.media.size(); ++m) scene.media[m].volume = next[m];
      };
      each("frame_change_ms", step, replace);
      for (Contestant& one : contestants_)
        if (!one.marches_to_light) replace(one.scene);
    }
  }

  ordered_json report() const {
    ordered_json renderers = ordered_json::object(), builds = ordered_json::object();
    for (const Contestant& one : contestants_) {
      ordered_json& entry = renderers[one.renderer_name];
      if (one.marches_to_light) {
        // The march under the first preset's view march is the one that stands under the plain key.
        ordered_json& march = entry["dual_march"];
        const double time = median(one.times.at("orbit_frame_ms"));
        if (march.is_null()) march["orbit_frame_ms"] = time;
        march["orbit_frame_ms_" + one.quality_name] = time;
        continue;
      }
      ordered_json& preset = entry[one.quality_name];
      preset["map_build_ms"] = median(one.times.at("map_build_ms"));
      for (const char* edit :
           {"orbit_frame_ms", "albedo_edit_ms", "extinction_edit_ms", "light_edit_ms", "frame_change_ms"})
        preset[edit] = median(one.times.at(edit));
      preset["volume_bytes"] = one.last.volume_bytes;
      preset["map_bytes"] = one.last.map_bytes;
      builds[one.renderer_name][one.quality_name] = one.map_builds;
    }
    ordered_json report = {{"machine", machine_name()},
                           {"renderers", renderers},
                           {"ratios", ratios()},
                           {"map_builds", builds},
                           {"skipped", skipped_}};
    if (!against_ms_.empty())
      report["against"] = {{"command", options_.against}, {"ms", median(against_ms_)}};
    return report;
  }

 private:
  void add(const BenchQuality& quality, bool marches) {
    Contestant one;
    one.renderer_name = quality.renderer;
    one.quality_name = quality.name;
    one.scene = scene_;
    one.scene.quality = quality.quality;
    one.marches_to_light = marches;
    if (marches && !set_quality(one.scene.quality, "view.light", "march")) return;
    try {
      one.renderer = make_renderer(quality.renderer);
    } catch (const std::runtime_error& reason) {
      skipped_[quality.renderer] = reason.what();
      warn(fmt::format("{} is left out: {}", quality.renderer, reason.what()));
      return;
    }
    contestants_.push_back(std::move(one));
  }

  // Makes one edit to every contestant's scene in turn and times the frame that shows it. Edits do not add
  // up: after an extinction edit, the light edit's map is of the scene's own extinction again.
  void each(const std::string& what, const std::function<void()>& step,
            const std::function<void(SceneSnapshot&)>& edit) {
    for (Contestant& one : contestants_) {
      if (one.marches_to_light && what != "orbit_frame_ms") continue;
      step();
      SceneSnapshot edited = one.scene;
      edit(edited);
      const std::int64_t builds = one.renderer->stats().map_builds;
      const auto start = Clock::now();
      one.renderer->render(edited, options_.passes, [](double) { return !interrupted(); });
      one.times[what].push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
      one.last = one.renderer->stats();
      one.map_builds[what.substr(0, what.size() - 3)] += one.last.map_builds - builds;
      if (what == "light_edit_ms") one.times["map_build_ms"].push_back(one.last.map_ms);
    }
  }

  void run_against() {
    const auto start = Clock::now();
    const int status = std::system(("(" + options_.against + ") >/dev/null 2>&1").c_str());
    against_ms_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    if (status != 0)
      throw std::runtime_error(fmt::format("--against: '{}' ended with {} {}", options_.against,
                                           WIFEXITED(status) ? "exit code" : "signal",
                                           WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status)));
  }

  // Medians over the runs of the ratio within each run.
  ordered_json ratios() const {
    ordered_json result = ordered_json::object();
    const auto find = [&](const std::string& renderer, const std::string& preset,
                          bool marches) -> const Contestant* {
      for (const Contestant& one : contestants_)
        if (one.renderer_name == renderer && one.quality_name == preset && one.marches_to_light == marches)
          return &one;
      return nullptr;
    };
    const auto ratio = [](const std::vector<double>& over, const std::vector<double>& under) {
      std::vector<double> each;
      for (std::size_t i = 0; i < std::min(over.size(), under.size()); ++i)
        each.push_back(over[i] / under[i]);
      return median(each);
    };
    for (const Contestant& one : contestants_) {
      if (one.marches_to_light) continue;
      const std::string name = one.renderer_name + "." + one.quality_name;
      const auto& orbit = one.times.at("orbit_frame_ms");
      if (const auto* march = find(one.renderer_name, one.quality_name, true))
        result[name + ".dual_march_over_orbit_frame"] = ratio(march->times.at("orbit_frame_ms"), orbit);
      if (const auto* other = one.renderer_name == "gl" ? find("cpu", one.quality_name, false) : nullptr)
        result[name + ".cpu_over_orbit_frame"] = ratio(other->times.at("orbit_frame_ms"), orbit);
      if (!against_ms_.empty()) {
        result[name + ".against_over_orbit_frame"] = ratio(against_ms_, orbit);
        result[name + ".against_over_light_edit"] = ratio(against_ms_, one.times.at("light_edit_ms"));
      }
    }
    return result;
  }

  const TimingOptions& options_;
  const SceneSnapshot& scene_;
  dvec3 pivot_;
  std::vector<Contestant> contestants_;
  std::vector<double> against_ms_;
  std::map<std::string, std::string> skipped_;
};

}  // namespace

ordered_json measure_times(const SceneSnapshot& scene, const std::vector<BenchQuality>& qualities,
                           const TimingOptions& options, const std::function<bool(double)>& progress) {
  Timing timing(scene, qualities, options);
  timing.run(progress);
  return timing.report();
}

}  // namespace plinian::cli
