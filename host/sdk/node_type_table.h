// Node types that plug-ins declare, as the graph's own declarations.
#pragma once

#include <memory>

#include "host/graph/types/node_type.h"
#include "host/sdk/abi.h"
#include "host/sdk/data_count.h"

namespace plinian::sdk {

/// Throws GraphError where the declaration makes no sense. data: counts what its computations hand on.
graph::NodeTypeSpec node_type_from(const PlinianNodeType* plain, const std::shared_ptr<DataCount>& data);

}  // namespace plinian::sdk
