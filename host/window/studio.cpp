// Puts the parts together, and asks for pictures.
#include "host/window/studio.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/integrate/map_renderer.h"
#include "core/scene/resources.h"
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
      comparison(development, wake),
      inspector(wake),
      files(workspace, commands, viewpoint, console, trace) {
  files.frame_all = [this] { viewpoint.frame(false, picture_size); };
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
  if (!asked_ || !same_picture(*asked_, wanted)) {
    ++number_;
    asked_ = wanted;
  }
  renderer.ask({std::move(wanted), number_, is_hand_on()});
  comparison.update();
}

void Studio::render_reference() {
  if (asked_) comparison.render_reference(*asked_, number_);
}

}  // namespace plinian::window
