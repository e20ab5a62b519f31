// Colours by which nodes and what runs between them are told apart. [sRGB 0xAABBGGRR, as Dear ImGui packs
// them]
#pragma once

#include <string>

#include "host/graph/values/value.h"

namespace plinian::window {

/// What kind of thing a node is.
unsigned node_colour(const std::string& type);

/// What a plug carries.
unsigned plug_colour(graph::AttributeType type);

}  // namespace plinian::window
