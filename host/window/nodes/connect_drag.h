// A wire in the hand: from which plug, which other plugs would take it, and what letting it go there does.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/window/nodes/diagram_hit.h"

namespace plinian::window {

class ConnectDrag {
 public:
  /// Takes hold at a plug of the diagram. One that is driven gives up the end of its wire; any other begins a
  /// new one.
  ConnectDrag(const graph::Graph& graph, const Diagram& diagram, const DiagramHit& begun);

  /// The plug at the end that stays.
  const graph::Plug& held() const { return held_; }
  /// Whether the wire in the hand looks for a plug that takes it; else for one that gives.
  bool wants_taker() const { return wants_taker_; }
  /// The plug that the wire was taken off, if any.
  const std::optional<graph::Plug>& taken_off() const { return taken_off_; }

  /// Why the wire cannot end at a plug, in one line; empty where it can. Found once for each plug, until the
  /// graph changes.
  const std::string& problem(const graph::Graph& graph, const graph::Plug& plug, bool gives);

  /// The commands that letting it go does, one step of undo: on a plug that takes it they connect; beside all
  /// plugs they break the connection that was taken off; where it cannot end, none.
  std::vector<std::string> let_go(const graph::Graph& graph, const Diagram& diagram, const DiagramHit& at);

 private:
  graph::Plug held_;
  bool wants_taker_ = true;
  std::optional<graph::Plug> taken_off_;
  std::map<std::pair<graph::Plug, bool>, std::string> problems_;
  std::uint64_t generation_ = ~std::uint64_t(0);
};

}  // namespace plinian::window
