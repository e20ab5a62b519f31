// loadPlugin, unloadPlugin, pluginInfo.
#pragma once

#include "host/graph/commands/command.h"

namespace plinian::sdk {

class PluginManager;

/// The manager must outlive the commands.
void add_plugin_commands(graph::CommandRegistry& commands, PluginManager& manager);
void remove_plugin_commands(graph::CommandRegistry& commands);

}  // namespace plinian::sdk
