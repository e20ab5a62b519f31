// Registered node types.
#include "host/graph/types/type_registry.h"

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

NodeTypePtr TypeRegistry::add(NodeTypeSpec spec) {
  if (const NodeTypePtr other = find(spec.name)) {
    const std::string& plugin = other->spec().plugin;
    throw GraphError("node type '" + spec.name + "' is already registered" +
                     (plugin.empty() ? "" : " by the plug-in '" + plugin + "'"));
  }
  give_slots(spec.attributes);
  auto type = std::make_shared<const NodeType>(std::move(spec));
  types_.emplace(type->name(), type);
  return type;
}

void TypeRegistry::remove(std::string_view name) {
  const auto found = types_.find(name);
  if (found != types_.end()) types_.erase(found);
}

NodeTypePtr TypeRegistry::find(std::string_view name) const {
  const auto found = types_.find(name);
  return found == types_.end() ? nullptr : found->second;
}

NodeTypePtr TypeRegistry::get(std::string_view name) const {
  if (const NodeTypePtr type = find(name)) return type;
  const std::string meant = elsewhere.hint(std::string(name), names());
  throw GraphError("unknown node type " + shown(name) +
                   (meant.empty() ? "; there are: " + join(names()) : meant));
}

std::vector<std::string> TypeRegistry::names() const {
  std::vector<std::string> result;
  for (const auto& [name, type] : types_) result.push_back(name);
  return result;
}

const std::shared_ptr<DataSlot>& TypeRegistry::slot(const std::string& data_type) {
  std::shared_ptr<DataSlot>& found = slots_[data_type];
  if (!found) found = std::make_shared<DataSlot>();
  return found;
}

void TypeRegistry::give_slots(std::vector<AttributeSpec>& attributes) {
  for (AttributeSpec& attribute : attributes) {
    if (attribute.type == AttributeType::data) attribute.data_slot = slot(attribute.data_type);
    give_slots(attribute.children);
  }
}

void TypeRegistry::add_data_type(DataType type) {
  if (const DataTypePtr other = find_data_type(type.name))
    throw GraphError("data type '" + type.name + "' is already registered" +
                     (other->plugin.empty() ? "" : " by the plug-in '" + other->plugin + "'"));
  DataSlot& place = *slot(type.name);
  place.type = std::make_shared<const DataType>(std::move(type));
}

void TypeRegistry::remove_data_type(const std::string& name) {
  slot(name)->type = nullptr;
}

DataTypePtr TypeRegistry::find_data_type(const std::string& name) const {
  const auto found = slots_.find(name);
  return found == slots_.end() ? nullptr : found->second->type;
}

}  // namespace plinian::graph
