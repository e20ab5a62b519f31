// Names and words.
#include "host/window/fields/edit_lines.h"

#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"

namespace plinian::window {

using graph::Plug;

namespace {

// The plug itself first, then what it is on the other selected nodes.
std::vector<std::string> names_of_all(const graph::Graph& graph, const Plug& plug) {
  std::vector<std::string> names = {graph.name_of(plug)};
  const graph::Node& leader = *graph.find(plug.node);
  const std::string path = graph::Graph::path_of(*leader.schema, plug);
  const graph::AttributeType type = graph.attribute(plug).spec.type;
  const auto& selection = graph.selection();
  if (std::find(selection.begin(), selection.end(), plug.node) == selection.end()) return names;
  for (const graph::NodeId id : selection) {
    const graph::Node* node = graph.find(id);
    if (!node || id == plug.node) continue;
    try {
      const Plug other = graph::Graph::plug(*node, path);
      if (graph.attribute(other).spec.type == type) names.push_back(graph.name_of(other));
    } catch (const graph::GraphError&) {
      // It has no such attribute.
    }
  }
  return names;
}

}  // namespace

std::vector<std::string> set_lines(const graph::Graph& graph, const Plug& plug, const std::string& words) {
  std::vector<std::string> lines;
  for (const std::string& name : names_of_all(graph, plug)) lines.push_back("setAttr " + name + " " + words);
  return lines;
}

std::vector<std::string> reset_lines(const graph::Graph& graph, const Plug& plug) {
  std::vector<std::string> lines;
  for (const std::string& name : names_of_all(graph, plug)) lines.push_back("resetAttr " + name);
  return lines;
}

std::string words_at(const graph::Graph& graph, const Plug& plug) {
  const graph::Node& node = *graph.find(plug.node);
  if (plug.component >= 0) return graph::write_number(float(number_at(graph, plug)));
  return graph::write_value(graph.attribute(plug).spec, node.value(plug.attribute, plug.element),
                            graph.names());
}

double number_at(const graph::Graph& graph, const Plug& plug) {
  const graph::Value& value = graph.find(plug.node)->value(plug.attribute, plug.element);
  if (plug.component < 0) return graph::number_of(value);
  const std::size_t c = std::size_t(plug.component);
  if (const vec2* v = std::get_if<vec2>(&value)) return (*v)[int(c)];
  if (const vec3* v = std::get_if<vec3>(&value)) return (*v)[int(c)];
  if (const vec4* v = std::get_if<vec4>(&value)) return (*v)[int(c)];
  return 0.0;
}

}  // namespace plinian::window
