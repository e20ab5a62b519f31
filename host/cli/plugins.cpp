// plinian plugins: what plug-ins there are, and the node types and commands of this program with them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>

#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/render_command.h"
#include "host/cli/type_description.h"
#include "host/graph/graph_error.h"
#include "host/scene/workspace.h"
#include "host/sdk/load_marker.h"
#include "host/sdk/plugin_description.h"

namespace plinian::cli {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

struct PluginsArguments {
  bool types = false, commands = false, json = false;
  std::string type, command;
};

constexpr const char* examples = R"(
Examples:
  plinian plugins                    what is loaded, and what else is in the folders
  plinian plugins --types            the node types
  plinian plugins --type volumeRead  the attributes of one
  plinian plugins --commands         the commands of scripts
  plinian plugins --command setAttr  what one takes
Plug-ins are looked for in the folders of $PLINIAN_PLUGIN_PATH, then in the one of the installation; never in the
current folder.)";

struct Found {
  std::string name, path, state;  // state: "loaded", "found", or why it cannot be used or is not
  sdk::PluginDescription description;
};

std::vector<Found> plugins_of(const sdk::PluginManager& plugins) {
  std::vector<Found> all;
  for (const auto& loaded : plugins.plugins())
    all.push_back({loaded.description.name, loaded.path, "loaded", loaded.description});
  for (const fs::path& folder : plugins.search().folders()) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() != ".so") continue;
      const std::string path = entry.path().string();
      if (std::any_of(all.begin(), all.end(), [&](const Found& found) { return found.path == path; }))
        continue;
      Found found{entry.path().stem().string(), path, "found", {}};
      try {
        found.description = sdk::read_description(path);
        found.name = found.description.name;
        if (const std::string problem = sdk::abi_problem(found.description); !problem.empty())
          found.state = problem;
      } catch (const graph::GraphError& failure) {
        found.state = failure.what();
      }
      // It says so before anybody wonders why a scene lacks it.
      if (found.state == "found" && sdk::LoadMarker::is_left(path))
        found.state = "did not come back when it was loaded last, and is skipped; 'loadPlugin " + path +
                      "' tries it again";
      all.push_back(std::move(found));
    }
  }
  std::ranges::sort(all, {}, [](const Found& found) { return std::tie(found.name, found.path); });
  return all;
}

int list_plugins(const std::vector<Found>& all, const sdk::PluginManager& plugins, bool as_json) {
  if (as_json) {
    ordered_json report = {{"plugins", ordered_json::array()}, {"folders", ordered_json::array()}};
    for (const Found& found : all)
      report["plugins"].push_back({{"name", found.name},
                                   {"version", found.description.version},
                                   {"vendor", found.description.vendor},
                                   {"path", found.path},
                                   {"state", found.state},
                                   {"registers", found.description.registers}});
    for (const fs::path& folder : plugins.search().folders()) report["folders"].push_back(folder.string());
    print(report.dump(2) + "\n");
    return exit_success;
  }
  for (const Found& found : all) {
    print(fmt::format("{:<12} {:<8} {:<12} {}\n", found.name, found.description.version,
                      found.description.vendor, found.path));
    if (found.state != "loaded") print(fmt::format("{:<12} {}\n", "", found.state));
    for (const std::string& what : found.description.registers) print(fmt::format("{:<12}   {}\n", "", what));
  }
  return exit_success;
}

void print_json(const ordered_json& report) {
  print(report.dump(2) + "\n");
}

int list_types(graph::Session& session, bool as_json) {
  ordered_json report = {{"types", ordered_json::array()}};
  for (const std::string& name : session.types().names()) {
    const graph::NodeTypeSpec& spec = session.types().get(name)->spec();
    report["types"].push_back(
        {{"name", name}, {"version", spec.version}, {"plugin", spec.plugin}, {"help", spec.help}});
    if (!as_json) print(fmt::format("{:<18} {:<8} {}\n", name, spec.plugin, spec.help));
  }
  if (as_json) print_json(report);
  return exit_success;
}

int list_commands(graph::Session& session, bool as_json) {
  ordered_json report = {{"commands", ordered_json::array()}};
  for (const std::string& name : session.commands().names())
    report["commands"].push_back({{"name", name}, {"help", session.commands().get(name).help}});
  if (as_json) print_json(report);
  if (!as_json)
    for (const std::string& line : session.execute("help")) print(line + "\n");
  return exit_success;
}

int describe_command(graph::Session& session, const std::string& name, bool as_json) {
  const graph::CommandSpec& spec = session.commands().get(name);
  if (!as_json) {
    for (const std::string& line : graph::help_lines(spec)) print(line + "\n");
    return exit_success;
  }
  ordered_json report = {{"name", spec.name},
                         {"usage", graph::usage(spec)},
                         {"help", spec.help},
                         {"parameters", ordered_json::array()},
                         {"flags", ordered_json::array()}};
  for (const graph::CommandParameter& parameter : spec.parameters)
    report["parameters"].push_back({{"name", parameter.name},
                                    {"help", parameter.help},
                                    {"optional", parameter.optional},
                                    {"many", parameter.many}});
  for (const graph::CommandFlag& flag : spec.flags)
    report["flags"].push_back({{"name", flag.name},
                               {"help", flag.help},
                               {"takes_word", flag.takes.has_value()},
                               {"many", flag.many}});
  print_json(report);
  return exit_success;
}

// What is asked for may be of a plug-in that is found but not loaded.
void load_bringer(scene::Workspace& workspace, const std::string& what) {
  const auto found = workspace.plugins().search().find_bringer(what, [&](const std::string& name) {
    const auto loaded = workspace.plugins().plugins();
    return std::any_of(loaded.begin(), loaded.end(),
                       [&](const auto& plugin) { return plugin.description.name == name; });
  });
  if (found) workspace.plugins().load(found->load);
}

int run_plugins(const PluginsArguments& arguments) {
  scene::Workspace workspace;
  add_render_command(workspace);
  graph::Session& session = workspace.session();
  if (!arguments.type.empty()) {
    if (!session.types().find(arguments.type)) load_bringer(workspace, "node:" + arguments.type);
    const graph::NodeTypePtr type = session.types().get(arguments.type);
    arguments.json ? print_json(type_json(*type)) : print(type_text(*type));
    return exit_success;
  }
  if (arguments.types) return list_types(session, arguments.json);
  const bool commands = arguments.commands || !arguments.command.empty();
  if (!commands) return list_plugins(plugins_of(workspace.plugins()), workspace.plugins(), arguments.json);
  const std::vector<std::string> known = session.commands().names();
  if (!arguments.command.empty() && std::find(known.begin(), known.end(), arguments.command) == known.end())
    load_bringer(workspace, "command:" + arguments.command);
  return arguments.command.empty() ? list_commands(session, arguments.json)
                                   : describe_command(session, arguments.command, arguments.json);
}

}  // namespace

Run set_up_plugins(CLI::App& app) {
  auto arguments = std::make_shared<PluginsArguments>();
  app.footer(examples);
  app.add_flag("--types", arguments->types, "list the node types");
  app.add_option("--type", arguments->type, "show the attributes of a node type")->type_name("NAME");
  app.add_flag("--commands", arguments->commands, "list the commands of scripts");
  app.add_option("--command", arguments->command, "show what a command takes")->type_name("NAME");
  app.add_flag("--json", arguments->json, "the same for scripts");
  return [arguments](const std::string&) { return run_plugins(*arguments); };
}

}  // namespace plinian::cli
