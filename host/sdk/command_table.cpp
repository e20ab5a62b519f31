// Calls a plug-in's command through its table. No exception leaves a function that a plug-in calls.
#include "host/sdk/command_table.h"

#include "host/graph/commands/session.h"
#include "host/graph/graph_error.h"
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

}  // namespace

graph::CommandSpec command_from(const PlinianCommand* plain) {
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
    spec.flags.push_back(
        {text_of(a.name), text_of(a.help), kind.empty() ? std::nullopt : std::optional(kind_from(kind))});
  }
  spec.run = [run = from.run, user = from.user](graph::Session& session, const graph::Arguments& arguments) {
    CallState state{session, arguments, {}, "", "", ""};
    run(user, &command_table, reinterpret_cast<PlinianCall*>(&state));
    if (!state.failure.empty()) throw GraphError(state.failure);
    return std::move(state.result);
  };
  return spec;
}

}  // namespace plinian::sdk
