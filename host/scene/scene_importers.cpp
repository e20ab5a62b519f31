// import of volumes and of neutral scenes.
#include "core/media/procedural.h"
#include "core/scene/scene_file.h"
#include "host/graph/graph_error.h"
#include "host/scene/file_types.h"
#include "host/scene/import_description.h"

namespace plinian::scene {

namespace {

graph::CommandResult import_input(graph::Session& session, const graph::Arguments& arguments, bool volume) {
  SceneDescription description = describe_input(arguments.text("file"));
  ImportOptions options;
  options.name_space = arguments.text("namespace");
  options.media_only = volume && !arguments.has("setup");
  options.progress = session.on_progress;
  const ImportReport report = import_description(session, description, options);
  for (const std::string& line : report.notes) session.note(line);
  for (const std::string& line : report.warnings) session.warn(line);
  return report.nodes;
}

// Media that are no file.
std::vector<std::string> named_media() {
  std::vector<std::string> names = procedural_kinds();
  names.insert(names.end(), analytic_media.begin(), analytic_media.end());
  return names;
}

}  // namespace

void add_scene_importers(graph::Session& session) {
  session.file_types().add(
      {.name = "volume",
       .help = "A .vdb file, or a sequence of them: a volume with its medium.",
       .plugin = "",
       .extensions = {"vdb"},
       .words = {},
       .import_file = [](graph::Session& s, const graph::Arguments& a) { return import_input(s, a, true); },
       .export_file = {}});
  session.file_types().add(
      {.name = "procedural medium",
       .help = "A medium that is computed, or a box or sphere of one density, by its name.",
       .plugin = "",
       .extensions = {},
       .words = named_media(),
       .import_file = [](graph::Session& s, const graph::Arguments& a) { return import_input(s, a, true); },
       .export_file = {}});
  session.file_types().add(
      {.name = "neutral scene",
       .help = "A scene that other programs read and write as well.",
       .plugin = "",
       .extensions = {"json"},
       .words = {},
       .import_file = [](graph::Session& s, const graph::Arguments& a) { return import_input(s, a, false); },
       .export_file = {}});
}

}  // namespace plinian::scene
