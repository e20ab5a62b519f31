// undo, redo, evaluate, cache, help.
#include <cmath>

#include "host/graph/commands/session.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

CommandResult repeat(const Session& session, const Arguments& arguments, const char* what,
                     const std::function<std::string()>& step) {
  CommandResult lines;
  const double number = arguments.number("steps").value_or(1.0);
  if (number < 1.0)
    throw GraphError(std::string(what) + ": STEPS is how often, from 1 on, not " + write_number(number));
  const int steps = int(number);
  for (int i = 0; i < steps; ++i) {
    try {
      const std::string name = step();
      if (name.empty()) {
        if (i > 0)
          session.note(std::string(what) + ": there " +
                       (i == 1 ? "was 1 step" : "were " + std::to_string(i) + " steps") + ", not " +
                       std::to_string(steps));
        break;
      }
      lines.push_back(name);
    } catch (const GraphError& error) {
      // What was done stays, and is answered.
      if (lines.empty()) throw;
      session.warn(error.what());
      break;
    }
  }
  if (lines.empty()) throw GraphError(std::string("there is nothing to ") + what);
  return lines;
}

CommandResult undo(Session& session, const Arguments& arguments) {
  return repeat(session, arguments, "undo", [&] { return session.history().undo(); });
}

CommandResult redo(Session& session, const Arguments& arguments) {
  return repeat(session, arguments, "redo", [&] { return session.history().redo(); });
}

CommandResult evaluate_plugs(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  std::vector<Plug> plugs;
  for (const std::string& name : arguments.texts("plugs")) {
    if (name.find('.') == name.npos) {
      const Node& node = graph.get(name);
      for (const AttributeIndex output : node.schema->outputs()) plugs.push_back({node.id, output});
    } else {
      for (const Plug& plug : leaf_plugs(graph, graph.plug(name))) plugs.push_back(plug);
    }
  }
  CommandResult lines;
  for (const Plug& plug : plugs) {
    const ResultPtr result = session.evaluator().evaluate(plug);
    if (result->error)
      throw GraphError(graph.name_of(plug) + ": " + session.evaluator().error_text(plug, *result));
    std::string text;
    if (const auto* data = std::get_if<DataPtr>(&result->value))
      text = *data ? (*data)->type + ", " + std::to_string((*data)->bytes) + " bytes" : "nothing";
    else if (plug.component < 0)
      text = write_value(graph.attribute(plug).spec, result->value, graph.names());
    else
      text = write_value({.name = "component"}, result->value);
    lines.push_back(graph.name_of(plug) + " " + text);
    if (arguments.has("check"))
      for (const std::string& line : session.evaluator().check(plug)) throw GraphError(line);
  }
  return lines;
}

CommandResult cache(Session& session, const Arguments& arguments) {
  constexpr double mebibyte = 1 << 20;
  const auto in_tenths = [](std::size_t bytes) {
    return write_number(std::round(10.0 * double(bytes) / mebibyte) / 10.0);
  };
  ValueCache& values = session.evaluator().cache();
  if (const auto limit = arguments.number("limit")) {
    if (!(*limit >= 0.0 && *limit <= 1e9)) throw GraphError("cache: -limit is from 0 to 1e9 MiB");
    values.set_budget(std::size_t(*limit * mebibyte));
  }
  if (arguments.has("clear")) values.clear();
  return {in_tenths(values.bytes()) + " of " + in_tenths(values.budget()) + " MiB"};
}

CommandResult help(Session& session, const Arguments& arguments) {
  if (arguments.has("command")) return help_lines(session.commands().get(arguments.text("command")));
  CommandResult lines;
  for (const std::string& name : session.commands().names()) {
    std::string line = name;
    line.resize(std::max<std::size_t>(line.size() + 1, 17), ' ');
    lines.push_back(line + session.commands().get(name).help);
  }
  return lines;
}

}  // namespace

void add_session_commands(CommandRegistry& commands) {
  using enum ArgumentKind;
  commands.add({.name = "undo",
                .help = "Takes back what was done last and answers with it.",
                .parameters = {{"steps", integer, "how often (1)", true}},
                .run = undo,
                .handles_history = true});
  commands.add({.name = "redo",
                .help = "Does again what was taken back last.",
                .parameters = {{"steps", integer, "how often (1)", true}},
                .run = redo,
                .handles_history = true});
  commands.add({.name = "evaluate",
                .help = "Computes outputs and answers with a line for each.",
                .parameters = {{"plugs", plug, "node.output, or a node for all of its outputs", false, true}},
                .flags = {{"check", "computes all anew as well and fails where the two differ", {}}},
                .run = evaluate_plugs});
  commands.add(
      {.name = "cache",
       .help = "Answers how much memory computed values take that are kept for when they are wanted again, "
               "and how much they may.",
       .parameters = {},
       .flags = {{"clear", "lets go of those that nothing shows; they are computed anew when wanted", {}},
                 {"limit", "[MiB] that they may take; those not wanted for longest go first", number}},
       .run = cache});
  commands.add({.name = "help",
                .help = "Lists the commands, or shows what one takes.",
                .parameters = {{"command", command, "its name", true}},
                .run = help});
}

}  // namespace plinian::graph
