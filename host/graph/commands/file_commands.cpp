// newScene, open, save, import, export.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/files/atomic_file.h"
#include "core/scene/nearest_word.h"
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

constexpr const char* scene_extension = ".plinian";

// What save adds open adds, where there is no file of the name that is given.
std::string existing_scene(const std::string& file) {
  std::error_code error;
  const bool bare = std::filesystem::path(file).extension().empty() && !std::filesystem::exists(file, error);
  return bare && std::filesystem::exists(file + scene_extension, error) ? file + scene_extension : file;
}

CommandResult open(Session& session, const Arguments& arguments) {
  refuse_unsaved(session, arguments, "open");
  session.open_scene(existing_scene(arguments.text("file")));
  return {};
}

// The name of a scene that is to be written: by it every command knows that it is one.
std::string scene_name(const std::string& command, const std::string& file, const std::string& others = "") {
  std::error_code error;
  if (std::filesystem::path(file).filename().empty() || std::filesystem::is_directory(file, error))
    throw GraphError(command + ": " + file + ": is a folder: name a file in it");
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == scene_extension) return file;
  if (extension.empty()) return file + scene_extension;
  throw GraphError(command + ": " + file + ": the name of a scene ends in " + scene_extension + others);
}

CommandResult save(Session& session, const Arguments& arguments) {
  const std::string file = arguments.text("file");
  session.save_scene(file.empty() ? file : scene_name("save", file));
  return {session.scene_path()};
}

// Puts the nodes that were made from the number `first` on into a namespace, unless their maker did, or a
// scene has but one of them. Answers that name them follow.
void put_into(Session& session, NodeId first, const std::string& name_space, CommandResult& answers) {
  const Graph& graph = session.graph();
  std::vector<NodeId> made;
  for (const Node* node : graph.nodes())
    if (node->id >= first && !node->name.starts_with(name_space + ":") && !node->type->spec().unique)
      made.push_back(node->id);
  for (const NodeId id : made) {
    const std::string before = graph.find(id)->name;
    const std::string after = session.editor().rename(id, name_space + ":" + before);
    std::replace(answers.begin(), answers.end(), before, after);
  }
}

// The namespace itself where nothing is in it yet, else with the lowest number behind it that makes it so:
// what is imported is found together.
std::string fresh_namespace(const Graph& graph, const std::string& wanted) {
  const std::vector<const Node*> nodes = graph.nodes();
  const auto is_there = [&](const std::string& name_space) {
    return std::ranges::any_of(nodes,
                               [&](const Node* node) { return node->name.starts_with(name_space + ":"); });
  };
  if (!is_there(wanted)) return wanted;
  std::string base = wanted;
  while (base.back() >= '0' && base.back() <= '9') base.pop_back();
  int number = 1;
  while (is_there(base + std::to_string(number))) ++number;
  return base + std::to_string(number);
}

// A flag that means nothing for a file would be passed over in silence.
void check_flags(const CommandSpec& import, const FileType* type, const Arguments& arguments) {
  for (const CommandFlag& flag : import.flags) {
    const std::string& name = flag.name;
    const bool everywhere = name == "namespace" || name == "merge";
    if (!arguments.has(name) || everywhere || (type && std::ranges::count(type->flags, name))) continue;
    // Plug-ins are given what they were always given.
    if (type && !type->plugin.empty() && name == "setup") continue;
    throw GraphError("import: -" + name + " means nothing for " +
                     (type ? "files of the type '" + type->name + "'" : "scenes") +
                     (type && !type->flags.empty() ? ", which take -" + join(type->flags, ", -") : ""));
  }
}

// What is taken for a scene because nothing else takes it, and is none.
void check_is_scene(Session& session, const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension.empty() || extension == scene_extension || std::filesystem::is_directory(file)) return;
  constexpr std::string_view greeting = "plinian scene ", mark = "\xef\xbb\xbf";
  std::string begin(mark.size() + greeting.size(), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), std::streamsize(begin.size()));
  if (begin.starts_with(greeting) || begin == std::string(mark) + std::string(greeting)) return;
  const auto& elsewhere = session.file_types().elsewhere;
  std::string hint = elsewhere ? elsewhere(extension.substr(1)) : "";
  const bool picture = extension == ".png" && std::ranges::count(session.commands().names(), "loadReference");
  if (picture) hint = "; a picture to compare with is loaded by loadReference";
  std::vector<std::string> known = {scene_extension};
  for (const FileType* type : session.file_types().all())
    if (type->import_file)
      for (const std::string& own : type->extensions) known.push_back("." + own);
  throw GraphError("import: " + file + ": no type of file that is read here ends in " + extension +
                   (hint.empty() || picture ? "; there are: " + join(known) : "") + hint);
}

