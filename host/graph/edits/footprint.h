// What steps of undo touch: whether one can be undone while another one that came after it stays done.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "host/graph/edits/edit.h"

namespace plinian::graph {

class Graph;

struct Footprint {
  std::set<NodeId> nodes;       // edited, connected, parents
  std::set<std::string> names;  // that nodes had, got or lost
  std::set<std::string> types;  // of which lines of a scene file are kept
  bool joins = false;           // undoing it connects something or puts it under something, ...
  bool changes_joints = false;  // ... doing or undoing it changes what is connected or who is under whom

  void add(const Footprint& other);
  /// Whether undoing this step depends on undoing `later` ones first. Selections do not count.
  bool depends_on(const Footprint& later) const;
};

/// Plays steps back in thought, the one that comes next first.
class FootprintReader {
 public:
  explicit FootprintReader(const Graph& graph);
  /// inverses: of the next step, played from the last one on.
  Footprint read(std::span<const Edit> inverses);
  /// What is selected before the next step is played back.
  const std::vector<NodeId>& selection() const { return selection_; }

 private:
  void add(const Edit& edit, Footprint& footprint);
  std::string& name_of(NodeId node);
  NodeId& parent_of(NodeId node);
  std::optional<Plug>& source_of(const Plug& destination);

  const Graph& graph_;
  std::map<NodeId, std::string> names_;  // these three: of what was looked up or has changed
  std::map<NodeId, NodeId> parents_;
  std::map<Plug, std::optional<Plug>> sources_;  // by destination
  std::vector<NodeId> selection_;
};

}  // namespace plinian::graph
