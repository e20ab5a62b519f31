// newScene, open, save, import, export.
#include <filesystem>
#include <set>

#include "core/files/atomic_file.h"
#include "host/graph/commands/session.h"
#include "host/graph/edits/editor.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

void refuse_unsaved(Session& session, const Arguments& arguments, const std::string& command) {
  if (session.history().is_modified() && !arguments.has("force"))
    throw GraphError(command + ": the scene has unsaved changes: save it first, or give -force");
}

CommandResult new_scene(Session& session, const Arguments& arguments) {
  refuse_unsaved(session, arguments, "newScene");
  session.new_scene();
  return {};
}

CommandResult open(Session& session, const Arguments& arguments) {
  refuse_unsaved(session, arguments, "open");
  session.open_scene(arguments.text("file"));
  return {};
}

CommandResult save(Session& session, const Arguments& arguments) {
  session.save_scene(arguments.text("file"));
  return {session.scene_path()};
}

CommandResult import(Session& session, const Arguments& arguments) {
  const std::string name_space = arguments.text("namespace");
  if (!name_space.empty() && !is_node_name(name_space))
    throw GraphError("import: " + shown(name_space) + " cannot be a namespace: letters, digits and _");
  if (const FileType* type = session.file_types().find(arguments.text("file"))) {
    if (!type->import_file)
      throw GraphError("import: files of the type '" + type->name + "' can only be written");
    return type->import_file(session, arguments);
  }
  return names_of(session.graph(), session.import_scene(arguments.text("file"), name_space));
}

// Nodes with the transforms above them, which say where they are, and where asked for with all that drives
// them.
std::vector<NodeId> exported_nodes(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  std::vector<NodeId> all = nodes_or_selection(session, arguments.texts("nodes"));
  std::set<NodeId> wanted(all.begin(), all.end());
  const auto add = [&](NodeId id) {
    if (id && wanted.insert(id).second) all.push_back(id);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Node& node = *graph.find(all[i]);
    add(node.parent);
    if (!arguments.has("inputs")) continue;
    for (const Input& input : node.inputs) add(input.source.node);
  }
  return all;
}

CommandResult export_nodes(Session& session, const Arguments& arguments) {
  if (const FileType* type = session.file_types().find(arguments.text("file"))) {
    if (!type->export_file)
      throw GraphError("export: files of the type '" + type->name + "' can only be read");
    return type->export_file(session, arguments);
  }
  try {
    const std::string file = arguments.text("file");
    save_scene(file, write_scene(session.graph(), exported_nodes(session, arguments),
                                 std::filesystem::absolute(file).lexically_normal().parent_path()));
  } catch (const FileError& error) {
    throw GraphError(std::string("export: ") + error.what());
  }
  return {};
}

}  // namespace

void add_file_commands(CommandRegistry& commands) {
  using enum ArgumentKind;
  commands.add({.name = "newScene",
                .help = "Begins an empty scene.",
                .flags = {{"force", "even where there are unsaved changes", {}}},
                .run = new_scene,
                .handles_history = true});
  commands.add({.name = "open",
                .help = "Opens a scene in place of this one.",
                .parameters = {{"file", path, "scene file"}},
                .flags = {{"force", "even where there are unsaved changes", {}}},
                .run = open,
                .handles_history = true});
  commands.add({.name = "save",
                .help = "Saves the scene and answers with the file; the one before stays as FILE.bak.",
                .parameters = {{"file", path, "scene file; else the one it was opened from", true}},
                .run = save});
  commands.add({.name = "import",
                .help = "Adds what a file holds to the scene and answers with the names of its nodes.",
                .parameters = {{"file", path,
                                "a scene, a volume or a sequence of them, a procedural medium such as ash, a "
                                "camera, or a file of a type that a plug-in reads"}},
                .flags = {{"namespace", "goes before their names, with a colon", text},
                          {"setup",
                           "of a volume: with a camera, lights and settings, as a picture of it alone has",
                           {}}},
                .run = import});
  commands.add({.name = "export",
                .help = "Writes nodes, and the transforms above them, to a scene file of their own, or to a "
                        "file of a type "
                        "that a plug-in writes.",
                .parameters = {{"file", path, "scene file"},
                               {"nodes", node, "names or patterns; else the selection", true, true}},
                .flags = {{"inputs", "with all that drives them", {}}},
                .run = export_nodes});
}

}  // namespace plinian::graph
