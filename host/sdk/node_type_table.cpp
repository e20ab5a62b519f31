// Node types through plain C.
#include "host/sdk/node_type_table.h"

#include <algorithm>

#include "core/scene/nearest_word.h"
#include "host/graph/files/attribute_declaration.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/hierarchy.h"
#include "host/graph/values/value_text.h"
#include "host/sdk/hidden_outputs.h"
#include "host/sdk/inside_plugin.h"
#include "host/sdk/plain_text.h"

namespace plinian::sdk {

using graph::AttributeSpec;
using graph::GraphError;

namespace {

AttributeSpec attribute_from(const PlinianAttribute& from) {
  const auto number = [](const double* value) { return value ? std::optional(*value) : std::nullopt; };
  AttributeSpec spec;
  spec.name = text_of(from.name);
  spec.type = graph::type_of_name(text_of(from.type));
  spec.nice_name = text_of(from.nice_name);
  spec.help = text_of(from.help);
  spec.unit = text_of(from.unit);
  spec.layout.group = text_of(from.group);
  spec.layout.widget = text_of(from.widget);
  const std::string& widget = spec.layout.widget;
  const std::vector<std::string> widgets = {"slider", "factor", "look", "file"};
  if (!widget.empty() && !widget.starts_with("grid of ") && !widget.starts_with("file ") &&
      !std::ranges::count(widgets, widget))
    throw GraphError("attribute '" + spec.name + "': there is no widget " + graph::shown(widget) +
                     did_you_mean(widget, widgets) + "; there are: " + join(widgets) +
                     ", file .EXTENSION ..., grid of NAME, grid of NAME or none");
  const std::string shown_when = text_of(from.shown_when);
  const std::size_t equals = shown_when.find('=');
  spec.layout.shown_when = shown_when.substr(0, equals);
  if (equals != shown_when.npos)
    spec.layout.shown_words = words_of(shown_when.substr(equals + 1).c_str(), ',');
  spec.step = from.step;
  if (from.choices) spec.choices = graph::read_choices(from.choices);
  spec.data_type = text_of(from.data_type);
  spec.affects = words_of(from.affects);
  spec.minimum = number(from.minimum);
  spec.maximum = number(from.maximum);
  spec.soft_minimum = number(from.soft_minimum);
  spec.soft_maximum = number(from.soft_maximum);
  spec.array = from.flags & PLINIAN_ATTRIBUTE_ARRAY;
  spec.output = from.flags & PLINIAN_ATTRIBUTE_OUTPUT;
  spec.hidden = from.flags & PLINIAN_ATTRIBUTE_HIDDEN;
  spec.read_only = from.flags & PLINIAN_ATTRIBUTE_READ_ONLY;
  spec.keyable = !(from.flags & PLINIAN_ATTRIBUTE_NOT_KEYABLE);
  spec.storable = !(from.flags & PLINIAN_ATTRIBUTE_NOT_STORABLE);
  spec.connectable = !(from.flags & PLINIAN_ATTRIBUTE_NOT_CONNECTABLE);
  if (from.default_value) {
    const bool text = spec.type == graph::AttributeType::string || spec.type == graph::AttributeType::path;
    const std::vector<graph::Word> words =
        text ? std::vector<graph::Word>{{from.default_value, true}} : graph::split_words(from.default_value);
    try {
      spec.default_value = graph::read_value(spec, words);
    } catch (const GraphError& error) {
      throw GraphError("attribute '" + spec.name + "': its default " + error.what());
    }
  }
  for (const PlinianAttribute& child : all_of(from.children, from.child_count))
    spec.children.push_back(attribute_from(child));
  return spec;
}

// Whatever has a place in the hierarchy can be hidden; who makes a picture looks for it by name. Types that
// have an attribute of that name, or had one, keep it.
void add_visibility(graph::NodeTypeSpec& spec) {
  const std::string name = graph::visibility_attribute;
  for (const AttributeSpec& attribute : spec.attributes)
    if (attribute.name == name) return;
  for (const graph::AttributeAlias& alias : spec.aliases)
    if (alias.old_path == name) return;
  spec.attributes.push_back({.name = name,
                             .type = graph::AttributeType::boolean,
                             .default_value = true,
                             .help = "Off: neither it nor what is under it is seen.",
                             .layout = {.group = "Transform"}});
}

struct MigrationState {
  graph::StoredAttributes& attributes;
  const std::vector<graph::AttributeAlias>& aliases;
  std::string text{}, failure{};

