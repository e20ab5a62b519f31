// Data types that plug-ins declare, as the graph's own declarations.
#pragma once

#include <memory>

#include "host/graph/types/data_type.h"
#include "host/sdk/abi.h"
#include "host/sdk/data_count.h"

namespace plinian::sdk {

/// A plug-in's data as the graph's; they count until they are released.
graph::DataPtr data_from(const PlinianData* plain, const std::shared_ptr<DataCount>& count);

/// Throws GraphError where the declaration makes no sense. count: counts what is deserialised.
graph::DataType data_type_from(const PlinianDataType* plain, const std::shared_ptr<DataCount>& count);

}  // namespace plinian::sdk
