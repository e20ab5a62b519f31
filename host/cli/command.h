// What every subcommand of the program is made of. A command is one file plus one line in main.cpp.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace plinian::cli {

/// Exit codes of the program.
inline constexpr int exit_success = 0;
inline constexpr int exit_failure = 1;      // bad input, failed comparison
inline constexpr int exit_usage = 2;        // wrong arguments
inline constexpr int exit_cancelled = 130;  // Ctrl-C, as shells count it

/// Runs a parsed command; returns the exit code. command_line: the whole of it, as a shell would take it
/// again. Errors are exceptions, told in one line by main.
using Run = std::function<int(const std::string& command_line)>;

/// Declares a command's arguments on `app` and returns what runs it.
Run set_up_view(CLI::App& app);
Run set_up_render(CLI::App& app);
Run set_up_compare(CLI::App& app);
Run set_up_bench(CLI::App& app);
Run set_up_info(CLI::App& app);
Run set_up_probe(CLI::App& app);
Run set_up_make(CLI::App& app);
Run set_up_sheet(CLI::App& app);
Run set_up_run(CLI::App& app);
Run set_up_plugins(CLI::App& app);

struct Command {
  const char* name;
  const char* summary;  // one line
  Run (*set_up)(CLI::App& app);
};

}  // namespace plinian::cli
