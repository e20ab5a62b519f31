// The plinian program: finds the command, runs it, and tells every error in one line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>

#include "core/scene/nearest_word.h"
#include "core/scene/renderer.h"
#include "core/scene/scene_loader.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/interruption.h"
#include "host/cli/render_command.h"
#include "host/graph/commands/session.h"
#include "host/scene/workspace.h"
#include "host/sdk/inside_plugin.h"
#include "host/window/window.h"

namespace plinian::cli {

namespace {

constexpr Command commands[] = {
    {"view", "open the window on a scene or a volume", set_up_view},
    {"render", "make a picture of a volume or a scene", set_up_render},
    {"compare", "measure how far one picture is from another", set_up_compare},
    {"bench", "time maps, frames and edits on this machine", set_up_bench},
    {"info", "show what is in a .vdb file, a picture or a scene", set_up_info},
    {"probe", "follow a pixel's ray and its lights, exactly and by their maps", set_up_probe},
    {"make", "write a procedural medium to a .vdb file", set_up_make},
    {"sheet", "pictures side by side, with heat maps", set_up_sheet},
    {"run", "run a script of commands on a scene", set_up_run},
    {"plugins", "list plug-ins, node types and commands", set_up_plugins},
};

constexpr const char* overview = R"(Plinian renders smoke, ash and dust that are too dense for anything else.

  plinian                               the window, with the default scene
  plinian view smoke.vdb                ... with a volume of your own
  plinian render ash -o ash.png         the default scene, a column of ash
  plinian render smoke.vdb -o smoke.png a volume of your own, framed and lit
  plinian info smoke.vdb                what is in it

Commands:
)";

std::string overview_text() {
  std::string text = overview;
  for (const Command& command : commands) text += fmt::format("  {:<9} {}\n", command.name, command.summary);
  return text + "\n'plinian COMMAND --help' shows a command's arguments and examples.\n";
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

// Options with the name of their value and their default; the library would add types and ranges, which help
// lines say in words.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() {
    column_width(36);
    label("REQUIRED", "");
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text;
    const std::string type = option->get_type_name();
    if (!type.empty() && !option->get_positional()) text += " " + type.substr(0, type.find(':'));
    if (!option->get_default_str().empty()) text += " (" + option->get_default_str() + ")";
    return text;
  }
  std::string make_group(std::string group, bool positional,
                         std::vector<const CLI::Option*> options) const override {
    const bool first = positional || group == "Options";
    std::string text = CLI::Formatter::make_group(std::move(group), positional, std::move(options));
    return first ? text : text.substr(1);  // the caller parts groups by an empty line of its own
  }
};

// What a parse error of the library says, in our words and with the nearest thing that exists.
std::string usage_text(const CLI::App& app, const CLI::App* command, const CLI::ParseError& failure) {
  const CLI::App& parser = command ? *command : app;
  const std::string help =
      fmt::format("; 'plinian {}--help' shows what there is", command ? command->get_name() + " " : "");
  std::vector<std::string> left = parser.remaining();
  if (left.empty()) left = app.remaining();
  if (dynamic_cast<const CLI::ExtrasError*>(&failure) && !left.empty()) {
    const std::string word = left.front().substr(0, left.front().find('='));
    std::vector<std::string> options;
    for (const CLI::Option* option : parser.get_options())
      for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    if (word.starts_with("-"))
      return fmt::format("{}: no such option{}{}", word, did_you_mean(word, options), help);
    return fmt::format("{}: one argument too many{}", word, help);
  }
  // "--passes: At Most 1 required but received 2"
  const std::string said = failure.what();
  if (const std::size_t at = said.find(": At Most 1 required"); at != said.npos)
    return said.substr(0, at) + ": is given more than once" + help;
  return said + help;
}

