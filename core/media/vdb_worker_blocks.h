// Turns grids into the blocks of voxels that travel to the parent: one grid voxel by voxel, several summed,
// grids of another transform resampled, temperature beside density.
#pragma once

#include <openvdb/openvdb.h>

#include <functional>
#include <vector>

#include "core/media/vdb_worker_file.h"

namespace plinian::vdb {

/// What mending a grid's values took, in voxels.
struct Mended {
  std::int64_t not_a_number = 0, infinite = 0, negative = 0;
  Mended& operator+=(const Mended& other) {
    not_a_number += other.not_a_number;
    infinite += other.infinite;
    negative += other.negative;
    return *this;
  }
};

/// More voxels than the limit on memory allows.
struct TooManyVoxels : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Makes every value finite and not negative, inactive ones `outside`: NaN becomes 0, infinity the largest
/// finite value. Returns what it took, counted over active voxels.
Mended mend(openvdb::FloatGrid& grid, float outside);

struct BlockJob {
  std::vector<openvdb::FloatGrid::Ptr> density;      // summed; more than one: mended beforehand
  std::vector<openvdb::FloatGrid::Ptr> temperature;  // their maximum; mended beforehand
  float temperature_gain = 1.0f;                     // [K / unit of the grid]
  openvdb::math::Transform::Ptr target;              // linear; the lattice of the result
  std::uint64_t most_bytes = 0;                      // [bytes] of voxels that may leave
};

struct BlockResult {
  openvdb::Vec3i rebased{0};   // [voxels] index-space position of the target that block (0, 0, 0) starts at
  Mended skipped;              // active tiles that are no density: nothing is sent of them
  std::int64_t resampled = 0;  // grids that were resampled onto the target
};

/// Calls sink(block, density, temperature or null) for every block that holds any density, in the order of
/// BlockReader. share: told how far it is. Throws TooManyVoxels before anything is sent, BadFile.
BlockResult for_each_block(const BlockJob& job,
                           const std::function<void(openvdb::Coord, const float*, const float*)>& sink,
                           const std::function<void(double)>& share);

/// The lattice of equal voxels for grids that cannot keep theirs: the finest of the linear transforms; where
/// there is none, cubes along the axes as large as the first frustum's voxels in the middle of its data.
openvdb::math::Transform::Ptr common_lattice(const std::vector<openvdb::FloatGrid::Ptr>& grids);

/// Whether two transforms place every voxel alike, to rounding.
bool same_lattice(const openvdb::math::Transform& a, const openvdb::math::Transform& b);

}  // namespace plinian::vdb
