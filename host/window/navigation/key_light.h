// The key light, turned around the medium by dragging in the picture.
#pragma once

#include <string>

#include "host/graph/model/graph.h"

namespace plinian::window {

/// The light that a drag turns: a selected directional or spot light, else the one called `key`, else the
/// first there is; 0 where there is none.
graph::NodeId light_to_turn(const graph::Graph& graph);

/// The rotation [degrees about x, y, z] of a light that shone as `rotation` and is dragged that far: it comes
/// from further right when dragged right, and from higher when dragged up. points: of the mouse, x right, y
/// down.
dvec3 turned_light(const dvec3& rotation, dvec2 points);

/// The command that sets it.
std::string light_command(const std::string& node, const dvec3& rotation);

}  // namespace plinian::window
