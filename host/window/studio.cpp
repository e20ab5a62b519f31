// Puts the parts together, and asks for pictures.
#include "host/window/studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/integrate/map_renderer.h"
#include "core/scene/resources.h"
#include "host/graph/files/scene_writer.h"
#include "host/window/view/same_picture.h"
#include "viewport/gl_renderer.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

// OpenGL where there is one, else the same maps on the processor.
std::unique_ptr<Renderer> make_renderer() {
  try {
    return make_gl_renderer();
  } catch (const std::runtime_error&) {
    return make_map_renderer();
  }
}

void read_hotkeys(Hotkeys& hotkeys, ConsoleLog& console) {
  const fs::path folder = user_config_folder();
  if (folder.empty()) return;
  std::ifstream file(folder / "hotkeys");
  if (!file) return;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& line : hotkeys.read(text, (folder / "hotkeys").string()))
    console.add(LineKind::warning, line);
}

}  // namespace

Studio::Studio(std::function<void()> wake, const std::string& trace_path)
    : trace(trace_path),
      feed(workspace),
      commands(workspace.session(), console, trace),
      viewpoint(workspace, feed),
      renderer(make_renderer, wake),
      developer(wake),
      comparison(workspace, development, wake),
      snapshots(workspace),
      looks(make_renderer, wake),
      inspector(wake),
      files(workspace, commands, viewpoint, console, trace),
      grids(wake) {
  // Who loads a picture wants to see it, also where it was there and something else was looked at.
  commands.ran = [this](const std::string& line) {
    if (line.starts_with("loadReference") && line.find(" -plate") == line.npos) comparison.want_file();
  };
  // Who looks through the scene's camera does not lose it for that.
  files.frame_all = [this] {
    if (viewpoint.look.free) viewpoint.frame(false, picture_size);
  };
  development.view.view = default_view();
  read_hotkeys(hotkeys, console);
  for (const std::string& line : sdk::PluginManager::skipped()) console.add(LineKind::warning, line);
}

void Studio::update_picture() {
  if (!feed.snapshot()) return;
  SceneSnapshot wanted = feed.snapshot()->snapshot;
  wanted.camera = viewpoint.camera();
  wanted.width = std::max(1, picture_size.x);
  wanted.height = std::max(1, picture_size.y);
  if (original_maps) {
    wanted.quality.map.encoding = Encoding::tfm;
    wanted.quality.map.density_weighting = 1.0f;
    wanted.quality.view.exact_light_at_rest = false;
  }
  if (played.begin(take())) first_number_ = numbers_ + 1;
  if (!subject_ || !same_picture(*subject_, wanted)) {
    subject_ = wanted;
    played_before_ = can_play_again() ? played.find(wanted) : nullptr;
    subject_number_ = played_before_ ? played_before_->number : ++numbers_;
    error_number_ = 0;
  }
  number_ = subject_number_;
  // Where the maps are off is another picture of the same: what was compared with it stays good.
  if (development.sees_map_error()) {
    wanted.quality.view.light = LightLookup::error;
    if (error_number_ == 0) error_number_ = ++numbers_;
    number_ = error_number_;
  }
  // Where the hand rests, what was played stays up until it is refined.
  if (!played_before_ || !is_playing)
    renderer.ask({.scene = std::move(wanted),
                  .number = number_,
                  .time = feed.time(),
                  .hand_on = is_hand_on(),
                  .light_maps = wants_light_maps});
  keep_played();
  comparison.update();
}

const std::vector<OcioView>& Studio::ocio_views() {
  if (reading_ocio_.valid() && reading_ocio_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    ocio_views_ = reading_ocio_.get();
  return ocio_views_;
}

ViewPicturePtr Studio::picture() const {
  const ViewPicturePtr rendered = renderer.picture();
  const bool stands_in = played_before_ && (!rendered || rendered->number != number_ ||
                                            (rendered->quick && !played_before_->quick));
  return stands_in ? played_before_ : rendered;
}

bool Studio::is_picture_there() {
  const ViewPicturePtr seen = picture();
  return seen && seen->number == number_ && !seen->quick && !feed.is_computing() && !feed.is_stale() &&
         feed.time() == workspace.session().evaluator().time();
}

Take Studio::take() {
  Take take;
  take.generation = workspace.session().graph().generation();
  take.quality = workspace.view().quality;
  take.original_maps = original_maps;
  take.size = picture_size;
  if (viewpoint.look.free) take.free = viewpoint.look.free->camera();
  return take;
}

// Pictures that were played have no layers, nor light maps for plug-ins to look up.
bool Studio::can_play_again() const {
  const std::string& layer = development.layer;
  return is_playing && !wants_light_maps && development.solo.empty() && !development.solo_ambient &&
         (layer.empty() || layer == "beauty" || layer == "alpha" || layer == "depth");
}

void Studio::keep_played() {
  const ViewPicturePtr rendered = renderer.picture();
  if (!is_playing || !rendered || rendered == kept_.lock() || rendered->number < first_number_) return;
  kept_ = rendered;
  played.keep(*rendered);
}

void Studio::render_reference() {
  if (subject_) comparison.render_reference(*subject_, subject_number_);
}

std::string Studio::start_playblast(const PlayblastSettings& settings) {
  try {
    playblast.start(settings, graph::write_scene(session().graph()), session().scene_folder());
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

void Studio::update_playblast() {
  for (const Playblast::End& end : playblast.poll()) {
    console.add(end.succeeded ? LineKind::note : LineKind::error, end.line);
    trace.note(end.line);
  }
}

// A camera that stands where its scene was framed for one gate is framed for the next; who placed it himself
// keeps his place.
void Studio::set_gate(ivec2 size) {
  commands.later([=, this] {
    bool was_framed = false;
    if (feed.snapshot() && !feed.snapshot()->snapshot.media.empty()) {
      const SceneSnapshot& scene = feed.snapshot()->snapshot;
      const ViewPicturePtr seen = picture();
      const MediaExtent::Ptr extent = MediaExtent::of(scene.media, seen ? seen->extent : nullptr);
      was_framed = is_framed(scene.camera, extent->all(), {scene.width, scene.height});
    }
    const graph::Node* settings = scene::first_of_type(session().graph(), "renderSettings");
    if (!settings) commands.run_now("createNode renderSettings -name settings");
    settings = scene::first_of_type(session().graph(), "renderSettings");
    const std::string key = commands.new_merge_key("gate");
    commands.run_now(fmt::format("setAttr {}.width {}", settings->name, size.x), key);
    commands.run_now(fmt::format("setAttr {}.height {}", settings->name, size.y), key);
    if (was_framed) commands.run_now("frameView", key);
  });
}

}  // namespace plinian::window
