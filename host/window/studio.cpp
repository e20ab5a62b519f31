// Runs what panels ask for, and asks for pictures.
#include "host/window/studio.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/integrate/dual_march.h"
#include "core/integrate/map_renderer.h"
#include "core/scene/resources.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_loader.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/graph_error.h"
#include "host/scene/import_description.h"
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

fs::path autosave_folder() {
  const fs::path folder = user_state_folder();
  return folder.empty() ? folder : folder / "unsaved";
}

bool is_scene(const std::string& path) {
  return path.ends_with(".plinian");
}

}  // namespace

Studio::Studio(std::function<void()> wake, const std::string& trace_path)
    : feed(workspace),
      renderer(make_renderer, wake),
      developer(wake),
      kept_developer(wake),
      trace(trace_path),
      wake_(wake),
      autosave_(autosave_folder()) {
  left_behind = autosave_.left_behind();
  session().on_echo = [this](const std::string& line) {
    if (!muted_) console.echo(line, merge_key_);
  };
  session().on_warning = [this](const std::string& line) { console.add(LineKind::warning, line); };
  session().on_note = [this](const std::string& line) { console.add(LineKind::note, line); };
  session().on_progress = [this](double share) { return tell_progress(share); };
  development.view.view = default_view();
  read_hotkeys(hotkeys, console);
  for (const std::string& line : sdk::PluginManager::skipped()) console.add(LineKind::warning, line);
}

Studio::~Studio() {
  session().on_echo = session().on_warning = session().on_note = nullptr;
  session().on_progress = nullptr;
}

Camera Studio::camera() const {
  return look.free ? look.free->camera() : feed.snapshot()->snapshot.camera;
}

FreeCamera Studio::free_camera() const {
  if (look.free) return *look.free;
  const SceneSnapshot& scene = feed.snapshot()->snapshot;
  return free_camera_at(scene.camera, interest_distance(scene.camera, scene_bounds(scene.media)));
}

void Studio::move_camera(const FreeCamera& camera, bool begins) {
  if (begins) camera_history.note(look);
  look.free = camera;
}

void Studio::look_through_scene_camera() {
  if (!look.free) return;
  camera_history.note(look);
  look.free.reset();
}

void Studio::frame_view(bool selection_only) {
  if (!feed.snapshot()) return;
  std::vector<Medium> media = feed.snapshot()->snapshot.media;
  if (selection_only && !session().graph().selection().empty()) {
    scene::SceneView view = workspace.view();
    const auto& selection = session().graph().selection();
    view.isolated = {selection.begin(), selection.end()};
    try {
      const auto selected = scene::build_snapshot(session(), view).snapshot.media;
      if (!selected.empty()) media = selected;
    } catch (const graph::GraphError&) {
      // What cannot be told counts for nothing.
    }
  }
  const ivec2 pane = picture_size;
  FreeCamera free = frame(free_camera(), scene_bounds(media), pane);
  move_camera(free, true);
}

void Studio::update_picture() {
  if (!feed.snapshot()) return;
  SceneSnapshot wanted = feed.snapshot()->snapshot;
  wanted.camera = camera();
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
  if (!reference_) return;
  if (const ViewPicturePtr reference = reference_->picture();
      reference && reference != kept && !reference->quick)
    keep_picture(reference, "reference");
}

void Studio::keep_picture(ViewPicturePtr picture, const std::string& name) {
  kept = std::move(picture);
  kept_name = name;
  development.against = kept;
  if (!kept) development.difference = wipes = false;
}

void Studio::render_reference() {
  if (!asked_) return;
  if (!reference_)
    reference_ = std::make_unique<ViewRenderer>([] { return std::make_unique<DualMarch>(); }, wake_);
  reference_->ask({*asked_, number_, false});
  if (!development.difference) wipes = true;
}

void Studio::stop_reference() {
  reference_.reset();
}

