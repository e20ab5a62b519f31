// No exception leaves a function that a plug-in calls.
#include "host/sdk/volume_table.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "host/graph/graph_error.h"
#include "host/sdk/inside_plugin.h"
#include "host/sdk/plain_text.h"

namespace plinian::sdk {

using graph::DataPtr;
using graph::GraphError;

namespace {

constexpr int block_side = 8;
// Where voxels are at, so that coordinates of blocks and of cells never overflow.
constexpr std::int64_t furthest = 1 << 28;

const PlinianVolume* handle_of(const DataPtr& data) {
  return reinterpret_cast<const PlinianVolume*>(data->object.get());
}

const BrickVolume& volume_of(const DataPtr& data) {
  return *static_cast<const BrickVolume*>(data->object.get());
}

void check_box(const std::int32_t* first, const std::int32_t* count) {
  for (int i = 0; i < 3; ++i) {
    if (count[i] < 0)
      throw GraphError("a box of voxels has " + std::to_string(count[i]) +
                       " along a side: give it 0 or more");
    if (std::abs(std::int64_t(first[i])) > furthest || std::int64_t(first[i]) + count[i] > furthest)
      throw GraphError("a box of voxels reaches further from 0 than " + std::to_string(furthest) +
                       " voxels: a size of 0, or a number that is not finite, may be behind it");
  }
}

ivec3 block_of(ivec3 voxel) {
  return {voxel.x >> 3, voxel.y >> 3, voxel.z >> 3};
}

// One block of a volume that is being made; what sticks out of the box is cut.
struct Block {
  std::array<float, BrickVolumeBuilder::block_voxels> density{}, temperature{};

  // Voxels that hold what no medium can: nothing is put in their place. Returns how many.
  int mend() {
    int count = 0;
    for (std::size_t i = 0; i < density.size(); ++i) {
      const auto is_good = [](float value) {
        return value >= 0.0f && value <= std::numeric_limits<float>::max();
      };
      if (is_good(density[i]) && is_good(temperature[i])) continue;
      density[i] = temperature[i] = 0.0f;
      ++count;
    }
    return count;
  }

