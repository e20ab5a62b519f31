// Which plugs a box shows, and what becomes wires.
#include "host/window/nodes/diagram.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "host/graph/values/value_text.h"

namespace plinian::window {

using graph::AttributeIndex;
using graph::AttributeType;
using graph::NodeId;
using graph::Plug;

namespace {

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower((unsigned char)c));
  return text;
}

// "0.125" of a float that was given as 0.125, and no more of a path than its name.
std::string short_value(const graph::Graph& graph, const graph::AttributeSpec& spec,
                        const graph::Value& value) {
  if (spec.type == AttributeType::data || spec.type == AttributeType::matrix ||
      spec.type == AttributeType::compound || spec.type == AttributeType::colour)
    return "";
  std::string text = graph::write_value(spec, value, graph.names());
  if (text == "\"\"") return "";
  if (spec.type == AttributeType::path || spec.type == AttributeType::string) {
    std::erase(text, '"');
    if (const auto slash = text.rfind('/'); slash != text.npos) text = text.substr(slash + 1);
  }
  constexpr std::size_t most = 14;
  if (text.size() > most) text = text.substr(0, most - 2) + "..";
  return text;
}

class BoxMaker {
 public:
  BoxMaker(const graph::Graph& graph, const graph::Node& node, const DiagramChoice& choice)
      : graph_(graph), node_(node), filter_(lower(choice.filter)) {
    box_.id = node.id;
    box_.name = node.name;
    box_.type = node.type->name();
    box_.open = choice.open.contains(node.id);
  }

  NodeBox run() {
    for (const graph::Input& input : node_.inputs)
      connected_.insert({node_.id, input.attribute, input.element, input.component});
    for (const graph::Connection& connection : graph_.outgoing(node_.id))
      connected_.insert(connection.source);
    for (AttributeIndex i = 0; i < node_.schema->size(); ++i) add_attribute(i);
    return std::move(box_);
  }

 private:
  void add_attribute(AttributeIndex index) {
    const graph::SchemaAttribute& attribute = (*node_.schema)[index];
    const graph::AttributeSpec& spec = attribute.spec;
    const bool can = spec.connectable && !spec.hidden;
    const bool named = !filter_.empty() && lower(attribute.path).find(filter_) != std::string::npos;
    const bool wanted = can && (box_.open || named || spec.type == AttributeType::data);
    const Plug whole{node_.id, index};
    if (can && !wanted && !connected_.contains(whole)) box_.has_more = true;
    if (attribute.array != graph::no_attribute) {
      for (const std::int32_t element : node_.elements(index)) add_plug({node_.id, index, element}, wanted);
      // The next element, which a connection makes.
      if (wanted && !spec.output && spec.type != AttributeType::compound) add_row(whole);
    } else {
      add_plug(whole, wanted);
    }
  }

  void add_plug(const Plug& plug, bool wanted) {
    if (wanted || connected_.contains(plug)) add_row(plug);
    for (int c = 0; c < graph::component_count(graph_.attribute(plug).spec.type); ++c)
      if (Plug part = plug; part.component = c, connected_.contains(part)) add_row(part);
  }

  void add_row(const Plug& plug) {
    const graph::AttributeSpec& spec = graph_.attribute(plug).spec;
    PlugRow row;
    row.plug = plug;
    row.label = graph::Graph::path_of(*node_.schema, plug);
    const bool is_next = graph_.attribute(plug).array != graph::no_attribute && plug.element < 0;
    if (is_next) row.label += "[+]";
    row.driven = node_.input(plug.attribute, plug.element, plug.component) != nullptr;
    const auto& outgoing = graph_.outgoing(node_.id);
    const auto first = outgoing.lower_bound({plug, {}});
    row.drives = first != outgoing.end() && first->source == plug;
    row.locked = node_.is_locked(plug.attribute, plug.element);
    row.takes = !spec.output && !spec.read_only;
    row.gives = !is_next && (spec.output || row.drives || (box_.open && spec.type != AttributeType::data));
    if (row.takes && !row.driven && !is_next && plug.component < 0) {
      const graph::Value& value = node_.value(plug.attribute, plug.element);
      row.value = short_value(graph_, spec, value);
      if (const vec3* colour = std::get_if<vec3>(&value); colour && spec.type == AttributeType::colour)
        row.colour = *colour;
    }
    box_.rows.push_back(std::move(row));
  }

