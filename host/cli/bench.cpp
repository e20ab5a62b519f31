// plinian bench: what maps, frames and edits cost on this machine. Everything is measured in turn within one
// run, because absolute times move from run to run; medians, and ratios of what was measured side by side.
#include <fmt/format.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/scene/framing.h"
#include "core/scene/preset.h"
#include "core/scene/scene_loader.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/prepared_scene.h"
#include "host/cli/progress.h"
#include "host/cli/renderers.h"
#include "host/cli/scene_arguments.h"
#include "host/cli/swim.h"

namespace plinian::cli {

using nlohmann::ordered_json;

namespace {

struct BenchArguments {
  SceneArguments scene;
  std::vector<std::string> renderers = {"gl", "cpu"}, presets = {"fast", "high"};
  int runs = 5, samples = 1;
  int swim_frames = 0;  // 0: times, not errors
  double swim_degrees = 1.0;
  std::string against;
  bool json = false, quiet = false;
};

constexpr const char* examples = R"(
Examples:
  plinian bench ash
  plinian bench smoke.json --size 512x512 --runs 9 --json
  plinian bench ash --resolution 128 --size 128x128 --swim 4
  plinian bench smoke.json --against 'vdb_render smoke.vdb /tmp/out.exr -res 512x512'
What is timed: an orbit frame (the camera moves, maps are kept); an albedo edit; an extinction edit and a light edit
(maps are rebuilt); a frame change (a new volume of the same kind); and, for comparison, the same view march with a
march to the light instead of the maps. One jittered pass each. With --swim nothing is timed: every frame of a small
orbit and of a turn of the first light is held against the reference, and so is the change of that error from one
frame to the next.)";

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

class Bench {
 public:
  Bench(const BenchArguments& arguments, SceneSnapshot scene)
      : arguments_(arguments), scene_(std::move(scene)), pivot_(scene_bounds(scene_.media).centre()) {
    for (const std::string& renderer : arguments.renderers) try {
        add_renderer(renderer);
      } catch (const std::runtime_error& reason) {
        skipped_[renderer] = reason.what();
        warn(fmt::format("{} is left out: {}", renderer, reason.what()));
      }
    if (contestants_.empty()) throw std::runtime_error("no renderer runs on this machine");
  }

  void run() {
    ProgressBar bar("timing");
    const double rounds = arguments_.runs + 1;
    double done = 0.0;
    for (Contestant& one : contestants_) {  // compiles shaders, uploads volumes, fills caches
      one.renderer->render(one.scene, arguments_.samples, [&](double) { return bar(0.0); });
      if (!bar(done += 1.0 / (rounds * double(contestants_.size())))) throw RenderCancelled();
    }
    for (int i = 1; i <= arguments_.runs; ++i) {
      const auto step = [&] {
        if (!bar(1.0 / rounds + (i - 1) / rounds)) throw RenderCancelled();
      };
      each("orbit_frame_ms", step, [&](SceneSnapshot& scene) {
        scene.camera.world_from_camera = turn(1.0 * i, pivot_) * scene.camera.world_from_camera;
      });
      if (!arguments_.against.empty()) run_against();
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
    ordered_json report = {{"scene", arguments_.scene.input},
                           {"size", {scene_.width, scene_.height}},
                           {"runs", arguments_.runs},
                           {"samples", arguments_.samples},
                           {"machine", machine()},
                           {"renderers", renderers},
                           {"ratios", ratios()},
                           {"map_builds", builds},
                           {"skipped", skipped_}};
    if (!against_ms_.empty())
      report["against"] = {{"command", arguments_.against}, {"ms", median(against_ms_)}};
    return report;
  }

 private:
  void add_renderer(const std::string& name) {
    std::vector<Contestant> made;
    const auto add = [&](const std::string& preset, Quality quality, bool marches) {
      Contestant& one = made.emplace_back();
      one.renderer_name = name;
      one.quality_name = preset;
      one.renderer = make_renderer(name);
      one.scene = scene_;
      one.scene.quality = std::move(quality);
      one.marches_to_light = marches;
    };
    for (const std::string& preset : arguments_.presets)
      add(preset, prepare_quality(arguments_.scene, preset), false);
    for (const std::string& preset : arguments_.presets) {
      Quality march = prepare_quality(arguments_.scene, preset);
      if (set_quality(march, "view.light", "march")) add(preset, march, true);
    }
    for (Contestant& one : made) contestants_.push_back(std::move(one));
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
      one.renderer->render(edited, arguments_.samples, [](double) { return !interrupted(); });
      one.times[what].push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
      one.last = one.renderer->stats();
      one.map_builds[what.substr(0, what.size() - 3)] += one.last.map_builds - builds;
      if (what == "light_edit_ms") one.times["map_build_ms"].push_back(one.last.map_ms);
    }
  }

