// Takes what a plug-in registers. No exception leaves a function that a plug-in calls.
#include "host/sdk/plugin_registrar.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/sdk/data_type_table.h"
#include "host/sdk/inside_plugin.h"
#include "host/sdk/node_type_table.h"
#include "host/sdk/plain_text.h"

namespace plinian::sdk {

namespace {

PluginRegistrar& registrar_of(void* self) {
  return *static_cast<PluginRegistrar*>(self);
}

// Of what fails while the plug-in is initialised the first counts.
template <class Action>
int registered(void* self, const Action& action) {
  PluginRegistrar& registrar = registrar_of(self);
  try {
    action(registrar);
    return 1;
  } catch (const std::exception& error) {
    if (registrar.error.empty()) registrar.error = error.what();
    return 0;
  }
}

}  // namespace

PluginRegistrar::PluginRegistrar(EventHub* events) : events_(events) {
  host_.size = sizeof(PlinianHost);
  host_.abi_major = PLINIAN_ABI_MAJOR;
  host_.abi_minor = PLINIAN_ABI_MINOR;
  host_.self = this;
  host_.register_node_type = [](void* self, const PlinianNodeType* type) {
    return registered(self, [&](PluginRegistrar& r) {
      r.node_types.push_back(node_type_from(type, r.data));
      const PlinianNodeType from = whole(type);
      if (from.draw) r.draw_overrides.push_back({text_of(from.name), whole(from.draw), r.name()});
      for (const PlinianHandle& handle : all_of(from.handles, from.handle_count)) try {
          r.handles[text_of(from.name)].push_back(handle_from(handle, r.node_types.back().attributes));
        } catch (const graph::GraphError& error) {
          throw graph::GraphError("node type '" + text_of(from.name) + "': " + error.what());
        }
    });
  };
  host_.register_command = [](void* self, const PlinianCommand* command) {
    return registered(self, [&](PluginRegistrar& r) { r.commands.push_back(command_from(command, r.data)); });
  };
  host_.fail = [](void* self, const char* message) {
    PluginRegistrar& registrar = registrar_of(self);
    registrar.last_error_ = text_of(message);
    if (registrar.error.empty()) registrar.error = registrar.last_error_;
  };
  host_.register_data_type = [](void* self, const PlinianDataType* type) {
    return registered(self,
                      [&](PluginRegistrar& r) { r.data_types.push_back(data_type_from(type, r.data)); });
  };
  host_.register_file_type = [](void* self, const PlinianFileType* type) {
    return registered(self,
                      [&](PluginRegistrar& r) { r.file_types.push_back(file_type_from(type, r.data)); });
  };
  host_.register_menu_entry = [](void* self, const PlinianMenuEntry* entry) {
    return registered(self, [&](PluginRegistrar& r) { r.menu.push_back(menu_entry_from(entry)); });
  };
  host_.subscribe = [](void* self, const char* kind, void* user, PlinianEventCallback callback) {
    PluginRegistrar& registrar = registrar_of(self);
    try {
      return registrar.subscribe(kind, user, callback);
    } catch (const std::exception& error) {
      registrar.last_error_ = error.what();
      return std::uint64_t(0);
    }
  };
  host_.unsubscribe = [](void* self, std::uint64_t subscription) {
    registrar_of(self).subscriptions.erase(subscription);
  };
  host_.execute = [](void* self, const char* line, const char** answers) {
    PluginRegistrar& registrar = registrar_of(self);
    try {
      registrar.execute(line, answers);
      return 1;
    } catch (const std::exception& error) {
      registrar.last_error_ = error.what();
      return 0;
    }
  };
  host_.error = [](void* self) { return registrar_of(self).last_error_.c_str(); };
}

std::uint64_t PluginRegistrar::subscribe(const char* kind, void* user, PlinianEventCallback callback) {
  if (!events_) throw graph::GraphError("there are no events here");
  if (!callback) throw graph::GraphError("a subscription needs a callback");
  auto subscription = events_->subscribe(
      event_of_name(text_of(kind)), name(), [this, user, callback](const SceneEvent& event) {
        PlinianEvent plain{};
        plain.size = sizeof(plain);
        plain.kind = event_name(event.kind).c_str();
        plain.node = event.node.c_str();
        plain.plug = event.plug.c_str();
        plain.other = event.other.c_str();
        plain.time = event.time;
        last_error_.clear();
        const InsidePlugin inside(name(), "hearing of the event", plain.kind);
        if (!callback(user, &plain))
          throw graph::GraphError(last_error_.empty() ? "no reason is given" : last_error_);
      });
  subscriptions.emplace(++last_subscription_, std::move(subscription));
  return last_subscription_;
}

void PluginRegistrar::execute(const char* line, const char** answers) {
  if (!events_ || !events_->is_delivering())
    throw graph::GraphError("commands run from event callbacks and from commands alone");
  answers_.clear();
  for (const std::string& answer : events_->session().execute(text_of(line)))
    answers_ += (answers_.empty() ? "" : "\n") + answer;
  if (answers) *answers = answers_.c_str();
}

void PluginRegistrar::clear() {
  node_types.clear();
  commands.clear();
  data_types.clear();
  file_types.clear();
  menu.clear();
  draw_overrides.clear();
  handles.clear();
}

// Before version 1.2 of the interface nobody looked.
std::string registers_problem(const PluginDescription& description, const PluginRegistrar& registrar) {
  if (description.abi_minor < 2) return "";
  const std::set<std::string> said(description.registers.begin(), description.registers.end());
  std::set<std::string> done;
  for (const graph::NodeTypeSpec& type : registrar.node_types) done.insert("node:" + type.name);
  for (const graph::CommandSpec& command : registrar.commands) done.insert("command:" + command.name);
  for (const graph::DataType& type : registrar.data_types) done.insert("data:" + type.name);
  for (const graph::FileType& type : registrar.file_types) done.insert("file:" + type.name);
  const auto without = [](const std::set<std::string>& all, const std::set<std::string>& others) {
    std::vector<std::string> rest;
    std::set_difference(all.begin(), all.end(), others.begin(), others.end(), std::back_inserter(rest));
    return rest;
  };
  const auto extra = without(done, said), missing = without(said, done);
  std::string problem;
  if (!extra.empty()) problem = "registers " + join(extra) + ", which its description does not list";
  if (!missing.empty())
    problem += (problem.empty() ? "does not register " : "; does not register ") + join(missing) +
               ", which its description lists";
  return problem;
}

}  // namespace plinian::sdk
