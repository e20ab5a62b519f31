// The host's side of the tables: what a plug-in registers, as the graph's own declarations.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/graph/commands/command.h"
#include "host/graph/types/node_type.h"
#include "host/sdk/abi.h"
#include "host/sdk/data_count.h"

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

  void clear();  // what was registered, once it is where it belongs

  std::vector<graph::NodeTypeSpec> node_types;
  std::vector<graph::CommandSpec> commands;
  std::string error;  // of the first thing that failed
  const std::shared_ptr<DataCount> data = std::make_shared<DataCount>();

 private:
  PlinianHost host_{};
};

}  // namespace plinian::sdk
