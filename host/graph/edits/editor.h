// What one may do to a scene, in words of the trade. Each function checks, then performs edits as one step of
// undo; what cannot be throws GraphError in one line and changes nothing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/graph/edits/history.h"
#include "host/graph/model/graph.h"

namespace plinian::graph {

/// Whether a word may name a node: identifiers with colons between, as in "ash:noise1".
bool is_node_name(std::string_view name);

class Editor {
 public:
  Editor(Graph& graph, History& history) : graph_(graph), history_(history) {}

  /// A new node. name: what it is to be called; a number makes it unique; empty: after its type. parent: 0
  /// for none.
  NodeId create_node(const NodeTypePtr& type, const std::string& name = "", NodeId parent = {});
  /// Puts a node in place as it is, under a name made unique: how files are read. Its number is given here.
  NodeId add_node(Node node);
  /// Deletes nodes, what is under them, their connections, and what drove nothing else (animation curves).
  void delete_nodes(const std::vector<NodeId>& nodes);
  /// What would drive nothing once the nodes and what is under them are gone, and drives them now: neither
  /// what has a place in the transform hierarchy nor what a scene has one of.
  std::vector<NodeId> served_only(const std::vector<NodeId>& nodes) const;
  /// Returns the name that it got: a number makes it unique.
  std::string rename(NodeId node, const std::string& name);
  /// Copies of the nodes and of what is under them, with values, and driven by what drives the originals: by
  /// its copy where that is copied as well, as nodes are that only drive one, the curves of its keys, unless
  /// share_keys. Returns the copies of `nodes`, in their order.
  std::vector<NodeId> duplicate(const std::vector<NodeId>& nodes, bool share_keys = false);
  /// parent: 0 for the top.
  void set_parent(const std::vector<NodeId>& nodes, NodeId parent);
  /// Puts a node under another one as a scene file has it. Where it can have no parent, or the other one no
  /// children, that is kept for the next file and it stands as near as it can. Returns what is to be said of
  /// that; empty where all is well. Throws GraphError where it would be under itself.
  std::string place(NodeId node, NodeId parent);

  /// Sets an attribute, an element or a component. An equal value changes nothing. Returns false where the
  /// value was out of the hard range and was clamped.
  bool set(const Plug& plug, const Value& value);
  /// Back to the default; an element of an array, or all of it, ceases to exist. Connections stay.
  void reset(const Plug& plug);
  void lock(const Plug& plug, bool locked);
  /// An attribute that only this node has.
  Plug add_attribute(NodeId node, const AttributeSpec& spec);

  /// Connects attributes, or compounds child by child. An array without an element takes the next free one.
  /// An input that is connected already is refused, or, with `replace`, taken over.
  void connect(const Plug& source, const Plug& destination, bool replace = false);
  /// Breaks the connections into a plug, its components and what is in it.
  void disconnect(const Plug& destination);

  void select(const std::vector<NodeId>& nodes);

  /// Keeps lines of a scene file with a node, or what a file says of a type (null: forgets it).
  void set_kept(NodeId node, std::vector<KeptLine> kept);
  void set_kept_type(const std::string& type, std::optional<KeptType> kept);
  /// Puts a node of another type in the place of one without connections; number, name and parent stay.
  void replace_node(Node node);

  Graph& graph() { return graph_; }
  History& history() { return history_; }

  /// Why the attribute cannot be set, as "ball.density is locked"; empty where it can.
  std::string set_problem(const Plug& plug) const;

 private:
  void check_version(const NodeType& type);
  void keep_parent(NodeId node, NodeId parent);
  void connect_one(const Plug& source, Plug destination, bool replace);
  void set_stored(const Plug& plug, std::optional<Value> value);
  void disconnect_all(NodeId node);
  std::vector<NodeId> followers(const std::vector<NodeId>& doomed,
                                const std::function<bool(const Node&)>& goes) const;

  Graph& graph_;
  History& history_;
};

/// All plugs without children that the plug stands for: of a compound its leaves, of an array its elements.
std::vector<Plug> leaf_plugs(const Graph& graph, const Plug& plug);

}  // namespace plinian::graph