CommandResult import(Session& session, const Arguments& arguments) {
  std::string name_space = arguments.text("namespace");
  if (!name_space.empty() && !is_node_name(name_space))
    throw GraphError("import: " + shown(name_space) +
                     " cannot be a namespace: a letter or _, then letters, digits and _");
  if (arguments.has("merge") && name_space.empty())
    throw GraphError("import: -merge says what becomes of -namespace, which is not given");
  const FileType* type = session.file_types().find(arguments.text("file"));
  if (type && !type->import_file)
    throw GraphError("import: files of the type '" + type->name + "' can only be written");
  if (const std::string file = arguments.text("file"); !type && !std::filesystem::exists(file))
    throw GraphError(file + ": there is no such file" + session.file_types().nearest_word(file));
  if (!type) check_is_scene(session, arguments.text("file"));
  check_flags(session.commands().get("import"), type, arguments);
  Arguments settled = arguments;
  if (!name_space.empty() && !arguments.has("merge")) {
    name_space = fresh_namespace(session.graph(), name_space);
    if (name_space != arguments.text("namespace"))
      session.note("import: the namespace " + arguments.text("namespace") + " is there already: " +
                   arguments.text("file") + " goes into " + name_space + " (-merge puts it into that one)");
    settled.set("namespace", {{name_space, false}});
  }
  if (!type) return names_of(session.graph(), session.import_scene(arguments.text("file"), name_space));
  const NodeId first = session.graph().new_id();
  CommandResult answers = type->import_file(session, settled);
  if (!name_space.empty()) put_into(session, first, name_space, answers);
  return answers;
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
    add(graph.find(node.kept_parent) ? node.kept_parent : NodeId());
    if (!arguments.has("inputs")) continue;
    for (const Input& input : node.inputs) add(input.source.node);
    for (const KeptLine& kept : node.kept) add(kept.source);
  }
  return all;
}

// What drives nodes and is not written with them: a shape without its volume shows nothing.
void note_left_out(Session& session, const std::vector<NodeId>& nodes) {
  const Graph& graph = session.graph();
  const std::set<NodeId> written(nodes.begin(), nodes.end());
  std::vector<std::string> cut;
  for (const NodeId id : nodes)
    for (const Input& input : graph.find(id)->inputs)
      if (!written.contains(input.source.node))
        cut.push_back(graph.name_of({id, input.attribute, input.element, input.component}) + " from " +
                      graph.name_of(input.source));
  if (cut.empty()) return;
  const std::string more = cut.size() > 1 ? " and " + std::to_string(cut.size() - 1) + " more" : "";
  session.note("export: without the connection of " + cut.front() + more +
               ": -inputs takes what drives the nodes along");
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
  std::string file = arguments.text("file");
  const FileType* type = session.file_types().find(file);
  std::string others;
  for (const FileType* other : session.file_types().all())
    if (other->export_file)
      others += (others.empty() ? "; besides scenes there are: ." : ", .") + join(other->extensions, ", .");
  if (type && !type->export_file)
    throw GraphError("export: files of the type '" + type->name +
                     "' can only be read: the name of a scene ends in " + scene_extension + others);
  if (!type) file = scene_name("export", file, others);
  if (file != arguments.text("file")) session.note("export: writes " + file);
  const std::vector<NodeId> nodes = exported_nodes(session, arguments);
  try {
    if (type) return export_as(*type, session, arguments, nodes);
    note_left_out(session, nodes);
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
  commands.add(
      {.name = "import",
       .help = "Adds what a file holds to the scene and answers with the names of its nodes.",
       .parameters = {{"file", path,
                       "a scene, a volume or a sequence of them, a procedural medium such as ash, a "
                       "camera, or a file of a type that a plug-in reads"}},
       .flags = {{"namespace",
                  "goes before their names, with a colon; a number makes it one that is not there", text},
                 {"merge", "puts them into that namespace even where it is there already", {}},
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
