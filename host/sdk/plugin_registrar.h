// The host's side of the tables: what a plug-in registers, as the graph's own declarations.
#pragma once

#include <string>
#include <vector>

#include "host/graph/commands/command.h"
#include "host/graph/types/node_type.h"
#include "host/sdk/abi.h"

namespace plinian::sdk {

/// Collects what a plug-in registers while it is initialised; nothing of it counts before the plug-in has
/// succeeded.
class PluginRegistrar {
 public:
  PluginRegistrar();
  PluginRegistrar(const PluginRegistrar&) = delete;
  PluginRegistrar& operator=(const PluginRegistrar&) = delete;

  /// For plinian_initialise; good for as long as the registrar lives.
  const PlinianHost& host() const { return host_; }

  std::vector<graph::NodeTypeSpec> node_types;
  std::vector<graph::CommandSpec> commands;
  std::string error;  // of the first thing that failed

 private:
  PlinianHost host_{};
};

/// Data objects handed over by plug-ins that somebody still holds: a library must stay while its code may be
/// called to release one.
std::size_t live_plugin_data();

}  // namespace plinian::sdk
