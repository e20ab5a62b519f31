// Runs a shape's contribute function.
#pragma once

#include "host/sdk/compute_table.h"

namespace plinian::sdk {

using ContributeFunction = void (*)(void* user, const PlinianCompute*, PlinianContext*,
                                    const PlinianContribute*, PlinianContribution*);

/// The value of the output `contribution`. Throws GraphError where the function fails.
graph::Value contribution_by(ContributeFunction contribute, void* user, ComputeState& state);

}  // namespace plinian::sdk
