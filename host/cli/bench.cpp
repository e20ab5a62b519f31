// plinian bench: times of this machine (timing.h), errors from frame to frame (swim.h), or how drags in the
// window feel (drags.h).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/drags.h"
#include "host/cli/machine.h"
#include "host/cli/prepared_scene.h"
#include "host/cli/progress.h"
#include "host/cli/renderers.h"
#include "host/cli/scene_arguments.h"
#include "host/cli/swim.h"
#include "host/cli/timing.h"

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
  bool drags = false, renderer_given = false;
  DragOptions drag;
  bool json = false, quiet = false;
};

constexpr const char* examples = R"(
Examples:
  plinian bench ash
  plinian bench smoke.json --size 512x512 --runs 9 --json
  plinian bench ash --resolution 128 --size 128x128 --swim 4
  plinian bench smoke.json --against 'vdb_render smoke.vdb /tmp/out.exr -res 512x512'
  plinian bench ash --resolution 256 --drags
What is timed: an orbit frame (the camera moves, maps are kept); an albedo edit; an extinction edit and a light edit
(maps are rebuilt); a frame change (a new volume of the same kind); and, for comparison, the same view march with a
march to the light instead of the maps. One jittered pass each. With --swim nothing is timed: every frame of a small
orbit and of a turn of the first light is held against the reference, and so is the change of that error from one
frame to the next. With --drags the window's own renderer is asked for pictures sixty times a second, as by a hand that
drags the density, the key light and the camera under the preset fast, and lets go under high.)";

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

int run_drags(const BenchArguments& arguments) {
  PreparedScene prepared = prepare_scene(arguments.scene);
  SceneSnapshot scene = prepared.snapshot;
  DragOptions options = arguments.drag;
  options.renderer = choose_renderer(arguments.renderer_given ? arguments.renderers.front() : "auto").name;
  scene.quality = prepare_quality(arguments.scene, arguments.presets.front());
  options.rest = prepare_quality(arguments.scene, arguments.presets.back());
  ordered_json report = {{"scene", arguments.scene.input}, {"size", {scene.width, scene.height}},
                         {"machine", machine_name()},      {"renderer", options.renderer},
                         {"preset", scene.quality.name},   {"seconds", options.seconds}};
  {
    ProgressBar bar("dragging");
    report.update(measure_drags(scene, options, [&](double share) { return bar(share); }));
  }
  print(arguments.json ? report.dump(2) + "\n" : drags_table(report));
  return exit_success;
}

int run_bench(const BenchArguments& arguments) {
  set_quiet(arguments.quiet);
  if (arguments.drags) return run_drags(arguments);
  const SceneSnapshot scene = prepare_scene(arguments.scene).snapshot;
  std::vector<BenchQuality> qualities;
  for (const std::string& renderer : arguments.renderers)
    for (const std::string& preset : arguments.presets)
      qualities.push_back({renderer, preset, prepare_quality(arguments.scene, preset)});
  ordered_json report = {{"scene", arguments.scene.input},
                         {"size", {scene.width, scene.height}},
                         {"samples", arguments.samples}};
  const bool swims = arguments.swim_frames > 0;
  {
    ProgressBar bar(swims ? "comparing" : "timing");
    const auto progress = [&](double share) { return bar(share); };
    if (swims) {
      report["frames"] = arguments.swim_frames;
      report["degrees"] = arguments.swim_degrees;
      report["swim"] = measure_swim(
          scene, qualities,
          {.frames = arguments.swim_frames, .degrees = arguments.swim_degrees, .passes = arguments.samples},
          progress);
    } else {
      report["runs"] = arguments.runs;
      report.update(measure_times(
          scene, qualities,
          {.runs = arguments.runs, .passes = arguments.samples, .against = arguments.against}, progress));
    }
  }
  if (arguments.json)
    print(report.dump(2) + "\n");
  else
    swims ? print_swim(report) : print_table(report);
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
  CLI::Option* const renderer =
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
  CLI::Option* const drags =
      app.add_flag("--drags", arguments->drags,
                   "measure drags in the window: pictures a second, how late they come, how like they are to "
                   "the pictures at "
                   "rest (of the first --preset), and how fast a picture comes to rest (in the last)");
  drags->excludes("--swim")->excludes("--against")->group("Drags");
  app.add_option("--drag-seconds", arguments->drag.seconds, "of each drag")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.1, 600.0))
      ->capture_default_str()
      ->needs(drags)
      ->group("Drags");
  app.add_option("--drag-samples", arguments->drag.samples,
                 "pictures of each drag held against those at rest")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str()
      ->needs(drags)
      ->group("Drags");
  app.add_option("--rest-seconds", arguments->drag.rest_seconds,
                 "that a picture is given to come to rest; 0: leave that and the reference out")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str()
      ->needs(drags)
      ->group("Drags");
  app.add_option("--drag-pictures", arguments->drag.folder, "a folder for those pictures, as PNG")
      ->type_name("FOLDER")
      ->needs(drags)
      ->group("Drags");
  app.add_flag("--json", arguments->json, "for scripts");
  app.add_flag("-q,--quiet", arguments->quiet, "no notes and no progress");
  return [=](const std::string&) {
    arguments->renderer_given = renderer->count() > 0;
    return run_bench(*arguments);
  };
}

}  // namespace plinian::cli
