// import of volumes and of neutral scenes.
#include <filesystem>

#include "core/media/procedural.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_loader.h"
#include "host/graph/graph_error.h"
#include "host/scene/file_types.h"
#include "host/scene/import_description.h"
#include "host/scene/medium_names.h"
#include "host/scene/volume_options.h"

namespace plinian::scene {

namespace {

// Advice for the command line, for scripts.
std::string as_flags(std::string text) {
  std::vector<std::pair<std::string, std::string>> flags = {{"--vdb-time-limit", "-vdbTimeLimit"},
                                                            {"--vdb-memory-limit", "-vdbMemoryLimit"}};
  for (const VolumeOption& option : volume_options())
    flags.emplace_back("--" + std::string(option.name), "-" + flag_name(option));
  for (const auto& [advised, flag] : flags)
    for (std::size_t at; (at = text.find(advised)) != text.npos;) text.replace(at, advised.size(), flag);
  return text;
}

graph::CommandResult import_input(graph::Session& session, const graph::Arguments& arguments, bool volume) {
  SceneDescription description = describe_input(arguments.text("file"));
  ImportOptions options;
  options.name_space = arguments.text("namespace");
  options.media_only = volume && !arguments.has("setup");
  options.progress = session.on_progress;
  options.vdb_time_limit_s = arguments.number("vdbTimeLimit").value_or(0.0);
  if (arguments.has("vdbTimeLimit") && !(options.vdb_time_limit_s > 0.0))
    throw graph::GraphError("import: -vdbTimeLimit expects a number of seconds above 0");
  if (arguments.has("name")) {
    if (!graph::is_node_name(arguments.text("name")))
      throw graph::GraphError("import: -name: " + graph::shown(arguments.text("name")) +
                              " cannot name a node: a letter or _, then letters, digits and _");
    description.media.front().name =
        free_medium_name(session.graph(), arguments.text("name"), options.name_space);
  }
  ImportReport report;
  try {
    for (const VolumeOption& option : volume_options())
      if (const std::string flag = flag_name(option); arguments.has(flag))
        set_scene_value(description, option.key, arguments.text(flag), "import: -" + flag);
    if (arguments.has("vdbMemoryLimit"))
      options.vdb_memory_limit_bytes =
          parse_bytes(arguments.text("vdbMemoryLimit"), "import: -vdbMemoryLimit");
    report = import_description(session, description, options);
  } catch (const SceneLoadCancelled&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw graph::GraphError(as_flags(error.what()));
  }
  for (const std::string& line : report.notes) session.note(as_flags(line));
  for (const std::string& line : report.warnings) session.warn(as_flags(line));
  if (options.media_only && !report.extent.empty())
    session.note(std::filesystem::path(arguments.text("file")).filename().string() + ": " + report.extent);
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
  declared.push_back(
      {"vdbTimeLimit", "SECONDS for reading a .vdb (grows with the file)", graph::ArgumentKind::number});
  declared.push_back({"vdbMemoryLimit", "BYTES for reading a .vdb, such as 4G", graph::ArgumentKind::text});
  flags.insert(flags.end(), {"vdbTimeLimit", "vdbMemoryLimit"});
  declared.push_back({"name", "of a volume: what its medium is called; a number makes it unique (medium)",
                      graph::ArgumentKind::text});
  std::vector<std::string> flags_of_one = flags;  // of what is no scene
  flags_of_one.push_back("name");
  session.commands().add_flags("import", declared);
  session.file_types().add(
      {.name = "volume",
       .help = "A .vdb file, or a sequence of them: a volume with its medium.",
       .plugin = "",
       .extensions = {"vdb"},
       .words = {},
       .flags = flags_of_one,
       .import_file = [](graph::Session& s, const graph::Arguments& a) { return import_input(s, a, true); },
       .export_file = {}});
  session.file_types().add(
      {.name = "procedural medium",
       .help = "A medium that is computed, or a box or sphere of one density, by its name.",
       .plugin = "",
       .extensions = {},
       .words = named_media(),
       .flags = flags_of_one,
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
