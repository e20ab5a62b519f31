// plinian plugins: what plug-ins there are, and the node types and commands of this program with them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/scene/nearest_word.h"
#include "host/cli/command.h"
#include "host/cli/console.h"
#include "host/cli/render_command.h"
#include "host/graph/graph_error.h"
#include "host/scene/workspace.h"
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
  std::string name, path, state;  // state: "loaded", "found", or why it cannot be used
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
      all.push_back(std::move(found));
    }
  }
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

// One attribute and what is in it.
void describe_attribute(const graph::Schema& schema, graph::AttributeIndex index, std::string& text) {
  const graph::SchemaAttribute& attribute = schema[index];
  const graph::AttributeSpec& spec = attribute.spec;
  if (spec.hidden) return;
  std::string line =
      fmt::format("  {:<32} {}{}", attribute.path, graph::type_name(spec.type), spec.array ? "[]" : "");
  if (spec.type == graph::AttributeType::choice) line += ": " + graph::choices_text(spec);
  if (!spec.unit.empty()) line += " [" + spec.unit + "]";
  const bool has_text = spec.type != graph::AttributeType::compound &&
                        spec.type != graph::AttributeType::data && spec.type != graph::AttributeType::node &&
                        spec.type != graph::AttributeType::matrix;
  if (spec.output)
    line += " (output)";
  else if (has_text && !spec.array)
    line += " (" + graph::write_value(spec, spec.default_value) + ")";
  text += line + "\n";
  if (!spec.help.empty()) text += fmt::format("  {:<32}   {}\n", "", spec.help);
  for (const graph::AttributeIndex child : attribute.children) describe_attribute(schema, child, text);
}

int list_types(graph::Session& session) {
  for (const std::string& name : session.types().names()) {
    const graph::NodeTypeSpec& spec = session.types().get(name)->spec();
    print(fmt::format("{:<18} {:<8} {}\n", name, spec.plugin, spec.help));
  }
  return exit_success;
}

int describe_type(graph::Session& session, const std::string& name) {
  const graph::NodeTypePtr type = session.types().get(name);
  const std::string plugin = type->spec().plugin;
  std::string text =
      fmt::format("{}, version {}, {}: {}\n", type->name(), type->version(),
                  plugin.empty() ? "part of the program" : "of the plug-in " + plugin, type->spec().help);
  for (const graph::AttributeIndex index : type->schema()->top())
    describe_attribute(*type->schema(), index, text);
  print(text);
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
    return describe_type(session, arguments.type);
  }
  if (arguments.types) return list_types(session);
  const bool commands = arguments.commands || !arguments.command.empty();
  if (!commands) return list_plugins(plugins_of(workspace.plugins()), workspace.plugins(), arguments.json);
  const std::vector<std::string> known = session.commands().names();
  if (!arguments.command.empty() && std::find(known.begin(), known.end(), arguments.command) == known.end())
    load_bringer(workspace, "command:" + arguments.command);
  for (const std::string& line : session.execute("help " + arguments.command)) print(line + "\n");
  return exit_success;
}

}  // namespace

Run set_up_plugins(CLI::App& app) {
  auto arguments = std::make_shared<PluginsArguments>();
  app.footer(examples);
  app.add_flag("--types", arguments->types, "list the node types");
  app.add_option("--type", arguments->type, "show the attributes of a node type")->type_name("NAME");
  app.add_flag("--commands", arguments->commands, "list the commands of scripts");
  app.add_option("--command", arguments->command, "show what a command takes")->type_name("NAME");
  app.add_flag("--json", arguments->json, "the list of plug-ins for scripts");
  return [arguments](const std::string&) { return run_plugins(*arguments); };
}

}  // namespace plinian::cli