std::optional<double> Studio::reference_share() const {
  if (!reference_) return std::nullopt;
  const ViewRenderer::Status status = reference_->status();
  return status.is_busy ? std::optional(status.share) : std::nullopt;
}

bool Studio::is_picture_old() const {
  const ViewPicturePtr picture = renderer.picture();
  return !picture || picture->number != number_;
}

void Studio::run(const std::string& line, const std::string& merge_key, bool typed) {
  later([=, this] { run_now(line, merge_key, typed); });
}

void Studio::run_now(const std::string& line, const std::string& merge_key, bool typed) {
  merge_key_ = merge_key;
  const double begin = trace.milliseconds();
  try {
    for (const std::string& answer : session().execute(line, merge_key))
      if (typed) console.add(LineKind::answer, answer);
  } catch (const std::exception& error) {
    if (typed) console.add(LineKind::command, line);
    console.add(LineKind::error, error.what());
  }
  merge_key_.clear();
  if (trace.is_on()) trace.note(fmt::format("ran {} ({:.1f} ms)", line, trace.milliseconds() - begin));
}

void Studio::end_drag() {
  later([this] { session().history().end_merge(); });
}

void Studio::work_off() {
  // What a task asks for comes after what was asked before.
  std::vector<std::function<void()>> now = std::exchange(tasks_, {});
  for (const std::function<void()>& task : now) task();
}

std::string Studio::new_merge_key(const std::string& what) {
  return fmt::format("{} {}", what, ++drags_);
}

bool Studio::tell_progress(double share) {
  job.share = share;
  const auto now = std::chrono::steady_clock::now();
  if (draw_meanwhile && now - drawn_meanwhile_ > std::chrono::milliseconds(30)) {
    draw_meanwhile();
    drawn_meanwhile_ = std::chrono::steady_clock::now();
  }
  return !job.cancelled;
}

// Everything that a picture needs, made at once: one step of undo.
void Studio::import_whole(const std::string& input) {
  job = {"reading " + fs::path(input).filename().string()};
  try {
    const graph::History::Scope scope(session().history(), "import " + input);
    muted_ = true;
    scene::ImportOptions options;
    options.progress = [this](double share) { return tell_progress(share); };
    const scene::ImportReport report = scene::import_description(session(), describe_input(input), options);
    for (const std::string& line : report.notes) console.add(LineKind::note, line);
    for (const std::string& line : report.warnings) console.add(LineKind::warning, line);
  } catch (const SceneLoadCancelled&) {
    console.add(LineKind::note, input + ": cancelled");
  } catch (const std::exception& error) {
    console.add(LineKind::error, error.what());
  }
  muted_ = false;
  job = {};
}

void Studio::begin_with(const std::string& input) {
  later([=, this] {
    if (is_scene(input)) {
      run_now("open " + graph::quote(input), "", false);
      return;
    }
    import_whole(input);
    // What one tunes first is there to be tuned.
    if (const graph::Node* medium = scene::first_of_type(session().graph(), "medium"))
      session().editor().select({medium->id});
    // What one begins with is no edit.
    session().history().clear();
    session().history().mark_saved();
  });
}

void Studio::open(const std::string& path) {
  if (!is_scene(path)) return add_file(path);
  unless_unsaved([=, this] {
    look = {};
    camera_history.clear();
    run_now("open -force " + graph::quote(path), "", false);
  });
}

void Studio::add_file(const std::string& path) {
  if (is_scene(path)) return open(path);
  later([=, this] {
    const bool bare = !scene::first_of_type(session().graph(), "camera") &&
                      !scene::first_of_type(session().graph(), "atfmVolume");
    if (bare) {
      look = {};
      import_whole(path);
      return;
    }
    job = {"reading " + fs::path(path).filename().string()};
    run_now("import " + graph::quote(path), "", false);
    job = {};
    later([this] { frame_view(false); });
  });
}

