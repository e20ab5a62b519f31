// Searches from both ends in turn, until one of them has nowhere left to go.
#include "host/graph/model/cycles.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace plinian::graph {

namespace {

using Visit = std::function<void(const Plug&)>;

void for_each_driven(const Graph& graph, const Plug& plug, const Visit& visit) {
  const Node& node = *graph.find(plug.node);
  for (const AttributeIndex output : (*node.schema)[plug.attribute].affects) visit({plug.node, output});
  const auto& outgoing = graph.outgoing(plug.node);
  for (auto at = outgoing.lower_bound({{plug.node, plug.attribute, plug.element, -1}, {}});
       at != outgoing.end() && at->source.whole() == plug; ++at)
    visit(at->destination.whole());
}

void for_each_driver(const Graph& graph, const Plug& plug, const Visit& visit) {
  const Node& node = *graph.find(plug.node);
  for (const Input& input : node.inputs_of(plug.attribute, plug.element)) visit(input.source.whole());
  // An output depends on every connected place of the inputs that affect it.
  const auto& affected_by = (*node.schema)[plug.attribute].affected_by;
  if (affected_by.empty()) return;
  for (const Input& input : node.inputs)
    if (std::find(affected_by.begin(), affected_by.end(), input.attribute) != affected_by.end())
      visit({plug.node, input.attribute, input.element});
}

class Search {
 public:
  Search(const Graph& graph, const Plug& begin, const Plug& goal, decltype(&for_each_driven) neighbours)
      : graph_(graph), goal_(goal), neighbours_(neighbours) {
    came_from_.emplace(begin, begin);
    queue_.push_back(begin);
  }
  bool found() const { return came_from_.contains(goal_); }
  bool exhausted() const { return next_ == queue_.size(); }
  void step() {
    const Plug plug = queue_[next_++];
    neighbours_(graph_, plug, [&](const Plug& neighbour) {
      if (came_from_.emplace(neighbour, plug).second) queue_.push_back(neighbour);
    });
  }
  // From the goal back to the beginning.
  std::vector<Plug> way_back() const {
    std::vector<Plug> way = {goal_};
    while (way.back() != queue_.front()) way.push_back(came_from_.at(way.back()));
    return way;
  }

 private:
  const Graph& graph_;
  const Plug goal_;
  decltype(&for_each_driven) neighbours_;
  std::unordered_map<Plug, Plug> came_from_;
  std::vector<Plug> queue_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<Plug> cycle_through(const Graph& graph, const Plug& source, const Plug& destination) {
  Search down(graph, destination.whole(), source.whole(), for_each_driven);
  Search up(graph, source.whole(), destination.whole(), for_each_driver);
  while (!down.found() && !up.found()) {
    if (down.exhausted() || up.exhausted()) return {};
    down.step();
    up.step();
  }
  std::vector<Plug> way = down.found() ? down.way_back() : up.way_back();
  if (down.found()) std::reverse(way.begin(), way.end());
  return way;
}

std::string describe_path(const Graph& graph, const std::vector<Plug>& path) {
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.size() > 9 && i == 4) {  // a long way is told by its ends
      text += " -> (" + std::to_string(path.size() - 8) + " more)";
      i = path.size() - 4;
    }
    text += (i ? " -> " : "") + graph.name_of(path[i]);
  }
  return text;
}

}  // namespace plinian::graph
