// What the nodes of a medium are called.
#pragma once

#include <string>

#include "host/graph/model/graph.h"

namespace plinian::scene {

/// A node name made of any name: what cannot stand in one becomes _.
std::string node_name_of(const std::string& name);

/// What a medium is called that comes of a file: "smoke" for "shots/smoke.####.vdb". A name, not yet free.
std::string medium_name_of(const std::string& path);

/// The name, else with the lowest number behind it by which neither a medium nor any node that belongs to it
/// is called yet. name_space: that they stand in; empty: in none.
std::string free_medium_name(const graph::Graph& graph, const std::string& wanted,
                             const std::string& name_space = "");

}  // namespace plinian::scene
