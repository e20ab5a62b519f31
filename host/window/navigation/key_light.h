// The key light, turned around the medium by dragging in the picture.
#pragma once

#include <optional>

#include "host/window/navigation/light_stand.h"

namespace plinian::window {

/// The light that a drag turns: a selected directional or spot light, else the one called `key`, else the
/// first there is; 0 where there is none.
graph::NodeId light_to_turn(const graph::Graph& graph);

/// The rotation [degrees about x, y, z] of a light that stood so and is dragged that far: it comes from
/// further right when dragged right, and from higher when dragged up. points: of the mouse, x right, y down.
/// None under a parent that is squeezed to nothing.
std::optional<dvec3> turned_light(const LightStand& stand, dvec2 points);

}  // namespace plinian::window
