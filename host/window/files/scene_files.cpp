// From files to the scene, and from the scene to what is kept aside.
#include "host/window/files/scene_files.h"

#include <cctype>
#include <filesystem>
#include <utility>

#include "core/scene/resources.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_loader.h"
#include "host/graph/files/scene_writer.h"
#include "host/nodes/read_facts.h"
#include "host/scene/import_description.h"
#include "host/scene/medium_names.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

fs::path autosave_folder() {
  const fs::path folder = user_state_folder();
  return folder.empty() ? folder : folder / "unsaved";
}

fs::path recent_file() {
  const fs::path folder = user_state_folder();
  return folder.empty() ? folder : folder / "recent";
}

bool is_scene(const std::string& path) {
  return path.ends_with(".plinian");
}

bool is_volume(const std::string& path) {
  return path.ends_with(".vdb");
}

bool is_picture(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) c = char(std::tolower((unsigned char)c));
  return extension == ".exr" || extension == ".png";
}

}  // namespace

SceneFiles::SceneFiles(scene::Workspace& workspace, CommandQueue& commands, Viewpoint& viewpoint,
                       ConsoleLog& console, Trace& trace)
    : recent(recent_file()),
      workspace_(workspace),
      commands_(commands),
      viewpoint_(viewpoint),
      console_(console),
      trace_(trace),
      autosave_(autosave_folder()) {
  left_behind = autosave_.left_behind();
}

// Everything that a picture needs, made at once: one step of undo.
bool SceneFiles::import_whole(const std::string& input) {
  bool done = false;
  commands_.job = {"reading " + fs::path(input).filename().string()};
  try {
    const graph::History::Scope scope(session().history(), "import " + input);
    commands_.muted = true;
    scene::ImportOptions options;
    options.progress = [this](double share) { return commands_.tell_progress(share); };
    SceneDescription description = describe_input(input);
    if (is_volume(input) && description.media.size() == 1)
      description.media.front().name =
          scene::free_medium_name(session().graph(), scene::medium_name_of(input));
    const scene::ImportReport report = scene::import_description(session(), description, options);
    for (const std::string& line : report.notes) console_.add(LineKind::note, nodes::advice_for_node(line));
    for (const std::string& line : report.warnings)
      console_.add(LineKind::warning, nodes::advice_for_node(line));
    done = true;
  } catch (const SceneLoadCancelled&) {
    console_.add(LineKind::note, input + ": cancelled");
  } catch (const std::exception& error) {
    console_.add(LineKind::error, nodes::advice_for_node(error.what()));
  }
  commands_.muted = false;
  commands_.job = {};
  // A procedural medium is no file.
  if (done && fs::path(input).has_extension()) recent.add(input);
  return done;
}

// What one tunes first is there to be tuned.
void SceneFiles::select_medium() {
  if (const graph::Node* medium = scene::first_of_type(session().graph(), "medium"))
    session().editor().select({medium->id});
}

void SceneFiles::begin_with(const std::string& input) {
  commands_.later([=, this] {
    is_sample_ = false;
    if (is_scene(input)) {
      if (commands_.run_now("open " + graph::quote(input))) recent.add(input);
      return;
    }
    is_sample_ = import_whole(input) && !fs::path(input).has_extension();
    select_medium();
    // What one begins with is no edit.
    session().history().clear();
    session().history().mark_saved();
  });
}

void SceneFiles::begin_empty() {
  unless_unsaved([this] {
    viewpoint_.begin_anew();
    commands_.run_now("newScene -force");
  });
}

void SceneFiles::open(const std::string& path) {
  if (!is_scene(path) && !is_volume(path)) return add(path);
  if (is_volume(path)) return begin_anew(path);
  unless_unsaved([=, this] {
    if (!commands_.run_now("open -force " + graph::quote(path))) return;
    viewpoint_.history.clear();
    viewpoint_.begin_anew();
    is_sample_ = false;
    recent.add(path);
  });
}

