// Visits every brick of a BrickVolume with its place, which lookups by position do not tell.
#pragma once

#include "core/media/brick_volume.h"

namespace plinian {

namespace detail {

template <class F>
void walk_cells(const BrickVolume& volume, const BrickEntry* entries, ivec3 dims, ivec3 corner, int level,
                F& visit) {
  const int size = BrickVolume::brick_size << (3 * level);
  for (int z = 0, i = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++i) {
        const BrickEntry entry = entries[i];
        if ((entry.x & BrickVolume::occupied_bit) == 0) continue;
        const std::size_t number = entry.x & ~BrickVolume::occupied_bit;
        const ivec3 at = corner + ivec3(x, y, z) * size;
        if (level == 0)
          visit(at, number, entry);
        else
          walk_cells(volume, volume.nodes.data() + number * 512, ivec3(BrickVolume::node_size), at, level - 1,
                     visit);
      }
}

}  // namespace detail

/// Calls visit(ivec3 corner [voxels], std::size_t brick, BrickEntry) for every brick, in the order of the
/// tree.
template <class F>
void for_each_brick(const BrickVolume& volume, F&& visit) {
  if (!volume.root.empty())
    detail::walk_cells(volume, volume.root.data(), volume.root_dims, volume.origin, volume.levels, visit);
}

/// What a brick's stored 65535 stands for [unit of the file].
inline float brick_maximum(const BrickVolume& volume, BrickEntry entry) {
  return glm::unpackHalf2x16(entry.y).y * volume.density_max;
}

}  // namespace plinian
