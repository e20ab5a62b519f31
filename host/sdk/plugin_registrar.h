// The host's side of the tables: what a plug-in registers, as the graph's own declarations.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/graph/commands/command.h"
#include "host/graph/types/node_type.h"
#include "host/sdk/abi.h"
#include "host/sdk/command_table.h"
#include "host/sdk/data_count.h"
#include "host/sdk/draw_override.h"
#include "host/sdk/event_hub.h"
#include "host/sdk/handles.h"
#include "host/sdk/plugin_description.h"

namespace plinian::sdk {

/// Collects what a plug-in registers while it is initialised; nothing of it counts before the plug-in has
/// succeeded. Lives as long as the plug-in: its table is what the plug-in talks to.
class PluginRegistrar {
 public:
  /// events: null where there is no session.
  explicit PluginRegistrar(EventHub* events = nullptr);
  PluginRegistrar(const PluginRegistrar&) = delete;
  PluginRegistrar& operator=(const PluginRegistrar&) = delete;

  /// For plinian_initialise; good for as long as the registrar lives.
  const PlinianHost& host() const { return host_; }

  /// Forgets what was registered, once it is where it belongs. Subscriptions stay.
  void clear();

  /// Whom its callbacks, and a crash in it, speak of: "the plug-in 'wobble'".
  void set_name(const std::string& name) { data->owner = name; }
  const std::string& name() const { return data->owner; }

  std::vector<graph::NodeTypeSpec> node_types;
  std::vector<graph::CommandSpec> commands;
  std::vector<graph::DataType> data_types;
  std::vector<graph::FileType> file_types;
  std::vector<MenuItem> menu;
  std::vector<DrawOverride> draw_overrides;
  std::map<std::string, std::vector<HandleSpec>> handles;  // by node type
  std::map<std::uint64_t, EventHub::Subscription> subscriptions;
  std::string error;  // of the first thing that failed
  const std::shared_ptr<DataCount> data = std::make_shared<DataCount>();

 private:
  std::uint64_t subscribe(const char* kind, void* user, PlinianEventCallback callback);
  void execute(const char* line, const char** answers);

  EventHub* events_;
  PlinianHost host_{};
  std::uint64_t last_subscription_ = 0;
  std::string last_error_, answers_;
};

/// Where a description does not list what was registered, or lists what was not; else empty.
std::string registers_problem(const PluginDescription& description, const PluginRegistrar& registrar);

}  // namespace plinian::sdk
