// Draw overrides on the host's side; host/draw runs them.
#pragma once

#include <memory>
#include <string>

#include "host/graph/types/node_type.h"
#include "host/sdk/abi.h"

namespace plinian::sdk {

inline constexpr const char* draw_data_type = "plinian.draw";
inline constexpr const char* draw_data_output = "drawData";

/// The functions of one, as the plug-in declared them.
struct DrawOverride {
  std::string node_type;
  PlinianDraw table{};  // its text is not kept
  std::string owner;    // "the plug-in 'wobble'"
};
using DrawOverridePtr = std::shared_ptr<const DrawOverride>;

/// The hidden output that holds the draw data of a type's nodes, or no_attribute where it has no override.
graph::AttributeIndex draw_data_of(const graph::NodeType& type);

}  // namespace plinian::sdk
