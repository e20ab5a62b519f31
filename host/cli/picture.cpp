// Renders and describes one picture.
#include "host/cli/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "core/scene/nearest_word.h"
#include "core/scene/quality_parameters.h"
#include "core/scene/scene_hash.h"
#include "host/cli/console.h"
#include "host/cli/interruption.h"
#include "host/cli/progress.h"
#include "host/graph/values/hash.h"

namespace plinian::cli {

namespace {

// The reference has no passes: Ctrl-C ends it at once.
bool has_passes(const std::string& renderer) {
  return renderer != "reference";
}

Passes passes_of(const SceneSnapshot& snapshot, const RenderArguments& arguments) {
  const ViewQuality& view = snapshot.quality.view;
  return arguments.passes > 0 ? Passes(arguments.passes) : Passes(view.passes, view.rest_change);
}

std::vector<std::pair<std::string, double>> times_of(const Picture& picture) {
  return {{"load", picture.load_ms},
          {"upload", picture.stats.upload_ms},
          {"map", picture.stats.map_ms},
          {"view", picture.stats.view_ms},
          {"render", picture.render_ms}};
}

// Why a picture shows nothing, in a line that says what would help; empty where it shows something.
std::string why_empty(const Frame& frame, const SceneSnapshot& snapshot) {
  if (snapshot.media.empty()) return "there is no medium in the scene";
  if (std::all_of(snapshot.media.begin(), snapshot.media.end(), [](const Medium& medium) {
        return medium.shape == MediumShape::voxels && (!medium.volume || medium.volume->empty());
      }))
    return "there is no density in the media at this frame";
  for (const Medium& medium : snapshot.media)
    if (snapshot.media.size() == 1 && glm::determinant(glm::dmat3(medium.world_from_medium)) == 0.0)
      return fmt::format("{} is scaled by 0: set the scale of what it is under", medium.name);
  const auto any = [](const std::vector<vec3>& layer, auto test) {
    return std::any_of(layer.begin(), layer.end(), test);
  };
  const auto shines = [](vec3 v) { return v.x > 0.0f || v.y > 0.0f || v.z > 0.0f; };
  if (!any(frame.transmittance, [](vec3 t) { return t.x + t.y + t.z < 2.997f; }))
    return "no medium is in view: the command frameView in a scene, or no camera.eye, camera.translate and "
           "camera.rotate where it has no camera, shows everything";
  const bool lit = any(frame.ambient, shines) || any(frame.emission, shines) ||
                   std::any_of(frame.lights.begin(), frame.lights.end(),
                               [&](const LightLayer& light) { return any(light.radiance, shines); });
  if (lit) return "";
  return snapshot.lights.empty()
             ? "nothing lights the medium: make a light, or make one visible; where default_lights of the "
               "renderSettings is on, or a .json has no list of lights, a key, a rim and a sky stand in for "
               "them"
             : "no light reaches what is in view: see the exposure, falloff and place of the lights";
}

}  // namespace

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
  options.view.gamma = arguments.gamma;
  return options;
}

Picture make_picture(NamedRenderer& chosen, const SceneSnapshot& snapshot, const RenderArguments& arguments,
                     const std::string& command_line, const std::string& label, const std::string& job,
                     bool last) {
  if (interrupted()) throw RenderCancelled();
  const auto start = std::chrono::steady_clock::now();
  Passes passes = passes_of(snapshot, arguments);
  Picture picture;
  picture.most = fmt::format("{}{} passes", passes.rest_change > 0.0f ? "at most " : "", passes.most);
  picture.renderer = chosen.name;
  picture.preset = snapshot.quality.name;
  const bool in_passes = has_passes(chosen.name);
  Frame frame;
  {
    ProgressBar bar(label);
    if (in_passes) bar.set_detail("0 of " + picture.most);
    passes.after_pass = [&](int done, std::optional<float>) {
      bar.set_detail(fmt::format("{} of {}", done, picture.most));
      return !interrupted();
    };
    frame = chosen.renderer->render(snapshot, passes, [&](double share) { return bar(share) || in_passes; });
  }
  picture.render_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  picture.stats = chosen.renderer->stats();
  picture.cut_short = interrupted() && in_passes && picture.stats.passes < passes.most;
  const std::string nothing = why_empty(frame, snapshot);
  if (!nothing.empty()) picture.stats.warnings.push_back("the picture is empty: " + nothing);
  for (const std::string& warning : picture.stats.warnings) warn(warning);

  // What the renderer holds is not needed beside the picture's channels and their encoding.
  if (last) chosen.renderer.reset();
  picture.image = frame_to_image(std::move(frame));
  add_camera_metadata(picture.image, snapshot.camera);
  picture.scene_hash = scene_hash_text(snapshot);
  auto& facts = picture.image.metadata;
  facts[attribute::command] = command_line;
  facts[attribute::version] = std::string(PLINIAN_VERSION);
  facts[attribute::renderer] = picture.renderer;
  facts[attribute::preset] = picture.preset;
  facts[attribute::scene_hash] = picture.scene_hash;
  facts[attribute::passes] = picture.stats.passes;
  if (!job.empty()) facts[attribute::job_hash] = job;
  return picture;
}

std::string job_hash(const SceneSnapshot& snapshot, const std::string& renderer,
                     const RenderArguments& arguments) {
  graph::Hasher hash;
  hash.add(scene_hash(snapshot));
  for (const Light& light : snapshot.lights) hash.add(std::string_view(light.name));  // names of layers
  for (const Parameter<Quality>& parameter : quality_parameters())
    hash.add(std::string_view(to_text(parameter.spec, *parameter.get(snapshot.quality))));
  for (const std::string& text : {snapshot.quality.name, renderer, std::string(PLINIAN_VERSION),
                                  arguments.view, arguments.pixels, arguments.compression})
    hash.add(std::string_view(text));
  hash.add(double(arguments.passes));
  hash.add(double(arguments.exposure));
  hash.add(double(arguments.gamma));
  hash.add(arguments.tolerance);
  const graph::Hash result = hash.result();
  return fmt::format("{:016x}{:016x}", result.high, result.low);
}

void tell_picture(const std::string& outputs, const Picture& picture) {
  const RenderStats& stats = picture.stats;
  const std::string change =
      stats.rest_change ? fmt::format(", to rest within {:.2g} of 255", *stats.rest_change) : "";
  note(fmt::format("{}: {}, {}, {}x{}, {} {} in {:.2f} s (maps {:.0f} ms){}", outputs, picture.renderer,
                   picture.preset, picture.image.width, picture.image.height, stats.passes,
                   stats.passes == 1 ? "pass" : "passes", picture.render_ms / 1000.0, stats.map_ms, change));
}

nlohmann::ordered_json picture_report(const Picture& picture, const std::vector<std::string>& outputs) {
  const RenderStats& stats = picture.stats;
  nlohmann::ordered_json report = {{"outputs", outputs},
                                   {"renderer", picture.renderer},
                                   {"preset", picture.preset},
                                   {"size", {picture.image.width, picture.image.height}},
                                   {"passes", stats.passes},
                                   {"interrupted", picture.cut_short},
                                   {"scene_hash", picture.scene_hash}};
  if (stats.rest_change) report["rest_change"] = *stats.rest_change;
  for (const auto& [part, time] : times_of(picture)) report["time_ms"][part] = time;
  report["map_builds"] = stats.map_builds;
  report["volume_uploads"] = stats.volume_uploads;
  report["volume_bytes"] = stats.volume_bytes;
  report["map_bytes"] = stats.map_bytes;
  return report;
}

}  // namespace plinian::cli
