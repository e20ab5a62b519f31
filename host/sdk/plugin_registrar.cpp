// Takes what a plug-in registers. No exception leaves a function that a plug-in calls.
#include "host/sdk/plugin_registrar.h"

#include "host/sdk/command_table.h"
#include "host/sdk/node_type_table.h"
#include "host/sdk/plain_text.h"

namespace plinian::sdk {

namespace {

template <class Action>
int registered(void* self, const Action& action) {
  auto& registrar = *static_cast<PluginRegistrar*>(self);
  try {
    action(registrar);
    return 1;
  } catch (const std::exception& error) {
    if (registrar.error.empty()) registrar.error = error.what();
    return 0;
  }
}

}  // namespace

PluginRegistrar::PluginRegistrar() {
  host_.size = sizeof(PlinianHost);
  host_.abi_major = PLINIAN_ABI_MAJOR;
  host_.abi_minor = PLINIAN_ABI_MINOR;
  host_.self = this;
  host_.register_node_type = [](void* self, const PlinianNodeType* type) {
    return registered(self,
                      [&](PluginRegistrar& r) { r.node_types.push_back(node_type_from(type, r.data)); });
  };
  host_.register_command = [](void* self, const PlinianCommand* command) {
    return registered(self, [&](PluginRegistrar& r) { r.commands.push_back(command_from(command)); });
  };
  host_.fail = [](void* self, const char* message) {
    auto& registrar = *static_cast<PluginRegistrar*>(self);
    if (registrar.error.empty()) registrar.error = text_of(message);
  };
}

void PluginRegistrar::clear() {
  node_types.clear();
  commands.clear();
}

}  // namespace plinian::sdk