// The arguments as a shell would take them again.
std::string command_line_of(int argc, char** argv) {
  std::string line = "plinian";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                            "0123456789_-+=./,:@%") == std::string::npos;
    line += ' ';
    if (plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

// Whether scripts have a command of that name.
bool is_script_command(const std::string& name) {
  scene::Workspace workspace;
  add_render_command(workspace);
  return std::ranges::count(workspace.session().commands().names(), name) > 0;
}

// Without a command the window opens, on a file where one is named and on a display where there is one.
// "help render" is "render --help", and "help setAttr", of a command of scripts, "plugins --command setAttr".
std::vector<char*> with_command(int argc, char** argv) {
  static char view[] = "view", help[] = "--help", plugins[] = "plugins", command[] = "--command";
  std::vector<char*> words(argv, argv + argc);
  const auto is_own = [](const std::string& name) { return std::ranges::count(command_names(), name) > 0; };
  if (argc > 2 && std::string(argv[1]) == "help" && !is_own(argv[2]) && is_script_command(argv[2]))
    return {argv[0], plugins, command, argv[2]};
  if (argc > 2 && std::string(argv[1]) == "help") return {argv[0], argv[2], help};
  if (!window::can_open_window()) return words;
  std::error_code ignored;
  const auto names = command_names();
  const bool alone = argc < 2;
  if (alone || (std::find(names.begin(), names.end(), argv[1]) == names.end() && argv[1][0] != '-' &&
                std::filesystem::is_regular_file(argv[1], ignored)))
    words.insert(words.begin() + 1, view);
  return words;
}

int run(int given, char** given_words) {
  std::vector<char*> words = with_command(given, given_words);
  const int argc = int(words.size());
  words.push_back(nullptr);
  char** argv = words.data();
  CLI::App app("Plinian: interactive previsualisation of very dense participating media", "plinian");
  app.set_version_flag("--version", "plinian " PLINIAN_VERSION);
  app.formatter(std::make_shared<HelpFormatter>());
  std::vector<std::pair<CLI::App*, Run>> runs;
  for (const Command& command : commands) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    Run run_command = command.set_up(*sub);
    runs.emplace_back(sub, std::move(run_command));
  }

  if (argc < 2 || std::string(argv[1]) == "--help" || std::string(argv[1]) == "-h" ||
      std::string(argv[1]) == "help") {
    print(overview_text());
    return exit_success;
  }
  const std::string first = argv[1];
  const auto names = command_names();
  if (!first.starts_with("-") && std::find(names.begin(), names.end(), first) == names.end()) {
    std::error_code ignored;
    const bool file = std::filesystem::exists(first, ignored);
    if (!file && is_script_command(first)) {
      error(
          fmt::format("{0}: is a command of scripts: 'plinian run SCRIPT' runs them, as in echo '{0} ...' | "
                      "plinian run -; 'plinian help {0}' shows what it takes",
                      first));
      return exit_usage;
    }
    error(fmt::format(
        "{}: no such command{}; there are: {}", first,
        file ? fmt::format(" (did you mean 'plinian render {}'?)", first) : did_you_mean(first, names),
        join(names)));
    return exit_usage;
  }

  const auto parsed = [&]() -> const std::pair<CLI::App*, Run>* {
    for (const auto& entry : runs)
      if (entry.first->parsed()) return &entry;
    return nullptr;
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help, --version: prints what was asked for
  } catch (const CLI::ParseError& failure) {
    const auto* entry = parsed();
    error(usage_text(app, entry ? entry->first : nullptr, failure));
    return exit_usage;
  }
  catch_interrupts();
  const auto* entry = parsed();
  return entry ? entry->second(command_line_of(argc, argv)) : exit_usage;
}

int cancelled() {
  error("cancelled; nothing was written");
  return exit_cancelled;
}

}  // namespace

}  // namespace plinian::cli

/// What jemalloc reads. The planes of a picture come and go with every frame: giving their memory back to the
/// system each time, and having it cleared again, took 10 of the 136 ms of a frame; where none follows, it
/// goes back after two seconds. Few arenas: what one thread let go of serves the others.
extern "C" const char* malloc_conf;
const char* malloc_conf = "background_thread:true,dirty_decay_ms:2000,muzzy_decay_ms:0,narenas:4";

int main(int argc, char** argv) {
  using namespace plinian;
  sdk::tell_of_crashes();
  try {
    return cli::run(argc, argv);
  } catch (const RenderCancelled&) {
    return cli::cancelled();
  } catch (const SceneLoadCancelled&) {
    return cli::cancelled();
  } catch (const graph::EvaluationCancelled&) {
    return cli::cancelled();
  } catch (const graph::ScriptInterrupted& interrupted) {
    cli::error(interrupted.what());
    return cli::exit_cancelled;
  } catch (const std::bad_alloc&) {
    cli::error("out of memory; a smaller --size, --resolution or map.resolution needs less");
  } catch (const std::exception& failure) {
    if (cli::interrupted()) return cli::cancelled();  // also ends helpers of ours, whose end is then an error
    cli::error(failure.what());
  }
  return cli::exit_failure;
}
