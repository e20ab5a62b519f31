// Attributes of the scene's nodes, for the palette: those that a query names, looked for when it is typed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/graph/model/graph.h"
#include "host/window/palette/entries.h"

namespace plinian::window {

/// The attributes that the query names, best first, at most so many, with what they are set to: a word of the
/// query must be in an attribute's name or its label, the others there or in the node's. "medium.dens" says
/// which is which, and "medium." names all that the node has. Of nodes that have the same one the selected
/// ones stand first. None for a single letter.
std::vector<PaletteEntry> attribute_entries(const graph::Graph& graph, const std::string& query,
                                            std::size_t most);

/// The attribute of that name, "medium.density_scale"; none where there is none.
std::optional<PaletteEntry> attribute_entry(const graph::Graph& graph, const std::string& name);

}  // namespace plinian::window
