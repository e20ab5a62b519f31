// plinian view: the window.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <memory>

#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/interruption.h"
#include "host/cli/scene_arguments.h"
#include "host/window/window.h"

namespace plinian::cli {

namespace {

struct ViewArguments {
  std::string input = "ash", size, trace;
  bool empty = false;
  double autosave_seconds = 30.0;
};

constexpr const char* examples = R"(
Examples:
  plinian                               the default scene, a column of ash
  plinian view smoke.vdb                a volume of your own, framed and lit
  plinian view shot.plinian
Alt and the mouse move the camera (or Ctrl+Alt): left tumbles, middle tracks, right and the wheel dolly. F1 lists
the hotkeys. Without a display, 'plinian render' makes pictures.)";

}  // namespace

Run set_up_view(CLI::App& app) {
  auto arguments = std::make_shared<ViewArguments>();
  app.footer(examples);
  app.add_option("INPUT", arguments->input,
                 "a .plinian scene, a .vdb file or a sequence of them, a .json scene, "
                 "or a procedural medium")
      ->capture_default_str();
  app.add_flag("--empty", arguments->empty, "begin with an empty scene");
  app.add_option("--size", arguments->size, "of the window")->type_name("WIDTHxHEIGHT");
  app.add_option("--autosave", arguments->autosave_seconds,
                 "how often unsaved changes are kept aside, to be offered after a crash")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  app.add_option("--trace", arguments->trace, "note in FILE what happens in the window and when, a line each")
      ->type_name("FILE");
  return [arguments](const std::string&) {
    window::WindowOptions options;
    options.input = arguments->empty ? "" : arguments->input;
    if (!arguments->size.empty()) options.size = parse_size(arguments->size);
    options.autosave_seconds = arguments->autosave_seconds;
    options.trace = arguments->trace;
    options.interrupted = &interrupt_flag();
    options.on_no_end = [](const std::string& line) {
      error(line);
      std::_Exit(exit_failure);
    };
    window::run_window(options);
    return interrupted() ? exit_cancelled : exit_success;
  };
}

}  // namespace plinian::cli
