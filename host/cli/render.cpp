// plinian render: a picture of a volume or a scene.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/image/image_io.h"
#include "core/scene/nearest_word.h"
#include "core/scene/scene_hash.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/progress.h"
#include "host/cli/renderers.h"
#include "host/cli/scene_arguments.h"

namespace plinian::cli {

namespace fs = std::filesystem;

namespace {

struct RenderArguments {
  SceneArguments scene;
  std::vector<std::string> outputs;
  std::string renderer = "auto";
  int passes = 0;  // jittered passes; 0: until the picture rests, as the preset says
  float exposure = 0.0f;
  std::string view;
  std::string pixels = "half", compression = "zip";
  double tolerance = 0.0;
  bool json = false, quiet = false;
};

constexpr const char* examples = R"(
Examples:
  plinian render ash -o ash.png
  plinian render smoke.vdb -o smoke.exr -o smoke.png --preset high --size 1280x720
  plinian render smoke.vdb --set medium.albedo=0.3 --set key.exposure=2 --set camera.azimuth=120
  plinian render scene.json -o truth.exr --renderer reference
Without -o the picture is INPUT's name with .png, in the current folder. An EXR holds linear radiance in layers
(beauty, alpha, depth, one per light); a PNG is what the view transform shows of it. A picture gathers jittered
passes until what further ones would change is no longer seen; Ctrl-C ends it after the pass it is at and writes it.)";

// Every way to spell one output counts once.
std::vector<std::string> outputs_of(const RenderArguments& arguments) {
  if (!arguments.outputs.empty()) return arguments.outputs;
  return {fs::path(arguments.scene.input).stem().string() + ".png"};
}

WriteOptions write_options(const RenderArguments& arguments) {
  WriteOptions options;
  options.exr_pixels = arguments.pixels == "float" ? ExrPixels::single_float : ExrPixels::half_float;
  options.exr_compression = arguments.compression == "none"   ? ExrCompression::none
                            : arguments.compression == "dwaa" ? ExrCompression::dwaa
                                                              : ExrCompression::zip;
  if (arguments.view.empty())
    options.view.view = default_view();
  else
    options.view = parse_view(arguments.view);
  options.view.exposure = arguments.exposure;
  return options;
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

int run_render(const RenderArguments& arguments, const std::string& command_line) {
  set_quiet(arguments.quiet);
  // Whatever is wrong with an output is told before the time is spent.
  const std::vector<std::string> outputs = outputs_of(arguments);
  const WriteOptions writing = write_options(arguments);
  for (const std::string& output : outputs) check_output(output, writing);

  const PreparedScene scene = prepare_scene(arguments.scene);
  const SceneSnapshot& snapshot = scene.loaded.snapshot;
  NamedRenderer chosen = choose_renderer(arguments.renderer, {.reference_tolerance = arguments.tolerance});
  if (interrupted()) throw RenderCancelled();

  const auto start = std::chrono::steady_clock::now();
  const ViewQuality& view = snapshot.quality.view;
  Passes passes = arguments.passes > 0 ? Passes(arguments.passes) : Passes(view.passes, view.rest_change);
  // Ctrl-C lets the current pass end and keeps what there is. The reference has no passes: it ends at once.
  const bool has_passes = chosen.name != "reference";
  const std::string most =
      fmt::format("{}{} passes", passes.rest_change > 0.0f ? "at most " : "", passes.most);
  Frame frame;
  {
    ProgressBar bar("rendering");
    if (has_passes) bar.set_detail("0 of " + most);
    passes.after_pass = [&](int done, std::optional<float>) {
      bar.set_detail(fmt::format("{} of {}", done, most));
      return !interrupted();
    };
    frame = chosen.renderer->render(snapshot, passes, [&](double share) { return bar(share) || has_passes; });
  }
  const double render_ms = milliseconds_since(start);
  // What the renderer holds is not needed beside the picture's channels and their encoding.
  const RenderStats stats = chosen.renderer->stats();
  chosen.renderer.reset();
  for (const std::string& warning : stats.warnings) warn(warning);

  Image image = frame_to_image(std::exchange(frame, {}));
  add_camera_metadata(image, snapshot.camera);
  const std::string hash = scene_hash_text(snapshot);
  image.metadata[attribute::command] = command_line;
  image.metadata[attribute::version] = std::string(PLINIAN_VERSION);
  image.metadata[attribute::renderer] = chosen.name;
  image.metadata[attribute::preset] = snapshot.quality.name;
  image.metadata[attribute::scene_hash] = hash;
  image.metadata[attribute::passes] = stats.passes;
  if (scene.loaded.seed) image.metadata[attribute::seed] = *scene.loaded.seed;
  const std::vector<std::pair<std::string, double>> times = {{"load", scene.load_ms},
                                                             {"upload", stats.upload_ms},
                                                             {"map", stats.map_ms},
                                                             {"view", stats.view_ms},
                                                             {"render", render_ms}};
  for (const auto& [part, time] : times) image.metadata[attribute::time_prefix + part] = float(time);

  const bool cut_short = interrupted() && has_passes && stats.passes < passes.most;
  for (const std::string& output : outputs) write_image(output, image, writing);

  const std::string change =
      stats.rest_change ? fmt::format(", to rest within {:.2g} of 255", *stats.rest_change) : "";
  note(fmt::format("{}: {}, {}, {}x{}, {} passes in {:.2f} s (maps {:.0f} ms){}", join(outputs), chosen.name,
                   snapshot.quality.name, image.width, image.height, stats.passes, render_ms / 1000.0,
                   stats.map_ms, change));
  if (cut_short)
    warn(fmt::format("interrupted: {} holds what {} of {} gave", join(outputs), stats.passes, most));
  if (arguments.json) {
    nlohmann::ordered_json report = {{"input", arguments.scene.input},
                                     {"outputs", outputs},
                                     {"renderer", chosen.name},
                                     {"preset", snapshot.quality.name},
                                     {"size", {image.width, image.height}},
                                     {"passes", stats.passes},
                                     {"interrupted", cut_short},
                                     {"scene_hash", hash}};
    if (stats.rest_change) report["rest_change"] = *stats.rest_change;
    for (const auto& [part, time] : times) report["time_ms"][part] = time;
    report["map_builds"] = stats.map_builds;
    report["volume_uploads"] = stats.volume_uploads;
    report["volume_bytes"] = stats.volume_bytes;
    report["map_bytes"] = stats.map_bytes;
    report["notes"] = scene.loaded.notes;
    report["warnings"] = scene.loaded.warnings;
    for (const std::string& warning : stats.warnings) report["warnings"].push_back(warning);
    print(report.dump(2) + "\n");
  }
  return cut_short ? exit_cancelled : exit_success;
}

}  // namespace

Run set_up_render(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  app.footer(examples);
  add_scene_arguments(app, arguments->scene, true);
  app.add_option("-o,--output", arguments->outputs, "picture to write, .exr or .png; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--renderer", arguments->renderer,
                 "auto (gl, or cpu where there is no OpenGL 4.5), gl, cpu, reference")
      ->check(CLI::IsMember({"auto", "gl", "cpu", "reference"}))
      ->type_name("NAME")
      ->capture_default_str()
      ->group("Quality");
  app.add_option("--passes,--samples", arguments->passes,
                 "exactly so many jittered passes (until no visible change is to come: view.rest_change, "
                 "view.passes)")
      ->type_name("N")
      ->check(CLI::Range(1, 65536))
      ->group("Quality");
  app.add_option("--tolerance", arguments->tolerance,
                 "of the reference: largest change when its steps are halved")
      ->type_name("SHARE")
      ->check(CLI::Range(1e-7, 0.5))
      ->group("Quality");
  app.add_option("--exposure", arguments->exposure, "of a PNG")->type_name("STOPS")->group("Picture");
  app.add_option("--view", arguments->view, "of a PNG: srgb, filmic, ocio or ocio:DISPLAY/VIEW")
      ->type_name("VIEW")
      ->group("Picture");
  app.add_option("--pixels", arguments->pixels, "of an EXR: half or float")
      ->check(CLI::IsMember({"half", "float"}))
      ->type_name("TYPE")
      ->capture_default_str()
      ->group("Picture");
  app.add_option("--compression", arguments->compression, "of an EXR: none, zip or dwaa")
      ->check(CLI::IsMember({"none", "zip", "dwaa"}))
      ->type_name("NAME")
      ->capture_default_str()
      ->group("Picture");
  app.add_flag("--json", arguments->json, "report on standard output, for scripts");
  app.add_flag("-q,--quiet", arguments->quiet, "no notes and no progress");
  return [arguments](const std::string& command_line) { return run_render(*arguments, command_line); };
}

}  // namespace plinian::cli
