// What scripts do with plug-ins.
#include "host/sdk/plugin_commands.h"

#include "core/scene/nearest_word.h"
#include "host/sdk/plugin_manager.h"

namespace plinian::sdk {

void add_plugin_commands(graph::CommandRegistry& commands, PluginManager& manager) {
  using enum graph::ArgumentKind;
  commands.add({.name = "loadPlugin",
                .help = "Loads a plug-in and answers with its name.",
                .parameters = {{"plugin", path, "name, or path of its library"}},
                .run =
                    [&manager](graph::Session& session, const graph::Arguments& arguments) {
                      bool already = false;
                      const std::string name = manager.load(arguments.text("plugin"), &already);
                      if (already) session.note("the plug-in '" + name + "' is loaded already");
                      return graph::CommandResult{name};
                    },
                .handles_history = true});
  commands.add({.name = "unloadPlugin",
                .help = "Unloads a plug-in that no node needs.",
                .parameters = {{"plugin", text, "its name"}},
                .flags = {{"force", "keeps its nodes as unknown ones", {}}},
                .run =
                    [&manager](graph::Session&, const graph::Arguments& arguments) {
                      manager.unload(arguments.text("plugin"), arguments.has("force"));
                      return graph::CommandResult();
                    },
                .handles_history = true});
  commands.add({.name = "pluginInfo",
                .help = "Answers with what is loaded, or what a plug-in that is not loaded says of itself.",
                .parameters = {{"plugin", path, "name or path; else all that are loaded", true}},
                .run = [&manager](graph::Session&, const graph::Arguments& arguments) {
                  graph::CommandResult lines;
                  const auto tell = [&](const PluginDescription& d, const std::string& path) {
                    lines.push_back(d.name + " " + d.version + ", " + d.vendor + ", interface " +
                                    std::to_string(d.abi_major) + "." + std::to_string(d.abi_minor) +
                                    ", registers " + join(d.registers, " ") + ", " + path);
                  };
                  const std::string wanted = arguments.text("plugin");
                  for (const PluginManager::Loaded& loaded : manager.plugins())
                    if (wanted.empty() || wanted == loaded.description.name)
                      tell(loaded.description, loaded.path);
                  if (!wanted.empty() && lines.empty())
                    tell(read_description(manager.search().find(wanted)), manager.search().find(wanted));
                  return lines;
                }});
}

void remove_plugin_commands(graph::CommandRegistry& commands) {
  for (const char* command : {"loadPlugin", "unloadPlugin", "pluginInfo"}) commands.remove(command);
}

}  // namespace plinian::sdk
