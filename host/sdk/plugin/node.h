// Node types in C++: attributes, the context of a compute function, migration.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/context.h"
#include "host/sdk/plugin/draw.h"
#include "host/sdk/plugin/handle.h"
#include "host/sdk/plugin/scene.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

/// As the host's own declaration of an attribute. Types and defaults are spelled as in scene files.
struct AttributeSpec {
  std::string name{}, type = "float", default_value{}, nice_name{}, help{}, unit{};
  std::string group{}, choices{}, data_type{}, affects{};
  std::optional<double> minimum{}, maximum{}, soft_minimum{}, soft_maximum{};
  bool array = false, output = false, hidden = false, read_only = false;
  bool keyable = true, storable = true, connectable = true;
  bool of_picture = true;  // of a shape: affects its contribution
  std::vector<AttributeSpec> children{};
  std::string widget{};      // "slider", "factor"; "grid of NAME": text, a grid of the .vdb file of attribute
                             // NAME, whose grids are offered; "grid of NAME or none"; "file .exr .png": a
                             // path, of those that a browser lists
  std::string shown_when{};  // "mode=low,high": shown while the attribute reads so
  double step = 0.0;         // of the slider; 0: smooth
};

/// The attributes of a node in an older scene, by their paths, as texts. Aliases hold here too: what the
/// scene has under an old name is read, and removed, by any of the attribute's names. What is set counts over
/// what another name of the attribute holds; what the type has no attribute for, or that is no value of it,
/// is told with the node's name and stays in the scene as a line.
class Migration {
 public:
  Migration(const PlinianMigrate& table, PlinianMigration* migration)
      : table_(table), migration_(migration) {}
  std::optional<std::string> text(const std::string& path) const {
    const char* found = table_.text(migration_, path.c_str());
    return found ? std::optional<std::string>(found) : std::nullopt;
  }
  void set(const std::string& path, const std::string& text) {
    table_.set(migration_, path.c_str(), text.c_str());
  }
  void remove(const std::string& path) { table_.remove(migration_, path.c_str()); }

 private:
  const PlinianMigrate& table_;
  PlinianMigration* migration_;
};

struct NodeType {
  explicit NodeType(std::string type_name, int type_version = 1)
      : name(std::move(type_name)), version(type_version) {}

  /// The attribute's number; those of its children follow it.
  Attribute add(AttributeSpec spec) {
    const Attribute attribute{count_};
    count_ += size_of(spec);
    attributes.push_back(std::move(spec));
    return attribute;
  }
  /// The child of a compound that was added.
  static Attribute child(Attribute compound, const AttributeSpec& spec, const std::string& name) {
    std::int32_t index = compound.index + 1;
    for (const AttributeSpec& child : spec.children) {
      if (child.name == name) return {index};
      index += size_of(child);
    }
    throw Error("there is no child '" + name + "'");
  }

  std::string name, help, aliases;  // aliases: "old=new older=new"
  int version = 1;
  bool hierarchical = false;  // has a place under transforms and, where it declares none, a visibility
  bool concurrent = true, holds_children = false, follows = false;
  bool unique = false;       // a scene has one: what is imported shares it instead of bringing its own
  bool time_source = false;  // its compute function may ask for the time
  std::vector<AttributeSpec> attributes;
  std::function<void(Context&, Attribute output)> compute;
  /// Makes the type a shape: adds what the node shows in every picture. All inputs affect it, but those
  /// declared otherwise (of_picture).
  std::function<void(Context&, Contribution&)> contribute;
  /// What only a viewport shows of the nodes: draw_override(Draw<Data, Resources>{...}).
  std::optional<AnyDraw> draw;
  /// What an artist takes hold of in a viewport.
  std::vector<Handle> handles;
  /// From version `from` to the next one. Throws where it cannot: the nodes then stay as they stand in the
  /// scene, and come alive with a plug-in that can.
  std::function<void(int from, Migration&)> migrate;

 private:
  static std::int32_t size_of(const AttributeSpec& spec) {
    std::int32_t count = 1;
    for (const AttributeSpec& child : spec.children) count += size_of(child);
    return count;
  }
  std::int32_t count_ = 0;
};