void SceneFiles::begin_anew(const std::string& input) {
  unless_unsaved([=, this] {
    if (!replace_by(input)) return;
    viewpoint_.history.clear();
    is_sample_ = !fs::path(input).has_extension();
    session().make_untitled();
  });
}

// All that is there gives way, and comes back with one undo.
bool SceneFiles::replace_by(const std::string& input) {
  const auto make = [&] {
    if (!import_whole(input)) return false;
    select_medium();
    return true;
  };
  if (!session().replace_scene("import " + input, make)) return false;
  viewpoint_.begin_anew();
  is_sample_ = false;
  return true;
}

void SceneFiles::save_as(const std::string& path) {
  commands_.later([=, this] {
    if (commands_.run_now("save " + graph::quote(path))) recent.add(path);
  });
}

void SceneFiles::add(const std::string& path) {
  if (is_scene(path)) return open(path);
  if (is_picture(path)) return commands_.run("loadReference " + graph::quote(path));
  commands_.later([=, this] {
    const bool bare = !scene::first_of_type(session().graph(), "camera") &&
                      !scene::first_of_type(session().graph(), "atfmVolume");
    if (bare) {
      viewpoint_.begin_anew();
      import_whole(path);
      select_medium();
      return;
    }
    // Nobody asked for the sample that the program began with.
    if (is_volume(path) && is_sample_ && !session().history().is_modified()) {
      replace_by(path);
      return;
    }
    if (!import_beside(path)) return;
    recent.add(path);
    commands_.later([this] { frame_all(); });
  });
}

// A volume beside what there is: called after its file, and selected to be put where it belongs. One step of
// undo.
bool SceneFiles::import_beside(const std::string& path) {
  const std::string key = commands_.new_merge_key("import");
  const std::string name =
      is_volume(path) ? " -name " + scene::free_medium_name(session().graph(), scene::medium_name_of(path))
                      : "";
  const graph::NodeId first = session().graph().new_id();
  commands_.job = {"reading " + fs::path(path).filename().string()};
  const bool done = commands_.run_now("import " + graph::quote(path) + name, key);
  commands_.job = {};
  if (!done) return false;
  for (const graph::Node* node : session().graph().nodes())
    if (node->id >= first && node->type->name() == "transform") {
      commands_.run_now("select " + node->name, key);
      break;
    }
  session().history().end_merge();
  return true;
}

void SceneFiles::autosave_if_due(bool hand_on) {
  const auto now = std::chrono::steady_clock::now();
  if (now - autosaved_ < std::chrono::duration<double>(autosave_seconds) || hand_on) return;
  autosaved_ = now;
  keep_unsaved();
}

void SceneFiles::keep_unsaved() {
  if (!session().history().is_modified()) return autosave_.forget();
  if (session().graph().generation() == autosaved_generation_) return;
  try {
    autosave_.keep(graph::write_scene(session().graph()), session().scene_path());
    autosaved_generation_ = session().graph().generation();
    trace_.note("autosaved");
  } catch (const std::exception& error) {
    console_.add(LineKind::warning, error.what());
  }
}

void SceneFiles::leave_unsaved() {
  keep_unsaved();
  autosave_.leave();
}

void SceneFiles::recover(const Autosave::Left& left) {
  commands_.later([=, this] {
    try {
      viewpoint_.begin_anew();
      viewpoint_.history.clear();
      session().recover_scene(left.file.string(), left.scene_path);
      autosave_.keep(graph::write_scene(session().graph()), left.scene_path);
      Autosave::discard(left);
      console_.add(LineKind::note, left.scene_path.empty()
                                       ? "recovered what had not been saved"
                                       : left.scene_path + ": recovered; it is not saved yet");
      trace_.note("recovered");
    } catch (const std::exception& error) {
      console_.add(LineKind::error, error.what());
    }
  });
}

void SceneFiles::unless_unsaved(std::function<void()> task) {
  if (session().history().is_modified())
    after_unsaved = std::move(task);
  else
    commands_.later(std::move(task));
}

}  // namespace plinian::window
