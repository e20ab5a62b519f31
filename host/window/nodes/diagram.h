// The graph as boxes and wires: what the node editor shows of which nodes. Sizes and places are points of a
// canvas of its own, y down; where on it a box stands is said by who lays it out.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/shared/glue.h"
#include "host/graph/model/graph.h"

namespace plinian::window {

/// A line of a box: an attribute, an element or a component, with a plug on either side or on one.
struct PlugRow {
  graph::Plug plug;
  std::string label;           // "colour.r", "key[3]"
  std::string value;           // short; empty where it is driven, computed or has no text
  std::optional<vec3> colour;  // linear Rec.709, of a colour that is set
  bool takes = false;          // a plug on the left: can be driven
  bool gives = false;          // a plug on the right: can drive
  bool driven = false, drives = false;
  bool locked = false;
};

struct NodeBox {
  graph::NodeId id;
  std::string name, type;
  std::vector<PlugRow> rows;
  bool open = false;      // shows all it has
  bool has_more = false;  // ... or would show more
  vec2 place{0.0f};       // [points] of its upper left corner
};

struct Wire {
  std::size_t to_box, to_row, from_box, from_row;  // places in boxes and in their rows
  auto operator<=>(const Wire&) const = default;
};

/// The second is under the first in the transform hierarchy, whose place it takes.
struct Lineage {
  std::size_t parent, child;  // places in boxes
};

struct Diagram {
  std::vector<NodeBox> boxes;  // in order of creation
  std::vector<Wire> wires;     // by where they end
  std::vector<Lineage> lineages;
};

struct DiagramChoice {
  std::optional<std::set<graph::NodeId>> around;  // these with all that they depend on and drive; none: all
  std::set<graph::NodeId> open;                   // show all of their plugs
  std::string filter;                             // plugs with this in their name are shown too
  bool operator==(const DiagramChoice&) const = default;
};

/// A box that is not open has the plugs that are connected, that carry data (a volume, a medium) or that the
/// filter names; hidden ones only where they are connected.
Diagram diagram_of(const graph::Graph& graph, const DiagramChoice& choice);

/// The nodes with everything upstream and downstream of them, connections and hierarchy alike.
std::set<graph::NodeId> connected_with(const graph::Graph& graph, const std::set<graph::NodeId>& nodes);

constexpr float box_width = 184.0f, header_height = 24.0f, row_height = 19.0f;  // [points]
vec2 size_of(const NodeBox& box);
/// The middle of a row's plug: on the left where it takes, on the right where it gives.
vec2 plug_place(const NodeBox& box, std::size_t row, bool gives);
/// The smallest rectangle around them all, as begin and end; none for no boxes.
std::optional<std::pair<vec2, vec2>> bounds_of(const std::vector<const NodeBox*>& boxes);

}  // namespace plinian::window
