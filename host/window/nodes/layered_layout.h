// Where boxes stand: from left to right in the order in which they depend on one another, in layers, as in
// Sugiyama, Tagawa and Toda, "Methods for visual understanding of hierarchical system structures", 1981. Long
// wires are not routed around boxes.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/shared/glue.h"

namespace plinian::window {

struct LaidOut {
  vec2 size{0.0f};            // [points]
  std::optional<vec2> place;  // [points] its upper left corner; none: still to be found
};

/// From and to, as places in the list of boxes, those into one box from its upper plug to its lowest. Nodes
/// may go round in a circle where their attributes do not; such wires may run back.
using LayoutEdges = std::vector<std::pair<std::size_t, std::size_t>>;

/// Finds places for those that have none. Boxes that have one stay where they are, so that an edit moves
/// nothing that was there; a new one goes beside its neighbours, where there is room. Where none has a place,
/// all are laid out: each layer right of what it depends on, wires as straight as may be, groups that nothing
/// connects beneath one another. Equal lists give equal places.
void lay_out(std::vector<LaidOut>& boxes, const LayoutEdges& edges);

}  // namespace plinian::window
