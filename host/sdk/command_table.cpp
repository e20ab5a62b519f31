// Calls a plug-in's command through its table. No exception leaves a function that a plug-in calls.
#include "host/sdk/command_table.h"

#include <algorithm>

#include "host/graph/commands/session.h"
#include "host/graph/graph_error.h"
#include "host/sdk/inside_plugin.h"
#include "host/sdk/plain_text.h"

namespace plinian::sdk {

using graph::GraphError;

namespace {

struct CallState {
  graph::Session& session;
  const graph::Arguments& arguments;
  graph::CommandResult result;
  std::string error, failure, answers;
};

CallState& state_of(PlinianCall* call) {
  return *reinterpret_cast<CallState*>(call);
}

const PlinianCommandContext command_table = {
    sizeof(PlinianCommandContext),
    [](PlinianCall* c, const char* name) { return state_of(c).arguments.words(text_of(name)).size(); },
    [](PlinianCall* c, const char* name) { return int(state_of(c).arguments.has(text_of(name))); },
    [](PlinianCall* c, const char* name, std::size_t index) -> const char* {
      const auto& words = state_of(c).arguments.words(text_of(name));
      return index < words.size() ? words[index].text.c_str() : "";
    },
    [](PlinianCall* c, const char* line, const char** answers) {
      CallState& state = state_of(c);
      try {
        state.answers.clear();
        for (const std::string& answer : state.session.execute(text_of(line)))
          state.answers += (state.answers.empty() ? "" : "\n") + answer;
        if (answers) *answers = state.answers.c_str();
        return 1;
      } catch (const std::exception& error) {
        state.error = error.what();
        return 0;
      }
    },
    [](PlinianCall* c, const char* line) { state_of(c).result.push_back(text_of(line)); },
    [](PlinianCall* c, const char* message) { state_of(c).failure = text_of(message); },
    [](PlinianCall* c) { return state_of(c).error.c_str(); }};

graph::ArgumentKind kind_from(const std::string& kind) {
  using enum graph::ArgumentKind;
  if (kind == "number") return number;
  if (kind == "integer") return integer;
  if (kind == "node") return node;
  if (kind == "plug") return plug;
  if (kind == "path") return path;
  if (kind == "text") return text;
  throw GraphError("unknown kind of argument " + graph::shown(kind));
}

template <class Run>
graph::CommandResult called(graph::Session& session, const graph::Arguments& arguments, const Run& run) {
  CallState state{session, arguments, {}, "", "", ""};
  run(reinterpret_cast<PlinianCall*>(&state));
  if (!state.failure.empty()) throw GraphError(state.failure);
  return std::move(state.result);
}

}  // namespace

graph::CommandSpec command_from(const PlinianCommand* plain, const std::shared_ptr<DataCount>& data) {
  const PlinianCommand from = whole(plain);
  graph::CommandSpec spec;
  spec.name = text_of(from.name);
  spec.help = text_of(from.help);
  if (!graph::is_identifier(spec.name)) throw GraphError(graph::shown(spec.name) + " cannot name a command");
  if (!from.run) throw GraphError("the command '" + spec.name + "' does nothing");
  for (const PlinianArgument& a : all_of(from.parameters, from.parameter_count))
    spec.parameters.push_back(
        {text_of(a.name), kind_from(text_of(a.kind)), text_of(a.help), a.optional != 0, a.many != 0});
  for (const PlinianArgument& a : all_of(from.flags, from.flag_count)) {
    const std::string kind = text_of(a.kind);
    if (kind.empty() && a.many)
      throw GraphError("the command '" + spec.name + "': the flag -" + text_of(a.name) +
                       " takes no word, so that it cannot be given several times");
    spec.flags.push_back({text_of(a.name), text_of(a.help),
                          kind.empty() ? std::nullopt : std::optional(kind_from(kind)), a.many != 0});
  }
  spec.run = [run = from.run, user = from.user, data, name = spec.name](graph::Session& session,
                                                                        const graph::Arguments& arguments) {
    const InsidePlugin inside(data->owner, "running the command", name.c_str());
    try {
      return called(session, arguments, [&](PlinianCall* call) { run(user, &command_table, call); });
    } catch (const GraphError& error) {
      const std::string line = error.what();
      if (line.starts_with(name + ":") || line.starts_with(name + " ")) throw;
      // Of several runs within one another the outermost says its name.
      if (std::ranges::count(session.running(), name) > 1) throw;
      throw GraphError(name + ": " + line);
    }
  };
  return spec;
}

graph::FileType file_type_from(const PlinianFileType* plain, const std::shared_ptr<DataCount>& data) {
  const PlinianFileType from = whole(plain);
  graph::FileType type;
  type.name = text_of(from.name);
  type.help = text_of(from.help);
  type.extensions = words_of(from.extensions);
  if (type.name.empty()) throw GraphError("a file type needs a name");
  if (!from.import_file && !from.export_file)
    throw GraphError("the file type '" + type.name + "' is neither read nor written");
  const auto bound = [user = from.user, data](auto function, const char* doing) {
    return [=](graph::Session& session, const graph::Arguments& arguments) {
      const std::string path = arguments.text("file");
      const InsidePlugin inside(data->owner, doing, path.c_str());
      try {
        return called(session, arguments,
                      [&](PlinianCall* call) { function(user, &command_table, call, path.c_str()); });
      } catch (const GraphError& error) {
        const std::string line = error.what();
        if (line.find(path) != line.npos) throw;
        throw GraphError(path + ": " + line);
      }
    };
  };
  if (from.import_file) type.import_file = bound(from.import_file, "importing");
  if (from.export_file) type.export_file = bound(from.export_file, "exporting");
  return type;
}

MenuItem menu_entry_from(const PlinianMenuEntry* plain) {
  const PlinianMenuEntry from = whole(plain);
  MenuItem entry{text_of(from.path), text_of(from.command), text_of(from.help), ""};
  const std::string framed = "/" + entry.path + "/";
  if (entry.path.find('/') == entry.path.npos || framed.find("//") != framed.npos)
    throw GraphError("a menu entry is named MENU/ENTRY, not " + graph::shown(entry.path));
  if (graph::split_words(entry.command).empty())
    throw GraphError("the menu entry '" + entry.path + "' does nothing");
  return entry;
}

}  // namespace plinian::sdk
