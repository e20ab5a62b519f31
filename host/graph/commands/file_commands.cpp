// newScene, open, save, import, export.
#include <algorithm>
#include <filesystem>
#include <set>

#include "core/files/atomic_file.h"
#include "host/graph/commands/session.h"
#include "host/graph/edits/editor.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/hierarchy.h"

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

// Puts the nodes that were made from the number `first` on into a namespace, unless their maker did. Answers
// that name them follow.
void put_into(Session& session, NodeId first, const std::string& name_space, CommandResult& answers) {
  const Graph& graph = session.graph();
  std::vector<NodeId> made;
  for (const Node* node : graph.nodes())
    if (node->id >= first && !node->name.starts_with(name_space + ":")) made.push_back(node->id);
  for (const NodeId id : made) {
    const std::string before = graph.find(id)->name;
    const std::string after = session.editor().rename(id, name_space + ":" + before);
    std::replace(answers.begin(), answers.end(), before, after);
  }
}

CommandResult import(Session& session, const Arguments& arguments) {
  const std::string name_space = arguments.text("namespace");
  if (!name_space.empty() && !is_node_name(name_space))
    throw GraphError("import: " + shown(name_space) + " cannot be a namespace: letters, digits and _");
  if (const FileType* type = session.file_types().find(arguments.text("file"))) {
    if (!type->import_file)
      throw GraphError("import: files of the type '" + type->name + "' can only be written");
    const NodeId first = session.graph().new_id();
    CommandResult answers = type->import_file(session, arguments);
    if (!name_space.empty()) put_into(session, first, name_space, answers);
    return answers;
  }
  if (const std::string file = arguments.text("file"); !std::filesystem::exists(file))
    throw GraphError(file + ": there is no such file" + session.file_types().nearest_word(file));
  return names_of(session.graph(), session.import_scene(arguments.text("file"), name_space));
}

// Nodes with what is under them, with the transforms above them, which say where they are, and where asked
// for with all that drives them.
std::vector<NodeId> exported_nodes(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  std::vector<NodeId> all = with_descendants(graph, nodes_or_selection(session, arguments.texts("nodes")));
  std::set<NodeId> wanted(all.begin(), all.end());
  const auto add = [&](NodeId id) {
    if (id && wanted.insert(id).second) all.push_back(id);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Node& node = *graph.find(all[i]);
    add(node.parent);
    if (!arguments.has("inputs")) continue;
    for (const Input& input : node.inputs) add(input.source.node);
    for (const KeptLine& kept : node.kept) add(kept.source);
  }
  return all;
}

// Has nodes written by the exporter of a file type: whole, or not at all.
CommandResult export_as(const FileType& type, Session& session, const Arguments& arguments,
                        const std::vector<NodeId>& nodes) {
  const std::string file = arguments.text("file");
  Arguments resolved = arguments;
  std::vector<Word> names;
  for (const std::string& name : names_of(session.graph(), nodes)) names.push_back({name, false});
  resolved.set("nodes", std::move(names));
  CommandResult answers;
  write_file(file, [&](const std::string& temporary) {
    resolved.set("file", {{temporary, true}});
    try {
      answers = type.export_file(session, resolved);
    } catch (const GraphError& error) {
      std::string message = error.what();
      for (std::size_t at; (at = message.find(temporary)) != message.npos;)
        message.replace(at, temporary.size(), file);
      throw GraphError(message);
    }
    std::error_code gone;
    const auto size = std::filesystem::file_size(temporary, gone);
    if (gone || size == 0)
      throw GraphError("export: the file type '" + type.name + "' wrote nothing to " + file +
                       ", which is left as it was: name nodes that it can write");
  });
  return answers;
}

CommandResult export_nodes(Session& session, const Arguments& arguments) {
  const std::string file = arguments.text("file");
  const FileType* type = session.file_types().find(file);
  if (type && !type->export_file)
    throw GraphError("export: files of the type '" + type->name + "' can only be read");
  const std::vector<NodeId> nodes = exported_nodes(session, arguments);
  try {
    if (type) return export_as(*type, session, arguments, nodes);
    save_scene(file, write_scene(session.graph(), nodes,
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
                .help =
                    "Writes nodes, what is under them and the transforms above them to a scene file of their "
                    "own, or to a file of a type that a plug-in writes.",
                .parameters = {{"file", path, "a scene file, or one of a type that a plug-in writes"},
                               {"nodes", node, "names or patterns; else the selection", true, true}},
                .flags = {{"inputs", "with all that drives them", {}}},
                .run = export_nodes});
}

}  // namespace plinian::graph
