// Volumes across the boundary: the data type "plinian.volume" holds a core BrickVolume.
#pragma once

#include "core/media/brick_volume.h"
#include "host/sdk/compute_table.h"

namespace plinian::sdk {

/// A volume as attributes hand it on. content: equal for equal content; 0: not known.
graph::DataPtr volume_value(std::shared_ptr<const BrickVolume> volume, std::uint64_t content = 0);
/// What such a value holds, or null.
std::shared_ptr<const BrickVolume> volume_in(const graph::Value& value);

/// For node types of the program itself, which make their volumes by other means than a callback. Throws
/// GraphError where the attribute is no output for volumes.
void write_volume(PlinianContext* context, std::int32_t attribute, std::shared_ptr<const BrickVolume> volume,
                  std::uint64_t content = 0);

/// The data behind a handle that this run of a compute function was given. Throws GraphError for any other.
graph::DataPtr volume_data(ComputeState& state, const PlinianVolume* volume);

namespace volumes {

// Entries of the compute table.
int read(PlinianContext*, std::int32_t attribute, std::int32_t element, const double* time,
         const PlinianVolume**);
int make(PlinianContext*, const PlinianVolumeSource*, const PlinianVolume**);
int write(PlinianContext*, std::int32_t attribute, const PlinianVolume*);
int info(PlinianContext*, const PlinianVolume*, PlinianVolumeInfo*);
int read_voxels(PlinianContext*, const PlinianVolume*, const std::int32_t* first, const std::int32_t* count,
                float* density, float* temperature);

}  // namespace volumes
}  // namespace plinian::sdk
