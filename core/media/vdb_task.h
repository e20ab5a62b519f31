// One errand for the .vdb worker: limits, request, answer, and every way it can fail as one line about the
// file.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/media/vdb_reader.h"

namespace plinian::vdb {

struct Limits {
  double seconds;              // [s] wall clock
  std::uint64_t memory_bytes;  // that parsing may take
  std::uint64_t voxel_bytes;   // that voxels may take on their way here; half of the above
};

/// The limits for a file of a size, as the options have them or by default (see VdbOptions).
Limits limits_for(std::uint64_t file_bytes, const VdbOptions& options);

struct Task {
  std::string path;        // for messages and for the worker
  nlohmann::json request;  // run_task adds path, protocol and limits
  Limits limits;
  std::function<bool(double)> progress;                       // may be empty
  std::function<void(std::span<const std::byte>)> on_blocks;  // may be empty where none are expected
  std::function<bool(std::vector<std::byte>&)> more_input;    // see WorkerJob
};

/// Returns the worker's result. Throws VdbError, VdbCancelled.
nlohmann::json run_task(const Task& task);

/// Metres per unit and up axis, guessed from the metadata of a file and of its grids.
VdbOrientation guess_orientation(const std::map<std::string, std::string>& file,
                                 const std::vector<VdbGridInfo>& grids);

// Metadata that Plinian's own files carry.
inline constexpr const char* up_axis_key = "plinian/up_axis";      // "y" or "z"
inline constexpr const char* file_unit_key = "plinian/file_unit";  // [m], in decimal

}  // namespace plinian::vdb
