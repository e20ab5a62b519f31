// The edits that everything done to a graph is made of. Each can be undone by another of them.
//
// They hold identifiers and values, never pointers into the graph, so that a step of undo is good for as long
// as the scene is open.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "host/graph/model/node.h"

namespace plinian::graph {

/// Puts a node in place that has neither connections nor children.
struct AddNode {
  NodePtr node;
};
/// Takes away a node that has neither connections nor children.
struct RemoveNode {
  NodeId node;
};
/// Puts another node in the place of the one with its number, name, parent and connections.
struct ReplaceNode {
  NodePtr node;
};
struct RenameNode {
  NodeId node;
  std::string name;
};
/// Stores a value, or forgets the one that is stored.
struct SetValue {
  Plug plug;
  std::optional<Value> value;
};
/// Makes, replaces or breaks the connection into a plug.
struct SetInput {
  Plug destination;
  std::optional<Plug> source;
};
struct SetLock {
  Plug plug;
  bool locked = true;
};
struct AddAttribute {
  NodeId node;
  std::shared_ptr<const AttributeSpec> spec;
};
/// Takes away the attribute that was added last.
struct RemoveAttribute {
  NodeId node;
};
struct SetParent {
  NodeId node, parent;
};
struct SetSelection {
  std::vector<NodeId> nodes;  // in the order of selection
};
/// What a scene file says of a type beyond what is known of it here. Under the name "": of the scene itself;
/// under "requires NAME": of a plug-in that it needs in a newer version than any type says.
struct KeptType {
  int version = 1;                     // of the type in the file
  std::string plugin, plugin_version;  // that it needs
  std::vector<std::string> lines;      // of the type's section, word for word
  /// Of each of them the path of the last line before it that is known here; empty: it stands before all of
  /// those. Where there are none, as of an unknown type, the lines are all there is.
  std::vector<std::string> after{};
  bool operator==(const KeptType&) const = default;
};
struct SetKeptType {
  std::string type;
  std::optional<KeptType> kept;
};

using Edit = std::variant<AddNode, RemoveNode, ReplaceNode, RenameNode, SetValue, SetInput, SetLock,
                          AddAttribute, RemoveAttribute, SetParent, SetSelection, SetKeptType>;

/// Whether the edit changes what a scene file would hold. A selection does not.
inline bool changes_scene(const Edit& edit) {
  return !std::holds_alternative<SetSelection>(edit);
}

}  // namespace plinian::graph
