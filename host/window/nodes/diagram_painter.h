// Draws boxes and wires as they stand.
#pragma once

#include <functional>
#include <set>

#include "host/window/nodes/canvas_view.h"
#include "host/window/nodes/diagram_hit.h"

struct ImDrawList;

namespace plinian::window {

struct DiagramLook {
  vec2 corner{0.0f};  // [points] of the pane in the window
  vec2 size{0.0f};    // [points] of the pane
  CanvasView view;
  std::set<graph::NodeId> selected;
  DiagramHit hot;  // what the mouse is over
  std::function<bool(const PlugRow&, bool)>
      fits;                                   // whether the wire in the hand could end at a plug; empty: none
  std::function<int(graph::NodeId)> failure;  // 0: none, 1: by another's, 2: its own
};

/// A wire from the plug that gives to the one that takes, both in points of the window.
void draw_wire(ImDrawList& list, vec2 from, vec2 to, unsigned colour, float thickness);

void draw_diagram(ImDrawList& list, const graph::Graph& graph, const Diagram& diagram,
                  const DiagramLook& look);

}  // namespace plinian::window