  void cut(ivec3 corner, ivec3 low, ivec3 high) {
    for (int z = 0; z < block_side; ++z)
      for (int y = 0; y < block_side; ++y)
        for (int x = 0; x < block_side; ++x) {
          const ivec3 voxel = corner + ivec3(x, y, z);
          if (all(greaterThanEqual(voxel, low)) && all(lessThan(voxel, high))) continue;
          const auto at = std::size_t((z * block_side + y) * block_side + x);
          density[at] = temperature[at] = 0.0f;
        }
  }
};

BrickVolume made(ComputeState& state, const PlinianVolumeSource& source) {
  check_box(source.first, source.count);
  if (!source.fill) throw GraphError("a volume without a function that fills it");
  dmat4 object_from_index;
  for (int i = 0; i < 16; ++i) object_from_index[i / 4][i % 4] = source.object_from_index[i];
  const double size = determinant(dmat3(object_from_index));
  if (!std::isfinite(size) || size == 0.0)
    throw GraphError("a volume's object_from_index is no transform that could be taken back");
  const ivec3 low(source.first[0], source.first[1], source.first[2]),
      high = low + ivec3(source.count[0], source.count[1], source.count[2]);
  const ivec3 first = block_of(low), last = block_of(high - 1), blocks = last - first + 1;
  BrickVolumeBuilder builder;
  const bool hot = source.flags & PLINIAN_VOLUME_TEMPERATURE;
  const std::int64_t slices = std::int64_t(blocks.y) * blocks.z;
  std::atomic<bool> stopped{false};
  std::atomic<std::int64_t> mended{0};
  // A row of blocks along x.
  const InsidePlugin* here = InsidePlugin::current();
  const auto fill_row = [&](std::int64_t row) {
    const InsidePlugin inside(here);
    for (int x = 0; x < blocks.x; ++x) {
      if (stopped || state.context.cancelled()) return;
      const ivec3 block = first + ivec3(x, int(row % blocks.y), int(row / blocks.y)),
                  corner = block * block_side;
      const std::int32_t at[3] = {corner.x, corner.y, corner.z};
      Block voxels;
      const int filled =
          source.fill(source.user, at, voxels.density.data(), hot ? voxels.temperature.data() : nullptr);
      if (filled < 0) stopped = true;
      if (filled <= 0) continue;
      voxels.cut(corner, low, high);
      if (const int count = voxels.mend(); count > 0) mended += count;
      builder.add(block, voxels.density.data(), hot ? voxels.temperature.data() : nullptr);
    }
  };
  if (all(greaterThan(high, low))) {
    if (source.flags & PLINIAN_VOLUME_CONCURRENT)
      tbb::parallel_for(std::int64_t(0), slices, fill_row);
    else
      for (std::int64_t row = 0; row < slices; ++row) fill_row(row);
  }
  if (stopped) throw GraphError("the volume could not be filled");
  if (mended > 0)
    state.context.warn(std::to_string(mended) + (mended == 1 ? " voxel" : " voxels") + " of a volume that " +
                       state.data->owner + " made " + (mended == 1 ? "is" : "are") +
                       " negative or not finite, and " + (mended == 1 ? "counts" : "count") + " as 0");
  return builder.build(object_from_index);
}

}  // namespace

DataPtr volume_value(std::shared_ptr<const BrickVolume> volume, std::uint64_t content) {
  const std::size_t bytes = volume->bytes();
  return std::make_shared<const graph::Data>(
      graph::Data{PLINIAN_VOLUME_TYPE, std::move(volume), bytes, content});
}

std::shared_ptr<const BrickVolume> volume_in(const graph::Value& value) {
  const auto* data = std::get_if<DataPtr>(&value);
  if (!data || !*data || (*data)->type != PLINIAN_VOLUME_TYPE) return nullptr;
  return std::static_pointer_cast<const BrickVolume>((*data)->object);
}

void write_volume(PlinianContext* context, std::int32_t attribute, std::shared_ptr<const BrickVolume> volume,
                  std::uint64_t content) {
  state_of(context).context.set_output(attribute, volume_value(std::move(volume), content));
}

DataPtr volume_data(ComputeState& state, const PlinianVolume* volume) {
  for (const DataPtr& data : state.volumes)
    if (handle_of(data) == volume) return data;
  throw GraphError("a volume that was neither read nor made here");
}

namespace volumes {

int read(PlinianContext* c, std::int32_t attribute, std::int32_t element, const double* time,
         const PlinianVolume** volume) {
  return guarded(c, [&](ComputeState& s) {
    *volume = nullptr;
    const graph::Value& input = input_of(s, attribute, element, time);
    if (std::holds_alternative<std::monostate>(input)) return;
    const DataPtr& data = std::get<DataPtr>(input);
    if (!data) return;
    if (data->type != PLINIAN_VOLUME_TYPE)
      throw GraphError("data of the type " + data->type + " are no volume");
    s.volumes.push_back(data);
    *volume = handle_of(data);
  });
}

int make(PlinianContext* c, const PlinianVolumeSource* plain, const PlinianVolume** volume) {
  return guarded(c, [&](ComputeState& s) {
    const PlinianVolumeSource source = whole(plain);
    s.volumes.push_back(volume_value(std::make_shared<const BrickVolume>(made(s, source)), source.content));
    *volume = handle_of(s.volumes.back());
  });
}

int write(PlinianContext* c, std::int32_t attribute, const PlinianVolume* volume) {
  return guarded(c, [&](ComputeState& s) {
    s.context.set_output(attribute, volume ? graph::Value(volume_data(s, volume)) : graph::Value(DataPtr()));
  });
}

int info(PlinianContext* c, const PlinianVolume* volume, PlinianVolumeInfo* plain) {
  return guarded(c, [&](ComputeState& s) {
    const BrickVolume& v = volume_of(volume_data(s, volume));
    PlinianVolumeInfo info{};
    info.size = plain->size;
    for (int i = 0; i < 3 && !v.empty(); ++i) {
      info.first[i] = v.bounds_min[i] + 1;
      info.count[i] = v.bounds_max[i] - v.bounds_min[i] - 1;
    }
    for (int i = 0; i < 16; ++i) info.object_from_index[i] = v.medium_from_index[i / 4][i % 4];
    info.density_max = v.density_max;
    info.temperature_max = v.temperature_max;
    info.voxels = v.active_voxels;
    std::memcpy(plain, &info, std::min(sizeof(info), plain->size));
  });
}

int read_voxels(PlinianContext* c, const PlinianVolume* volume, const std::int32_t* first,
                const std::int32_t* count, float* density, float* temperature) {
  return guarded(c, [&](ComputeState& s) {
    const BrickVolume& v = volume_of(volume_data(s, volume));
    check_box(first, count);
    for (std::int32_t z = 0; z < count[2]; ++z)
      for (std::int32_t y = 0; y < count[1]; ++y)
        for (std::int32_t x = 0; x < count[0]; ++x) {
          const ivec3 voxel(first[0] + x, first[1] + y, first[2] + z);
          *density++ = v.voxel_density(voxel);
          if (temperature) *temperature++ = v.sample_temperature(vec3(voxel));
        }
  });
}

}  // namespace volumes
}  // namespace plinian::sdk
