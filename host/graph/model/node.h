// A node as the graph holds it and as workers read it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/graph/model/plug.h"
#include "host/graph/types/node_type.h"

namespace plinian::graph {

/// A value that was set: on an attribute that is no array, one that differs from the default.
struct StoredValue {
  AttributeIndex attribute = no_attribute;
  std::int32_t element = -1;
  Value value;
};

/// A connection, seen from where it ends.
struct Input {
  AttributeIndex attribute = no_attribute;
  std::int32_t element = -1, component = -1;
  Plug source;
};

/// Where a kept line stands among those that are understood: behind all of them that come no later. Of a line
/// about an attribute that there is it is that attribute's own place, else that of the line before it.
struct LinePlace {
  bool lock = false;  // among the locks, which stand behind all values
  AttributeIndex attribute = no_attribute;
  std::int32_t element = -1, component = -1;
  std::int32_t order = 0;  // among lines of one place; 0: understood
  auto operator<=>(const LinePlace&) const = default;
};

/// A line of a scene file that nothing here understands, kept word for word.
struct KeptLine {
  std::string text{};         // the whole line; unused for a connection
  std::string path{};         // connection: the attribute of this node ...
  NodeId source{};            // ... the node it comes from (0: no connection)
  std::string source_path{};  // ... and that one's attribute
  LinePlace place{};          // of a node whose type is known
};

struct Node {
  NodeId id;
  std::string name;  // unique in the graph; namespaces before colons
  NodeTypePtr type;
  SchemaPtr schema;                 // the type's, and what addAttr added
  NodeId parent;                    // in the transform hierarchy; 0: at the top
  NodeId kept_parent;               // that a scene file names and that it cannot have; 0: none
  std::vector<StoredValue> values;  // in order of attribute and element
  std::vector<Input> inputs;        // in order of attribute, element and component
  std::vector<Plug> locked;         // in order
  std::vector<KeptLine> kept;       // in the order of the file
  std::uint64_t epoch = 0;          // the graph's own book-keeping

  /// What was set, or null. An element of -1 is no element.
  const Value* stored(AttributeIndex attribute, std::int32_t element = -1) const;
  /// What was set, or the default. The reference holds until the next edit.
  const Value& value(AttributeIndex attribute, std::int32_t element = -1) const;
  /// The connection into exactly that place, or null.
  const Input* input(AttributeIndex attribute, std::int32_t element = -1, std::int32_t component = -1) const;
  /// The connections into the plug or into its components, in order.
  std::span<const Input> inputs_of(AttributeIndex attribute, std::int32_t element = -1) const;
  bool is_locked(AttributeIndex attribute, std::int32_t element = -1) const;
  /// Elements that exist in the array that the attribute is or is a part of, ascending: those in which
  /// anything was set or is connected. {-1} where it is no array.
  std::vector<std::int32_t> elements(AttributeIndex attribute) const;
};

using NodePtr = std::shared_ptr<const Node>;

}  // namespace plinian::graph