void Studio::autosave_if_due() {
  const auto now = std::chrono::steady_clock::now();
  if (now - autosaved_ < std::chrono::duration<double>(autosave_seconds) || is_hand_on()) return;
  autosaved_ = now;
  if (!session().history().is_modified()) return autosave_.forget();
  if (session().graph().generation() == autosaved_generation_) return;
  try {
    autosave_.keep(graph::write_scene(session().graph()), session().scene_path());
    autosaved_generation_ = session().graph().generation();
    trace.note("autosaved");
  } catch (const std::exception& error) {
    console.add(LineKind::warning, error.what());
  }
}

void Studio::recover(const Autosave::Left& left) {
  later([=, this] {
    try {
      look = {};
      camera_history.clear();
      session().recover_scene(left.file.string(), left.scene_path);
      autosave_.keep(graph::write_scene(session().graph()), left.scene_path);
      Autosave::discard(left);
      console.add(LineKind::note, left.scene_path.empty()
                                      ? "recovered what had not been saved"
                                      : left.scene_path + ": recovered; it is not saved yet");
      trace.note("recovered");
    } catch (const std::exception& error) {
      console.add(LineKind::error, error.what());
    }
  });
}

void Studio::unless_unsaved(std::function<void()> task) {
  if (session().history().is_modified())
    after_unsaved = std::move(task);
  else
    later(std::move(task));
}

void Studio::act(Action action) {
  const auto selected = [this] { return !session().graph().selection().empty(); };
  const auto use = [this](const std::optional<Look>& found) {
    if (found) look = *found;
  };
  switch (action) {
    case Action::undo:
      return run("undo");
    case Action::redo:
      return run("redo");
    case Action::new_scene:
      return unless_unsaved([this] {
        look = {};
        run_now("newScene -force", "", false);
      });
    case Action::open_scene:
      ask_open = true;
      return;
    case Action::save_scene:
      if (session().scene_path().empty())
        ask_save_as = true;
      else
        run("save");
      return;
    case Action::save_scene_as:
      ask_save_as = true;
      return;
    case Action::delete_nodes:
      if (selected()) run("delete");
      return;
    case Action::duplicate_nodes:
      if (selected()) run("duplicate");
      return;
    case Action::frame_selection:
      return frame_view(true);
    case Action::frame_all:
      return frame_view(false);
    case Action::camera_back:
      return use(camera_history.back(look));
    case Action::camera_forth:
      return use(camera_history.forth(look));
    case Action::scene_camera:
      return look_through_scene_camera();
    case Action::quality_fast:
      return run("quality fast");
    case Action::quality_high:
      return run("quality high");
    case Action::original_maps:
      original_maps = !original_maps;
      return;
    case Action::snapshot_picture:
      if (const ViewPicturePtr picture = renderer.picture(); picture && !picture->quick)
        keep_picture(picture, "kept");
      else
        console.add(LineKind::note, "only a picture that is past its quick pass can be kept");
      return;
    case Action::reference:
      return render_reference();
    case Action::wipe:
      wipes = kept && !wipes;
      development.difference = false;
      return;
    case Action::difference:
      development.difference = kept && !development.difference;
      wipes = false;
      return;
    case Action::set_key:
      for (const graph::NodeId id : session().graph().selection())
        if (const graph::Node& node = *session().graph().find(id);
            node.schema->find("rotate") != graph::no_attribute)
          run("setKeyframe " + node.name + ".translate " + node.name + ".rotate");
        else
          console.add(LineKind::note, node.name + " has no place; 'setKeyframe " + node.name +
                                          ".ATTRIBUTE' keys what else it has");
      return;
    case Action::toggle_display:
      show_display = !show_display;
      return;
    case Action::toggle_panels:
      show_panels = !show_panels;
      return;
    case Action::console_line:
      focus_console = true;
      return;
    case Action::hotkey_list:
      show_hotkeys = !show_hotkeys;
      return;
    case Action::cancel:
      job.cancelled = true;
      stop_reference();
      if (job.what.empty()) feed.cancel();
      return;
    default:
      return;
  }
}

}  // namespace plinian::window
