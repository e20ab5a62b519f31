// The worker's errand of writing a file from blocks that the parent sends.
#pragma once

#include "core/media/vdb_worker_pipe.h"

namespace plinian::vdb {

/// Writes the grids that arrive through `inlet` to the file that the request names. Throws BadFile.
void write_file(const nlohmann::json& request, Inlet& inlet, const Outlet& outlet);

}  // namespace plinian::vdb
