// What decides where in the sky a light stands, read from the graph.
#pragma once

#include <functional>

#include "core/scene/placement.h"
#include "host/graph/model/graph.h"

namespace plinian::window {

struct LightStand {
  Placement placement;  // of the light under its parent
  dmat4 world_from_parent{1.0};
};

/// value: of a number of the graph, as whoever asks knows it where it is driven.
LightStand light_stand(const graph::Graph& graph, const graph::Node& light,
                       const std::function<double(const graph::Plug&)>& value);

}  // namespace plinian::window
