// Commands that plug-ins declare, as the graph's own declarations.
#pragma once

#include "host/graph/commands/command.h"
#include "host/sdk/abi.h"

namespace plinian::sdk {

/// Throws GraphError where the declaration makes no sense.
graph::CommandSpec command_from(const PlinianCommand* plain);

}  // namespace plinian::sdk
