// Lookups in a BrickVolume. How one is made stands in brick_volume_builder.cpp.
#include "core/media/brick_volume.h"

namespace plinian {
namespace {

ivec3 floor_divide(ivec3 v, int shift) {
  return {v.x >> shift, v.y >> shift, v.z >> shift};
}

std::size_t flat_index(ivec3 cell, ivec3 dims) {
  return (static_cast<std::size_t>(cell.z) * dims.y + cell.y) * dims.x + cell.x;
}

}  // namespace

std::size_t BrickVolume::bytes() const {
  return root.size() * sizeof(BrickEntry) + nodes.size() * sizeof(BrickEntry) +
         (density.size() + temperature.size()) * sizeof(std::uint16_t);
}

BrickVolume::Lookup BrickVolume::find(ivec3 cell) const {
  int shift = 3 + 3 * levels;
  const ivec3 root_cell = floor_divide(cell - origin, shift);
  const ivec3 corner = origin + root_cell * (1 << shift);
  if (root_cell.x < 0 || root_cell.y < 0 || root_cell.z < 0 || root_cell.x >= root_dims.x ||
      root_cell.y >= root_dims.y || root_cell.z >= root_dims.z)
    return {BrickEntry(0u), 1 << shift, corner};
  Lookup found{root[flat_index(root_cell, root_dims)], 1 << shift, corner};
  for (int level = levels; level > 0 && (found.entry.x & occupied_bit) != 0; --level) {
    shift -= 3;
    const ivec3 child = floor_divide(cell - found.corner, shift);
    const std::size_t node = found.entry.x & ~occupied_bit;
    found.entry = nodes[node * 512 + flat_index(child, ivec3(node_size))];
    found.corner += child * (1 << shift);
    found.size = 1 << shift;
  }
  return found;
}

float BrickVolume::sample(const std::vector<std::uint16_t>& bricks, vec3 p, bool brick_scaled) const {
  const vec3 base = glm::floor(p);
  // Written so that a NaN position falls outside as well.
  if (!(base.x >= bounds_min.x && base.y >= bounds_min.y && base.z >= bounds_min.z && base.x < bounds_max.x &&
        base.y < bounds_max.y && base.z < bounds_max.z))
    return 0.0f;
  const ivec3 cell(base);
  const Lookup found = find(cell);
  if ((found.entry.x & occupied_bit) == 0) return 0.0f;
  const std::size_t first = static_cast<std::size_t>(found.entry.x & ~occupied_bit) * brick_voxels;
  if (first >= bricks.size()) return 0.0f;  // a brick without temperature
  const ivec3 local = cell - found.corner;
  const std::uint16_t* v =
      bricks.data() + first + (local.z * brick_stride + local.y) * brick_stride + local.x;
  const vec3 f = p - base;
  const auto row = [&](int offset) { return v[offset] + f.x * (float(v[offset + 1]) - float(v[offset])); };
  constexpr int dy = brick_stride, dz = brick_stride * brick_stride;
  const float near = row(0) + f.y * (row(dy) - row(0));
  const float far = row(dz) + f.y * (row(dz + dy) - row(dz));
  const float value = near + f.z * (far - near);
  const float scale = brick_scaled ? glm::unpackHalf2x16(found.entry.y).y * density_max : temperature_max;
  return value * (scale / 65535.0f);
}

float BrickVolume::sample_density(vec3 index_position) const {
  return sample(density, index_position, true);
}

float BrickVolume::sample_temperature(vec3 index_position) const {
  return temperature.empty() ? 0.0f : sample(temperature, index_position, false);
}

float BrickVolume::voxel_density(ivec3 voxel) const {
  return sample_density(vec3(voxel));
}

}  // namespace plinian
