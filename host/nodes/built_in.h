// Node types that are a part of the program.
#pragma once

#include "host/sdk/plugin_manager.h"

namespace plinian::nodes {

/// The plug-in that they are.
const PlinianLinkedPlugin& built_in_plugin();

/// Registers them, and gives a scene that is still empty what a new one has: the time. Once for a manager.
void add_built_in(graph::Session& session, sdk::PluginManager& plugins);

}  // namespace plinian::nodes