namespace detail {

// The C form of attributes; children live in `store`.
inline PlinianAttribute plain(const AttributeSpec& spec, std::deque<std::vector<PlinianAttribute>>& store) {
  std::vector<PlinianAttribute> children;
  for (const AttributeSpec& child : spec.children) children.push_back(plain(child, store));
  store.push_back(std::move(children));
  PlinianAttribute result{};
  result.size = sizeof(PlinianAttribute);
  result.name = spec.name.c_str();
  result.type = spec.type.c_str();
  result.default_value = text_or_null(spec.default_value);
  result.nice_name = text_or_null(spec.nice_name);
  result.help = text_or_null(spec.help);
  result.unit = text_or_null(spec.unit);
  result.group = text_or_null(spec.group);
  result.choices = text_or_null(spec.choices);
  result.data_type = text_or_null(spec.data_type);
  result.affects = text_or_null(spec.affects);
  result.minimum = number_or_null(spec.minimum);
  result.maximum = number_or_null(spec.maximum);
  result.soft_minimum = number_or_null(spec.soft_minimum);
  result.soft_maximum = number_or_null(spec.soft_maximum);
  result.flags = (spec.array ? PLINIAN_ATTRIBUTE_ARRAY : 0u) | (spec.output ? PLINIAN_ATTRIBUTE_OUTPUT : 0u) |
                 (spec.hidden ? PLINIAN_ATTRIBUTE_HIDDEN : 0u) |
                 (spec.read_only ? PLINIAN_ATTRIBUTE_READ_ONLY : 0u) |
                 (spec.keyable ? 0u : PLINIAN_ATTRIBUTE_NOT_KEYABLE) |
                 (spec.storable ? 0u : PLINIAN_ATTRIBUTE_NOT_STORABLE) |
                 (spec.connectable ? 0u : PLINIAN_ATTRIBUTE_NOT_CONNECTABLE) |
                 (spec.of_picture ? 0u : PLINIAN_ATTRIBUTE_NOT_OF_PICTURE);
  result.widget = text_or_null(spec.widget);
  result.shown_when = text_or_null(spec.shown_when);
  result.step = spec.step;
  result.children = store.back().data();
  result.child_count = store.back().size();
  return result;
}

// type: stays where it is until the plug-in is uninitialised.
inline int register_type(const PlinianHost& host, NodeType& type) {
  std::deque<std::vector<PlinianAttribute>> store;
  std::vector<PlinianAttribute> attributes;
  for (const AttributeSpec& spec : type.attributes) attributes.push_back(plain(spec, store));
  PlinianNodeType plain{};
  plain.size = sizeof(PlinianNodeType);
  plain.name = type.name.c_str();
  plain.help = type.help.c_str();
  plain.version = type.version;
  plain.flags = (type.concurrent ? 0u : PLINIAN_NODE_NOT_CONCURRENT) |
                (type.hierarchical ? PLINIAN_NODE_HIERARCHICAL : 0u) |
                (type.holds_children ? PLINIAN_NODE_HOLDS_CHILDREN : 0u) |
                (type.follows ? PLINIAN_NODE_FOLLOWS : 0u) | (type.unique ? PLINIAN_NODE_UNIQUE : 0u) |
                (type.time_source ? PLINIAN_NODE_TIME_SOURCE : 0u);
  plain.attributes = attributes.data();
  plain.attribute_count = attributes.size();
  plain.aliases = text_or_null(type.aliases);
  plain.user = &type;
  if (type.compute)
    plain.compute = [](void* user, const PlinianCompute* table, PlinianContext* context,
                       std::int32_t output) {
      guarded(
          [&] {
            Context wrapped(*table, context);
            static_cast<NodeType*>(user)->compute(wrapped, Attribute{output});
          },
          [&](const char* message) { table->fail(context, message); });
    };
  if (type.contribute)
    plain.contribute = [](void* user, const PlinianCompute* table, PlinianContext* context,
                          const PlinianContribute* contribute, PlinianContribution* contribution) {
      guarded(
          [&] {
            Context wrapped(*table, context);
            Contribution out(*contribute, contribution, wrapped);
            static_cast<NodeType*>(user)->contribute(wrapped, out);
          },
          [&](const char* message) { table->fail(context, message); });
    };
  const std::vector<PlinianHandle> handles = detail::plain(type.handles);
  plain.handles = handles.data();
  plain.handle_count = handles.size();
  PlinianDraw draw{};
  if (type.draw) {
    draw = detail::plain(*type.draw);
    plain.draw = &draw;
  }
  if (type.migrate)
    plain.migrate = [](void* user, std::int32_t from, const PlinianMigrate* table,
                       PlinianMigration* migration) {
      guarded(
          [&] {
            Migration wrapped(*table, migration);
            static_cast<NodeType*>(user)->migrate(from, wrapped);
          },
          [&](const char* message) { table->fail(migration, message); });
    };
  return host.register_node_type(host.self, &plain);
}

}  // namespace detail

}  // namespace sdk
}  // namespace plinian
