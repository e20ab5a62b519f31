// Outputs that the host adds to node types of plug-ins, so that the evaluator keeps them as it keeps any:
// what a shape contributes, and what a draw override draws.
#pragma once

#include <memory>

#include "host/graph/types/node_type.h"
#include "host/sdk/abi.h"
#include "host/sdk/data_count.h"

namespace plinian::sdk {

/// Adds them to a type that declares a contribute function or a draw override, and gives it a compute
/// function that makes them beside the type's own outputs. Throws GraphError for attributes that do not
/// exist.
void add_hidden_outputs(graph::NodeTypeSpec& spec, const PlinianNodeType& from,
                        const std::shared_ptr<DataCount>& data);

}  // namespace plinian::sdk
