// The node graph: nodes, what they are set to, what is connected to what, and who is under whom.
//
// Everybody may look; only History may change it, and only by edits, so that no change escapes undo.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "host/graph/edits/edit.h"
#include "host/graph/model/node.h"
#include "host/graph/model/node_pages.h"
#include "host/graph/values/flat_map.h"
#include "host/graph/values/value_text.h"

namespace plinian::graph {

struct Connection {
  Plug source, destination;
  auto operator<=>(const Connection&) const = default;
};

/// The whole graph at one moment. Immutable: workers read it while the graph goes on changing.
class GraphSnapshot {
 public:
  /// The node of that number, or null.
  const Node* find(NodeId id) const { return nodes_.find(id); }
  std::uint64_t generation() const { return generation_; }

 private:
  friend class Graph;
  NodePages nodes_;
  std::uint64_t generation_ = 0;
};
using GraphSnapshotPtr = std::shared_ptr<const GraphSnapshot>;

/// Is told of every edit after it was applied. Must not edit the graph from there.
class GraphObserver {
 public:
  virtual ~GraphObserver() = default;
  virtual void edited(const Edit& edit) = 0;
};

class Graph {
 public:
  Graph();
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  /// The node of that number or name, or null.
  const Node* find(NodeId id) const { return nodes_.find(id); }
  const Node* find(std::string_view name) const;
  /// The node of that name. Throws GraphError with the nearest name.
  const Node& get(std::string_view name) const;
  /// All nodes in the order in which they were created.
  std::vector<const Node*> nodes() const;
  std::size_t size() const { return by_name_.size(); }

  /// Connections that leave the node, ordered by where they begin.
  const std::set<Connection>& outgoing(NodeId id) const { return outgoing_[id.value]; }
  /// Children in the transform hierarchy, in order of creation. Of 0: the nodes at the top that have a place
  /// in it.
  const std::set<NodeId>& children(NodeId id) const { return children_[id.value]; }
  const std::vector<NodeId>& selection() const { return selection_; }
  const std::map<std::string, KeptType>& kept_types() const { return kept_types_; }

  /// What errors say beyond what the graph knows, given by whoever does; either may be empty. Whether a type
  /// is registered: then its unknown nodes are those that could not be migrated.
  std::function<bool(const std::string& type)> is_registered;
  /// What makes a node that is not there and has a usual name; empty for others.
  std::function<std::string(std::string_view name)> hint_at_node;

  /// "ash:noise1.key[3].time", "light1.colour.r".
  std::string name_of(const Plug& plug) const;
  /// Without the node: "key[3].time".
  static std::string path_of(const Schema& schema, const Plug& plug);
  /// The plug of that name. Throws GraphError, with the nearest name, for what is not there.
  Plug plug(std::string_view name) const;
  /// As above, on a given node.
  static Plug plug(const Node& node, std::string_view path);
  const SchemaAttribute& attribute(const Plug& plug) const {
    return (*find(plug.node)->schema)[plug.attribute];
  }
  /// How values spell references to nodes of this graph.
  NodeNames names() const;

  /// The name itself where it is free, else with the lowest number behind it that makes it so.
  std::string unique_name(const std::string& wanted) const;
  /// A number for a new node, never used before.
  NodeId new_id() const { return NodeId{next_id_}; }

  /// Counts edits.
  std::uint64_t generation() const { return generation_; }
  /// The graph as it is now; the same object until the next edit.
  GraphSnapshotPtr snapshot() const;

  void add_observer(GraphObserver* observer) const { observers_.push_back(observer); }
  void remove_observer(GraphObserver* observer) const { std::erase(observers_, observer); }

 private:
  friend class History;
  /// Applies an edit and returns the one that undoes it.
  Edit apply(const Edit& edit);

  Edit apply_one(const AddNode& edit);
  Edit apply_one(const RemoveNode& edit);
  Edit apply_one(const ReplaceNode& edit);
  Edit apply_one(const RenameNode& edit);
  Edit apply_one(const SetValue& edit);
  Edit apply_one(const SetInput& edit);
  Edit apply_one(const SetLock& edit);
  Edit apply_one(const AddAttribute& edit);
  Edit apply_one(const RemoveAttribute& edit);
  Edit apply_one(const SetParent& edit);
  Edit apply_one(const SetSelection& edit);
  Edit apply_one(const SetKeptType& edit);
  Node& changeable(NodeId id);

  NodePages nodes_;                            // number 0 is nobody's
  std::deque<std::set<Connection>> outgoing_;  // by number
  std::deque<std::set<NodeId>> children_;      // by number; of 0: the top of the hierarchy
  FlatMap<std::string, NodeId> by_name_;
  mutable std::unordered_map<std::string, int>
      next_number_;  // numbers below are taken, by name without number
  std::vector<NodeId> selection_;
  std::map<std::string, KeptType> kept_types_;
  std::uint32_t next_id_ = 1;
  std::uint64_t generation_ = 0;
  mutable std::uint64_t epoch_ = 1;  // nodes of an older one may be in a snapshot
  mutable GraphSnapshotPtr snapshot_;
  mutable std::vector<GraphObserver*> observers_;
};

}  // namespace plinian::graph
