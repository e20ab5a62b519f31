// import of volumes and of neutral scenes.
#include "core/media/procedural.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_loader.h"
#include "host/graph/graph_error.h"
#include "host/scene/file_types.h"
#include "host/scene/import_description.h"
#include "host/scene/volume_options.h"

namespace plinian::scene {

namespace {

// Advice for the command line, for scripts.
std::string as_flags(std::string text) {
  for (const VolumeOption& option : volume_options()) {
    const std::string advised = "--" + std::string(option.name);
    for (std::size_t at; (at = text.find(advised)) != text.npos;)
      text.replace(at, advised.size(), "-" + flag_name(option));
  }
  return text;
}

graph::CommandResult import_input(graph::Session& session, const graph::Arguments& arguments, bool volume) {
  SceneDescription description = describe_input(arguments.text("file"));
  for (const VolumeOption& option : volume_options())
    if (const std::string flag = flag_name(option); arguments.has(flag)) {
      try {
        set_scene_value(description, option.key, arguments.text(flag), "import: -" + flag);
      } catch (const graph::GraphError&) {
        throw;
      } catch (const std::runtime_error& error) {
        throw graph::GraphError(error.what());
      }
    }
  ImportOptions options;
  options.name_space = arguments.text("namespace");
  options.media_only = volume && !arguments.has("setup");
  options.progress = session.on_progress;
  ImportReport report;
  try {
    report = import_description(session, description, options);
  } catch (const SceneLoadCancelled&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw graph::GraphError(as_flags(error.what()));
  }
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
  std::vector<std::string> flags = {"setup"};
  std::vector<graph::CommandFlag> declared;
  for (const VolumeOption& option : volume_options()) {
    flags.push_back(flag_name(option));
    declared.push_back(
        {flags.back(), option.value_name + std::string(": ") + option.help, graph::ArgumentKind::text});
  }
  session.commands().add_flags("import", declared);
  session.file_types().add(
      {.name = "volume",
       .help = "A .vdb file, or a sequence of them: a volume with its medium.",
       .plugin = "",
       .extensions = {"vdb"},
       .words = {},
       .flags = flags,
       .import_file = [](graph::Session& s, const graph::Arguments& a) { return import_input(s, a, true); },
       .export_file = {}});
  session.file_types().add(
      {.name = "procedural medium",
       .help = "A medium that is computed, or a box or sphere of one density, by its name.",
       .plugin = "",
       .extensions = {},
       .words = named_media(),
       .flags = flags,
       .import_file = [](graph::Session& s, const graph::Arguments& a) { return import_input(s, a, true); },
       .export_file = {}});
  session.file_types().add(
      {.name = "neutral scene",
       .help = "A scene that other programs read and write as well.",
       .plugin = "",
       .extensions = {"json"},
       .words = {},
       .flags = flags,
       .import_file = [](graph::Session& s, const graph::Arguments& a) { return import_input(s, a, false); },
       .export_file = {}});
}

}  // namespace plinian::scene
