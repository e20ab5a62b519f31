// plinian run: a script of commands, as the console of a window would take them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/input_lines.h"
#include "host/cli/interruption.h"
#include "host/cli/progress.h"
#include "host/cli/render_command.h"
#include "host/graph/files/scene_reader.h"
#include "host/graph/graph_error.h"
#include "host/scene/workspace.h"

namespace plinian::cli {

namespace {

struct RunArguments {
  std::string script;
  std::vector<std::string> scenes;  // at most one
  bool echo = false, quiet = false, keep_going = false;
};

constexpr const char* examples = R"(
Examples:
  plinian run setup.pln
  plinian run relight.pln shot.plinian
  echo 'ls -type camera' | plinian run - shot.plinian
A script is one command a line; '#' begins a comment. 'plinian plugins --commands' lists the commands, and the command
'help NAME' shows what one takes. What commands answer goes to standard output. Lines of standard input are run as they
come, so that whoever writes them can wait for an answer.)";

// The lines of a file, or of standard input as they come. Throws where it is a scene.
std::function<std::optional<std::string>()> lines_of(const std::string& script) {
  const auto refuse_scene = [script](std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    if (text.starts_with("plinian scene "))
      throw std::runtime_error(
          fmt::format("{0}: is a scene, not a script: 'plinian render {0}' makes a picture, "
                      "'plinian run SCRIPT {0}' runs a script on it",
                      script));
  };
  if (script == "-")
    return [refuse_scene, lines = std::make_shared<InputLines>(graph::longest_script_line),
            first = true]() mutable {
      std::optional<std::string> line = lines->next();
      if (std::exchange(first, false) && line) refuse_scene(*line);
      return line;
    };
  auto file = std::make_shared<std::istringstream>(graph::read_text_file(script));
  refuse_scene(file->view());
  return [file]() -> std::optional<std::string> {
    std::string line;
    if (!std::getline(*file, line)) return std::nullopt;
    return line;
  };
}

int run_run(const RunArguments& arguments) {
  set_quiet(arguments.quiet);
  const auto next = lines_of(arguments.script);
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  session.on_warning = [&](const std::string& line) { warn(session.script_place + line); };
  session.on_note = [](const std::string& line) { note(line); };
  session.evaluator().set_interrupt(&interrupt_flag());
  std::optional<ProgressBar> bar;  // of the computation that a command waits for
  graph::Plug computed;
  session.evaluator().on_progress = [&](const graph::Plug& plug, double share, std::string_view what) {
    if (!bar || plug != computed) bar.emplace(session.graph().name_of(plug));
    computed = plug;
    if (!what.empty()) bar->set_detail(std::string(what));
    (*bar)(share);
  };
  add_render_command(workspace);
  if (!arguments.scenes.empty()) session.open_scene(arguments.scenes.front());
  session.on_echo = [&](const std::string& line) {
    bar.reset();
    if (arguments.echo) print("> " + line + "\n");
  };
  int exit_code = exit_success;
  const auto tell_error = [&](const std::string& line) {
    bar.reset();
    error(line);
    exit_code = exit_failure;
  };
  graph::run_script(
      session, next, arguments.script == "-" ? "standard input" : arguments.script,
      [](const std::string& line) {
        print(line + "\n");
        std::fflush(stdout);  // what was answered is out, whatever comes
      },
      arguments.keep_going ? std::function<void(const std::string&)>(tell_error) : nullptr);
  return exit_code;
}

}  // namespace

Run set_up_run(CLI::App& app) {
  auto arguments = std::make_shared<RunArguments>();
  app.footer(examples);
  app.add_option("SCRIPT", arguments->script, "a file of commands; - for standard input")->required();
  app.add_option("SCENE", arguments->scenes, "a .plinian scene to run it on (an empty one)")->expected(0, 1);
  app.add_flag("--echo", arguments->echo, "print each command as it is run");
  app.add_flag("-k,--keep-going", arguments->keep_going,
               "go on behind a line that fails; the exit code is 1 all the same");
  app.add_flag("-q,--quiet", arguments->quiet, "no notes");
  return [arguments](const std::string&) { return run_run(*arguments); };
}

}  // namespace plinian::cli
