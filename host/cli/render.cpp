// plinian render: a picture of a volume or a scene, of its frames, or of variants of it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/media/frame_sequence.h"
#include "core/scene/nearest_word.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/picture.h"

namespace plinian::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* examples = R"(
Examples:
  plinian render ash -o ash.png
  plinian render smoke.vdb -o smoke.exr -o smoke.png --preset high --size 1280x720
  plinian render smoke.vdb --set medium.albedo=0.3 --set key.exposure=2 --set camera.azimuth=120
  plinian render scene.json -o truth.exr --renderer reference
  plinian render shot.plinian --set key.exposure=2 --set medium_place.rotate.y=45
  plinian render smoke.####.vdb --frames 1-48 -o smoke.####.exr
  plinian render smoke.vdb --vary medium.albedo=0.3,0.6,0.9 --sheet albedo.png
Without -o the picture is INPUT's name with .png, in the current folder. An EXR holds linear radiance in layers
(beauty, alpha, depth, one per light); a PNG is what the view transform shows of it. A picture gathers jittered
passes until what further ones would change is no longer seen; Ctrl-C ends it after the pass it is at and writes it.
--frames, run again, makes only those pictures whose scene, quality or program has changed since.)";

// The picture of a sequence is called after the frame that is shown.
std::string default_output(const RenderArguments& arguments, const PreparedScene& scene) {
  std::string input = fs::path(arguments.scene.input).filename().string();
  if (const auto pattern = FramePattern::parse(input))
    input = pattern->path(int(scene.workspace->session().evaluator().time()));
  return fs::path(input).stem().string() + ".png";
}

int run_once(const RenderArguments& arguments, const std::string& command_line) {
  // Whatever is wrong with an output is told before the time is spent.
  const WriteOptions writing = write_options(arguments);
  for (const std::string& output : arguments.outputs) check_output(output, writing);

  PreparedScene scene = prepare_scene(arguments.scene);
  tell_shown_frames(scene);
  std::vector<std::string> outputs = arguments.outputs;
  if (outputs.empty()) {
    outputs.push_back(default_output(arguments, scene));
    check_output(outputs.front(), writing);
  }
  NamedRenderer chosen = choose_renderer(arguments.renderer, {.reference_tolerance = arguments.tolerance});
  Picture picture = make_picture(chosen, scene.snapshot, arguments, command_line, "rendering", "", true);
  picture.load_ms = scene.load_ms;
  const nlohmann::ordered_json facts = picture_report(picture, outputs);
  for (const auto& [part, time] : facts["time_ms"].items())
    picture.image.metadata[attribute::time_prefix + part] = time.get<float>();
  if (scene.seed) picture.image.metadata[attribute::seed] = *scene.seed;
  for (const std::string& output : outputs) write_image(output, picture.image, writing);

  tell_picture(join(outputs), picture);
  if (picture.cut_short)
    warn(fmt::format("interrupted: {} holds what {} of {} gave", join(outputs), picture.stats.passes,
                     picture.most));
  if (arguments.json) {
    nlohmann::ordered_json report = {{"input", arguments.scene.input}};
    report.update(facts);
    report["notes"] = scene.notes;
    report["warnings"] = scene.warnings;
    for (const std::string& warning : picture.stats.warnings) report["warnings"].push_back(warning);
    print(report.dump(2) + "\n");
  }
  return picture.cut_short ? exit_cancelled : exit_success;
}

int run_render(const RenderArguments& arguments, const std::string& command_line) {
  set_quiet(arguments.quiet);
  if (arguments.vary.empty() != arguments.sheet.empty())
    throw std::runtime_error(arguments.sheet.empty() ? "--vary: needs --sheet OUT.png to put the variants on"
                                                     : "--sheet: needs --vary KEY=VALUE,VALUE to fill it");
  if (!arguments.vary.empty() && !arguments.frames.empty())
    throw std::runtime_error("--vary: cannot go with --frames");
  if (!arguments.vary.empty() && !arguments.outputs.empty())
    throw std::runtime_error("--output: variants go on the sheet, " + arguments.sheet + ": leave it out");
  if (!arguments.vary.empty()) return run_variants(arguments);
  return arguments.frames.empty() ? run_once(arguments, command_line) : run_frames(arguments, command_line);
}

}  // namespace

Run set_up_render(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  app.footer(examples);
  add_scene_arguments(app, arguments->scene, true);
  app.add_option("-o,--output", arguments->outputs, "picture to write, .exr or .png; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--save-scene", arguments->scene.save_as, "the scene that INPUT and --set make, .plinian")
      ->type_name("FILE");
  app.add_option("--frames", arguments->frames, "a picture for each of these frames: 1-48, 1-48x4, 1,3,10-20")
      ->type_name("A-B")
      ->group("Sequences and variants");
  app.add_option("--vary", arguments->vary,
                 "a picture for each of these values, on a sheet; may be repeated for all combinations")
      ->type_name("KEY=VALUE,VALUE")
      ->allow_extra_args(false)
      ->group("Sequences and variants");
  app.add_option("--sheet", arguments->sheet, "where the variants go, .png")
      ->type_name("FILE")
      ->group("Sequences and variants");
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
  app.add_option("--gamma", arguments->gamma, "of a PNG, after the view")->group("Picture");
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
