// Goes through the nodes and values of all steps.
#include "host/graph/edits/sleep.h"

#include <set>

#include "host/graph/types/data_type.h"

namespace plinian::graph {

namespace {

const NodePtr* node_in(const Edit& edit) {
  if (const auto* add = std::get_if<AddNode>(&edit)) return &add->node;
  if (const auto* replace = std::get_if<ReplaceNode>(&edit)) return &replace->node;
  return nullptr;
}

void put_node(Edit& edit, Node node) {
  auto shared = std::make_shared<const Node>(std::move(node));
  if (auto* add = std::get_if<AddNode>(&edit))
    add->node = std::move(shared);
  else
    std::get<ReplaceNode>(edit).node = std::move(shared);
}

// Nodes of `from` become such of `to`, which holds the same.
void change_type(History& history, const NodeTypePtr& to, const std::function<bool(const NodeType&)>& from) {
  history.rewrite([&](Edit& edit) {
    const NodePtr* found = node_in(edit);
    if (!found || !from(*(*found)->type)) return;
    Node node = **found;
    const SchemaPtr own = node.schema;
    node.type = to;
    node.schema = to->schema();
    for (const AttributeIndex top : own->top())
      if ((*own)[top].dynamic)
        node.schema = std::make_shared<const Schema>(node.schema->with_dynamic(own->declaration(top)));
    put_node(edit, std::move(node));
  });
}

const DataPtr* data_in(const Value& value, const std::string& type, bool asleep) {
  const auto* data = std::get_if<DataPtr>(&value);
  return data && *data && (*data)->type == type && (*data)->asleep == asleep ? data : nullptr;
}

// Every value of the edit, to be looked at.
void for_values(const Edit& edit, const std::function<void(const Value&)>& look) {
  if (const auto* set = std::get_if<SetValue>(&edit); set && set->value) look(*set->value);
  if (const NodePtr* node = node_in(edit))
    for (const StoredValue& stored : (*node)->values) look(stored.value);
}

// Makes other data of those that sleep, or do not. Returns how many steps went with what failed.
std::size_t change_data(History& history, const std::string& type, bool asleep,
                        const std::function<DataPtr(const Data&)>& other) {
  std::set<const Data*> failed;
  const auto changed = [&](Value& value) {
    const DataPtr* data = data_in(value, type, asleep);
    if (!data) return;
    try {
      value = other(**data);
    } catch (const std::exception&) {
      failed.insert(data->get());
    }
  };
  history.rewrite([&](Edit& edit) {
    bool any = false;
    for_values(edit, [&](const Value& value) { any = any || data_in(value, type, asleep); });
    if (!any) return;
    if (auto* set = std::get_if<SetValue>(&edit)) return changed(*set->value);
    Node node = **node_in(edit);
    for (StoredValue& stored : node.values) changed(stored.value);
    put_node(edit, std::move(node));
  });
  return history.forget_steps_where([&](const Edit& edit) {
    bool any = false;
    for_values(edit, [&](const Value& value) {
      const DataPtr* data = data_in(value, type, asleep);
      any = any || (data && failed.contains(data->get()));
    });
    return any;
  });
}

}  // namespace

std::string sleeping_part(const Edit& edit) {
  if (const NodePtr* node = node_in(edit); node && (*node)->type->has_no_code())
    return "nodes of the type '" + (*node)->type->name() + "': load the plug-in '" +
           (*node)->type->spec().plugin + "' first";
  std::string part;
  for_values(edit, [&](const Value& value) {
    const auto* data = std::get_if<DataPtr>(&value);
    if (data && *data && (*data)->asleep)
      part = "data of the type '" + (*data)->type + "': load its plug-in first";
  });
  return part;
}

void put_to_sleep(History& history, const NodeTypePtr& type) {
  change_type(history, type->without_code(), [&](const NodeType& other) { return &other == type.get(); });
}

std::size_t put_to_sleep(History& history, const DataType& type) {
  return change_data(history, type.name, false, [&](const Data& data) {
    auto bytes = std::make_shared<const std::string>(type.serialise(data.object.get()));
    const std::size_t size = bytes->size();
    return std::make_shared<const Data>(Data{data.type, std::move(bytes), size, data.content, true});
  });
}

std::size_t wake(History& history, const NodeTypePtr& type) {
  const auto sleeps = [&](const NodeType& other) {
    return other.has_no_code() && other.name() == type->name();
  };
  change_type(history, type,
              [&](const NodeType& other) { return sleeps(other) && other.holds_the_same(*type); });
  return history.forget_steps_where([&](const Edit& edit) {
    const NodePtr* node = node_in(edit);
    return node && sleeps(*(*node)->type);
  });
}

std::size_t wake(History& history, const DataType& type) {
  return change_data(history, type.name, true, [&](const Data& data) {
    const DataPtr read = type.deserialise(*static_cast<const std::string*>(data.object.get()));
    Data known = *read;
    known.type = data.type;
    known.content = data.content;
    return std::make_shared<const Data>(std::move(known));
  });
}

}  // namespace plinian::graph
