// Asks the evaluator's workers.
#include "host/window/fields/driven_values.h"

#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"

namespace plinian::window {

namespace {

std::vector<graph::Plug> drivers_of(const graph::Graph& graph, const graph::Plug& plug) {
  std::vector<graph::Plug> drivers;
  for (const graph::Input& input : graph.find(plug.node)->inputs_of(plug.attribute, plug.element))
    if (plug.component < 0 || input.component < 0 || input.component == plug.component)
      drivers.push_back(input.source.whole());
  return drivers;
}

// Whether what would have to be computed is over in no time: it is known, or curves of keys and the time.
bool is_quick(graph::Session& session, const std::vector<graph::Plug>& drivers) {
  const graph::Graph& graph = session.graph();
  constexpr std::size_t most = 16;
  std::set<graph::NodeId> seen;
  std::vector<graph::Plug> open;
  const auto visit = [&](const graph::Plug& output) {
    const graph::ResultPtr known = session.evaluator().known(output);
    if (known && known->has_value) return;
    if (seen.insert(output.node).second) open.push_back(output);
  };
  for (const graph::Plug& driver : drivers) visit(driver);
  while (!open.empty()) {
    const graph::Node& node = *graph.find(open.back().node);
    open.pop_back();
    if (node.type->name() != "animCurve" && node.type->name() != "time") return false;
    for (const graph::Input& input : node.inputs) visit(input.source.whole());
    if (seen.size() > most) return false;
  }
  return true;
}

}  // namespace

double DrivenValues::number(graph::Session& session, const graph::Plug& plug) {
  const std::vector<graph::Plug> drivers = drivers_of(session.graph(), plug);
  double& known = known_[plug];
  if (is_quick(session, drivers)) {
    const graph::ResultPtr result = session.evaluator().evaluate(plug);
    try {
      known = result->error ? 0.0 : graph::number_of(result->value);
    } catch (const graph::GraphError&) {
      known = 0.0;
    }
    return known;
  }
  if (!state_->asked.insert(plug).second) return known;
  session.evaluator().request(drivers, [state = state_, plug](const graph::Evaluator::Outcome&) {
    state->asked.erase(plug);
    state->has_news = true;  // also where an edit overtook it: then it is asked for again
  });
  return known;
}

}  // namespace plinian::window