  void run_against() {
    const auto start = Clock::now();
    const int status = std::system(("(" + arguments_.against + ") >/dev/null 2>&1").c_str());
    against_ms_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    if (status != 0)
      throw std::runtime_error(fmt::format("--against: '{}' ended with {} {}", arguments_.against,
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

  static std::string machine() {
    std::ifstream file("/proc/cpuinfo");
    std::string line, model = "unknown processor";
    while (std::getline(file, line))
      if (line.starts_with("model name")) {
        model = line.substr(line.find(':') + 2);
        break;
      }
    return fmt::format("{}, {} cores", model, std::thread::hardware_concurrency());
  }

  const BenchArguments& arguments_;
  SceneSnapshot scene_;
  dvec3 pivot_;
  std::vector<Contestant> contestants_;
  std::vector<double> against_ms_;
  std::map<std::string, std::string> skipped_;
};

void print_table(const ordered_json& report) {
  std::string text =
      fmt::format("{} at {}x{}, {}, median of {} runs [ms]\n\n", report["scene"].get<std::string>(),
                  report["size"][0].get<int>(), report["size"][1].get<int>(),
                  report["machine"].get<std::string>(), report["runs"].get<int>());
  text += fmt::format("  {:<16}{:>10}{:>10}{:>10}{:>12}{:>10}{:>14}{:>12}{:>12}\n", "", "map build", "orbit",
                      "albedo", "extinction", "light", "frame change", "volume", "maps");
  for (const auto& [renderer, presets] : report["renderers"].items())
    for (const auto& [preset, times] : presets.items()) {
      if (!times.contains("map_build_ms")) {
        const std::string start = "orbit_frame_ms_";
        for (const auto& [key, time] : times.items())
          if (key.starts_with(start))
            text += fmt::format("  {:<26}{:>10.1f}\n", renderer + " march, " + key.substr(start.size()),
                                time.get<double>());
        continue;
      }
      text += fmt::format("  {:<16}", renderer + " " + preset);
      const auto time = [&](const char* key) { return times[key].get<double>(); };
      text += fmt::format("{:>10.1f}{:>10.1f}{:>10.1f}{:>12.1f}{:>10.1f}{:>14.1f}{:>12}{:>12}\n",
                          time("map_build_ms"), time("orbit_frame_ms"), time("albedo_edit_ms"),
                          time("extinction_edit_ms"), time("light_edit_ms"), time("frame_change_ms"),
                          bytes_text(time("volume_bytes")), bytes_text(time("map_bytes")));
    }
  if (report.contains("against"))
    text += fmt::format("\n  {}: {:.1f}\n", report["against"]["command"].get<std::string>(),
                        report["against"]["ms"].get<double>());
  if (!report["ratios"].empty()) text += "\nRatios, run by run:\n";
  for (const auto& [name, ratio] : report["ratios"].items())
    text += fmt::format("  {:<40}{:>8.2f}\n", name, ratio.get<double>());
  print(text);
}

void print_swim(const ordered_json& report) {
  const auto decibels = [](const ordered_json& value) {
    return value.is_null() ? std::string("identical") : fmt::format("{:.2f} dB", value.get<double>());
  };
  std::string text =
      fmt::format("{} at {}x{}, worst of {} frames {} degrees apart\n\n  {:<26}{:>12}{:>14}{:>14}{:>16}\n",
                  report["scene"].get<std::string>(), report["size"][0].get<int>(),
                  report["size"][1].get<int>(), report["frames"].get<int>(), report["degrees"].get<double>(),
                  "", "frame", "its change", "largest", "change / error");
  for (const auto& [renderer, presets] : report["swim"].items())
    for (const auto& [preset, movements] : presets.items())
      for (const auto& [movement, worst] : movements.items())
        text += fmt::format(
            "  {:<26}{:>12}{:>14}{:>14.4f}{:>16.2f}\n",
            fmt::format("{} {}, {}", renderer, preset, movement == "orbit" ? "orbit" : "key turn"),
            decibels(worst["psnr"]), decibels(worst["psnr_step"]), worst["largest_step"].get<double>(),
            worst["step_over_error"].get<double>());
  print(text);
}

int run_swim(const BenchArguments& arguments, const SceneSnapshot& scene) {
  std::vector<SwimQuality> qualities;
  for (const std::string& renderer : arguments.renderers)
    for (const std::string& preset : arguments.presets)
      qualities.push_back({renderer, preset, prepare_quality(arguments.scene, preset)});
  ordered_json report = {{"scene", arguments.scene.input},
                         {"size", {scene.width, scene.height}},
                         {"frames", arguments.swim_frames},
                         {"degrees", arguments.swim_degrees},
                         {"samples", arguments.samples}};
  {
    ProgressBar bar("comparing");
    report["swim"] = measure_swim(
        scene, qualities,
        {.frames = arguments.swim_frames, .degrees = arguments.swim_degrees, .passes = arguments.samples},
        [&](double share) { return bar(share); });
  }
  if (arguments.json)
    print(report.dump(2) + "\n");
  else
    print_swim(report);
  return exit_success;
}

int run_bench(const BenchArguments& arguments) {
  set_quiet(arguments.quiet);
  PreparedScene scene = prepare_scene(arguments.scene);
  if (arguments.swim_frames > 0) return run_swim(arguments, scene.snapshot);
  Bench bench(arguments, std::move(scene.snapshot));
  bench.run();
  const ordered_json report = bench.report();
  if (arguments.json)
    print(report.dump(2) + "\n");
  else
    print_table(report);
  return exit_success;
}

}  // namespace

Run set_up_bench(CLI::App& app) {
  auto arguments = std::make_shared<BenchArguments>();
  app.footer(examples);
  add_scene_arguments(app, arguments->scene, false);
  app.add_option("--preset", arguments->presets, "which to time; may be repeated")
      ->type_name("NAME|FILE")
      ->allow_extra_args(false)
      ->capture_default_str()
      ->group("Quality");
  app.add_option("--renderer", arguments->renderers, "which to time: gl, cpu; may be repeated")
      ->check(CLI::IsMember({"gl", "cpu"}))
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->capture_default_str();
  app.add_option("--runs", arguments->runs, "medians are over so many")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--passes,--samples", arguments->samples, "jittered passes of each frame")
      ->type_name("N")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  app.add_option("--against", arguments->against,
                 "another program's command line, run in turn with the orbit frames")
      ->type_name("COMMAND");
  app.add_option("--swim", arguments->swim_frames,
                 "hold so many frames of an orbit and of a turn of the key against the reference")
      ->type_name("FRAMES")
      ->check(CLI::Range(2, 360));
  app.add_option("--swim-degrees", arguments->swim_degrees, "from one of those frames to the next")
      ->type_name("DEGREES")
      ->check(CLI::Range(-180.0, 180.0))
      ->capture_default_str();
  app.add_flag("--json", arguments->json, "for scripts");
  app.add_flag("-q,--quiet", arguments->quiet, "no notes and no progress");
  return [arguments](const std::string&) { return run_bench(*arguments); };
}

}  // namespace plinian::cli