  const graph::Graph& graph_;
  const graph::Node& node_;
  std::string filter_;
  NodeBox box_;
  std::set<Plug> connected_;
};

}  // namespace

std::set<NodeId> connected_with(const graph::Graph& graph, const std::set<NodeId>& nodes) {
  std::set<NodeId> all;
  for (const bool upstream : {true, false}) {
    std::vector<NodeId> open(nodes.begin(), nodes.end());
    std::set<NodeId> seen;
    while (!open.empty()) {
      const NodeId id = open.back();
      open.pop_back();
      const graph::Node* node = graph.find(id);
      if (!node || !seen.insert(id).second) continue;
      if (upstream) {
        for (const graph::Input& input : node->inputs) open.push_back(input.source.node);
        if (node->parent) open.push_back(node->parent);
      } else {
        for (const graph::Connection& connection : graph.outgoing(id))
          open.push_back(connection.destination.node);
        const auto& children = graph.children(id);
        open.insert(open.end(), children.begin(), children.end());
      }
    }
    all.merge(seen);
  }
  return all;
}

Diagram diagram_of(const graph::Graph& graph, const DiagramChoice& choice) {
  Diagram diagram;
  const auto shown = choice.around ? connected_with(graph, *choice.around) : std::set<NodeId>();
  std::map<NodeId, std::size_t> box_of;
  std::map<Plug, std::pair<std::size_t, std::size_t>> row_of;  // box and row
  for (const graph::Node* node : graph.nodes()) {
    if (choice.around && !shown.contains(node->id)) continue;
    box_of[node->id] = diagram.boxes.size();
    diagram.boxes.push_back(BoxMaker(graph, *node, choice).run());
  }
  for (std::size_t b = 0; b < diagram.boxes.size(); ++b)
    for (std::size_t r = 0; r < diagram.boxes[b].rows.size(); ++r)
      row_of[diagram.boxes[b].rows[r].plug] = {b, r};
  for (const NodeBox& box : diagram.boxes) {
    for (const graph::Connection& connection : graph.outgoing(box.id)) {
      const auto from = row_of.find(connection.source), to = row_of.find(connection.destination);
      if (from != row_of.end() && to != row_of.end())
        diagram.wires.push_back(
            {to->second.first, to->second.second, from->second.first, from->second.second});
    }
    for (const NodeId child : graph.children(box.id))
      if (const auto to = box_of.find(child); to != box_of.end())
        diagram.lineages.push_back({box_of.at(box.id), to->second});
  }
  std::sort(diagram.wires.begin(), diagram.wires.end());
  return diagram;
}

vec2 size_of(const NodeBox& box) {
  constexpr float foot = 5.0f;
  return {box_width, header_height + (box.rows.empty() ? 0.0f : float(box.rows.size()) * row_height + foot)};
}

vec2 plug_place(const NodeBox& box, std::size_t row, bool gives) {
  return box.place + vec2(gives ? box_width : 0.0f, header_height + (float(row) + 0.5f) * row_height + 2.0f);
}

std::optional<std::pair<vec2, vec2>> bounds_of(const std::vector<const NodeBox*>& boxes) {
  if (boxes.empty()) return std::nullopt;
  std::pair<vec2, vec2> bounds(boxes.front()->place, boxes.front()->place);
  for (const NodeBox* box : boxes) {
    bounds.first = glm::min(bounds.first, box->place);
    bounds.second = glm::max(bounds.second, box->place + size_of(*box));
  }
  return bounds;
}

}  // namespace plinian::window
