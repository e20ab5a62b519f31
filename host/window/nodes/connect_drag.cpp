// Asks the graph, answers in commands.
#include "host/window/nodes/connect_drag.h"

#include "host/graph/edits/connect_problem.h"

namespace plinian::window {

using graph::Plug;

namespace {

const graph::Input* input_of(const graph::Graph& graph, const Plug& plug) {
  return graph.find(plug.node)->input(plug.attribute, plug.element, plug.component);
}

bool is_driven_by_another(const graph::Graph& graph, const Plug& source, const Plug& destination) {
  return !graph::connect_problem(graph, source, destination, false).empty();
}

}  // namespace

ConnectDrag::ConnectDrag(const graph::Graph& graph, const Diagram& diagram, const DiagramHit& begun)
    : held_(diagram.boxes[begun.box].rows[begun.row].plug) {
  wants_taker_ = begun.part == DiagramPart::giving_plug;
  if (wants_taker_) return;
  if (const graph::Input* input = input_of(graph, held_)) {
    taken_off_ = held_;
    held_ = input->source;
    wants_taker_ = true;
  }
}

const std::string& ConnectDrag::problem(const graph::Graph& graph, const Plug& plug, bool gives) {
  if (generation_ != graph.generation()) {
    generation_ = graph.generation();
    problems_.clear();
  }
  const auto [known, fresh] = problems_.try_emplace({plug, gives});
  if (!fresh) return known->second;
  std::string& problem = known->second;
  if (!graph.find(held_.node) || !graph.find(plug.node))
    problem = "the node is gone";
  else if (gives == wants_taker_)
    problem = wants_taker_ ? "the wire needs a plug on the left of a node, which takes it"
                           : "the wire needs a plug on the right of a node, which gives it";
  else if (plug == taken_off_)
    problem = "";
  else
    problem = wants_taker_ ? graph::connect_problem(graph, held_, plug, true)
                           : graph::connect_problem(graph, plug, held_, true);
  return problem;
}

std::vector<std::string> ConnectDrag::let_go(const graph::Graph& graph, const Diagram& diagram,
                                             const DiagramHit& at) {
  if (!graph.find(held_.node) || (taken_off_ && !graph.find(taken_off_->node))) return {};
  std::vector<std::string> lines;
  const auto take_off = [&] {
    if (taken_off_ && input_of(graph, *taken_off_))
      lines.push_back("disconnectAttr " + graph.name_of(*taken_off_));
  };
  if (at.part != DiagramPart::taking_plug && at.part != DiagramPart::giving_plug) {
    take_off();
    return lines;
  }
  const Plug other = diagram.boxes[at.box].rows[at.row].plug;
  const bool gives = at.part == DiagramPart::giving_plug;
  if (other == taken_off_ || !problem(graph, other, gives).empty()) return {};
  const Plug source = wants_taker_ ? held_ : other;
  const Plug destination = graph::next_free(graph, wants_taker_ ? other : held_);
  take_off();
  lines.push_back("connectAttr " + graph.name_of(source) + " " + graph.name_of(destination) +
                  (is_driven_by_another(graph, source, destination) ? " -force" : ""));
  return lines;
}

}  // namespace plinian::window
