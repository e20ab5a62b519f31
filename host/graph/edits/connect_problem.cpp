// Kinds, locks, drivers, cycles: in that order, so that the plainest reason is told.
#include "host/graph/edits/connect_problem.h"

#include "host/graph/edits/kept_connections.h"
#include "host/graph/model/conversion.h"
#include "host/graph/model/cycles.h"

namespace plinian::graph {

namespace {

std::string problem_of_one(const Graph& graph, const Plug& source, const Plug& array_or_plug, bool replace) {
  const SchemaAttribute &from = graph.attribute(source), &to = graph.attribute(array_or_plug);
  const Plug destination = next_free(graph, array_or_plug);
  const Node& node = *graph.find(destination.node);
  // Names are for those that are refused.
  const auto source_name = [&] { return graph.name_of(source); };
  const auto name = [&] { return graph.name_of(destination); };
  if (from.array != no_attribute && source.element < 0)
    return source_name() + " is an array: name an element, as " + from.path + "[0]";
  if (!from.spec.connectable) return source_name() + " cannot be connected";
  if (!to.spec.connectable) return name() + " cannot be connected";
  if (to.spec.output || to.spec.read_only) return name() + " is an output and cannot be driven";
  if (node.is_locked(destination.attribute, destination.element)) return name() + " is locked";
  const std::string problem =
      connection_problem(from.spec, source.component >= 0, to.spec, destination.component >= 0);
  if (!problem.empty()) return "cannot connect " + source_name() + " to " + name() + ": " + problem;
  const Input* same = node.input(destination.attribute, destination.element, destination.component);
  if (same && same->source == source) return "";
  for (const Input& input : node.inputs_of(destination.attribute, destination.element)) {
    const bool overlaps =
        destination.component < 0 || input.component < 0 || input.component == destination.component;
    if (overlaps && !replace)
      return name() + " is already driven by " + graph.name_of(input.source) +
             ": disconnect it first, or connect with -force";
  }
  const std::vector<std::size_t> kept = kept_connections_into(node, destination);
  if (!kept.empty() && !replace)
    return name() + " is already driven by " + kept_source_name(graph, node.kept[kept.front()]) +
           ", of a type that is not known here: disconnect it first, or connect with -force";
  const auto cycle = cycle_through(graph, source, destination);
  if (!cycle.empty())
    return "cannot connect " + source_name() + " to " + name() + ": it would close the cycle " +
           describe_path(graph, cycle) + " -> " + graph.name_of(destination.whole());
  return "";
}

}  // namespace

Plug next_free(const Graph& graph, Plug destination) {
  if (graph.attribute(destination).array == no_attribute || destination.element >= 0) return destination;
  const auto elements = graph.find(destination.node)->elements(destination.attribute);
  destination.element = elements.empty() ? 0 : elements.back() + 1;
  return destination;
}

std::string connect_problem(const Graph& graph, const Plug& source, const Plug& destination, bool replace) {
  const auto type_of = [&](const Plug& plug) { return graph.attribute(plug).spec.type; };
  if (type_of(source) != AttributeType::compound || type_of(destination) != AttributeType::compound)
    return problem_of_one(graph, source, destination, replace);
  const auto sources = graph.find(source.node)->schema->leaves(source.attribute);
  const auto targets = graph.find(destination.node)->schema->leaves(destination.attribute);
  if (sources.size() != targets.size())
    return graph.name_of(source) + " and " + graph.name_of(destination) +
           " hold different numbers of attributes";
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (std::string problem = problem_of_one(graph, {source.node, sources[i], source.element},
                                             {destination.node, targets[i], destination.element}, replace);
        !problem.empty())
      return problem;
  return "";
}

}  // namespace plinian::graph