  graph::StoredAttribute* find(const std::string& path) {
    for (graph::StoredAttribute& attribute : attributes)
      if (attribute.path == path) return &attribute;
    return nullptr;
  }
  // ... or what the scene has of the attribute under another of its names.
  graph::StoredAttribute* find_by_any_name(const std::string& path) {
    if (graph::StoredAttribute* found = find(path)) return found;
    for (graph::StoredAttribute& attribute : attributes)
      if (current_path(aliases, attribute.path) == current_path(aliases, path)) return &attribute;
    return nullptr;
  }
};

MigrationState& state_of(PlinianMigration* migration) {
  return *reinterpret_cast<MigrationState*>(migration);
}

const PlinianMigrate migrate_table = {
    sizeof(PlinianMigrate),
    [](PlinianMigration* m, const char* path) -> const char* {
      const graph::StoredAttribute* found = state_of(m).find_by_any_name(text_of(path));
      if (!found) return nullptr;
      state_of(m).text = found->text;
      return state_of(m).text.c_str();
    },
    [](PlinianMigration* m, const char* path, const char* text) {
      // Under the name that is given: what is set under the new one outlives that the old one is removed.
      std::erase_if(state_of(m).attributes,
                    [&](const graph::StoredAttribute& attribute) { return attribute.path == text_of(path); });
      state_of(m).attributes.push_back({text_of(path), text_of(text)});  // last: it counts
    },
    [](PlinianMigration* m, const char* path) {
      if (const graph::StoredAttribute* found = state_of(m).find_by_any_name(text_of(path)))
        std::erase_if(state_of(m).attributes, [gone = found->path](const graph::StoredAttribute& attribute) {
          return attribute.path == gone;
        });
    },
    [](PlinianMigration* m, const char* message) {
      state_of(m).failure = message && *message ? message : "no reason is given";
    }};

}  // namespace

graph::NodeTypeSpec node_type_from(const PlinianNodeType* plain, const std::shared_ptr<DataCount>& data) {
  const PlinianNodeType from = whole(plain);
  graph::NodeTypeSpec spec;
  spec.name = text_of(from.name);
  spec.help = text_of(from.help);
  spec.version = from.version;
  spec.concurrent = !(from.flags & PLINIAN_NODE_NOT_CONCURRENT);
  spec.hierarchical = from.flags & PLINIAN_NODE_HIERARCHICAL;
  spec.holds_children = from.flags & PLINIAN_NODE_HOLDS_CHILDREN;
  spec.follows = from.flags & PLINIAN_NODE_FOLLOWS;
  spec.unique = from.flags & PLINIAN_NODE_UNIQUE;
  spec.time_source = from.flags & PLINIAN_NODE_TIME_SOURCE;
  for (const PlinianAttribute& attribute : all_of(from.attributes, from.attribute_count))
    spec.attributes.push_back(attribute_from(attribute));
  for (const std::string& alias : words_of(from.aliases)) {
    const std::size_t equals = alias.find('=');
    if (equals == alias.npos) throw GraphError("node type '" + spec.name + "': an alias is written old=new");
    spec.aliases.push_back({alias.substr(0, equals), alias.substr(equals + 1)});
  }
  add_hidden_outputs(spec, from, data);
  if (spec.hierarchical) add_visibility(spec);
  if (from.migrate)
    for (int version = 1; version < spec.version; ++version)
      spec.migrators.push_back(
          {version, [migrate = from.migrate, user = from.user, version, data, name = spec.name,
                     aliases = spec.aliases](graph::StoredAttributes& attributes) {
             const InsidePlugin inside(data->owner, "migrating nodes of the type", name.c_str());
             MigrationState state{attributes, aliases};
             migrate(user, version, &migrate_table, reinterpret_cast<PlinianMigration*>(&state));
             if (!state.failure.empty()) throw GraphError(state.failure);
           }});
  return spec;
}

}  // namespace plinian::sdk
