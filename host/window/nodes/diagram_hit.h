// What of a diagram is under a point.
#pragma once

#include <cstddef>
#include <vector>

#include "host/window/nodes/diagram.h"

namespace plinian::window {

enum class DiagramPart { nothing, box, opener, taking_plug, giving_plug };

struct DiagramHit {
  DiagramPart part = DiagramPart::nothing;
  std::size_t box = 0, row = 0;  // row: of a plug
  bool operator==(const DiagramHit&) const = default;
};

/// point, reach: [points of the canvas]; a plug is hit within `reach` of its middle. What is drawn later lies
/// above; plugs lie above boxes.
DiagramHit hit(const Diagram& diagram, vec2 point, float reach);

/// Boxes that a rectangle touches, whichever way it was drawn.
std::vector<std::size_t> boxes_within(const Diagram& diagram, vec2 corner, vec2 opposite);

}  // namespace plinian::window
