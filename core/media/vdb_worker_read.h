// The worker's errand of reading: the grids that a request means, as blocks, and what is to be said about
// them.
#pragma once

#include "core/media/vdb_worker_pipe.h"

namespace plinian::vdb {

/// Sends the blocks and then the result. Throws BadFile.
void read_file(const nlohmann::json& request, const Outlet& outlet);

/// Sends facts about every grid of a file. Throws BadFile.
void list_file(const nlohmann::json& request, const Outlet& outlet);

}  // namespace plinian::vdb
