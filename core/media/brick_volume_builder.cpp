// Turns 8^3 blocks of voxels into a BrickVolume: finds the bricks whose 9^3 voxels hold anything, quantises
// them, and builds the index tree over them with the distances that let a march leap over empty space.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <unordered_map>

#include "core/media/brick_volume.h"

namespace plinian {
namespace {

struct CellHash {
  std::size_t operator()(ivec3 c) const {
    std::uint64_t h = static_cast<std::uint32_t>(c.x) * 0x9E3779B97F4A7C15ull;
    h = (h ^ static_cast<std::uint32_t>(c.y)) * 0xC2B2AE3D27D4EB4Full;
    h = (h ^ static_cast<std::uint32_t>(c.z)) * 0x165667B19E3779F9ull;
    return h ^ (h >> 29);
  }
};
template <class Value>
using CellMap = std::unordered_map<ivec3, Value, CellHash>;

std::size_t flat_index(ivec3 cell, ivec3 dims) {
  return (static_cast<std::size_t>(cell.z) * dims.y + cell.y) * dims.x + cell.x;
}

ivec3 shift_right(ivec3 v, int shift) {
  return {v.x >> shift, v.y >> shift, v.z >> shift};
}

/// The range of a cell, relative to density_max, as in BrickEntry::y.
std::uint32_t pack_range(float minimum, float maximum) {
  std::uint32_t bits = glm::packHalf2x16(vec2(maximum, 0.0f));
  if (glm::unpackHalf2x16(bits).x < maximum) ++bits;
  const float rounded = glm::unpackHalf2x16(bits).x;
  const float share = rounded > 0.0f ? std::floor(255.0f * minimum / rounded) : 0.0f;
  return bits << 16 | static_cast<std::uint32_t>(std::clamp(share, 0.0f, 255.0f)) << 8;
}

/// The bits of BrickEntry::y that tell which octants of a brick's cells hold anything.
std::uint32_t occupied_octants(const std::uint16_t* voxels) {
  std::uint32_t octants = 0;
  for (int octant = 0; octant < 8; ++octant) {
    const ivec3 corner = ivec3(octant & 1, (octant >> 1) & 1, octant >> 2) * 4;
    bool holds = false;
    for (int z = 0; z <= 4; ++z)
      for (int y = 0; y <= 4; ++y)
        for (int x = 0; x <= 4; ++x)
          holds =
              holds ||
              voxels[((corner.z + z) * BrickVolume::brick_stride + corner.y + y) * BrickVolume::brick_stride +
                     corner.x + x] != 0;
    octants |= std::uint32_t(holds) << octant;
  }
  return octants;
}

/// Fills the empty entries of a box of cells with their Chebyshev distance to the nearest occupied one (or to
/// the outside of the box where `beyond_is_occupied`), capped at 255: two chamfer sweeps over the 26
/// neighbours.
void fill_distances(BrickEntry* entries, ivec3 dims, bool beyond_is_occupied) {
  constexpr std::uint32_t far = 255;
  const auto sweep = [&](int step) {
    const int begin_z = step > 0 ? 0 : dims.z - 1, begin_y = step > 0 ? 0 : dims.y - 1,
              begin_x = step > 0 ? 0 : dims.x - 1;
    for (int z = begin_z; z >= 0 && z < dims.z; z += step)
      for (int y = begin_y; y >= 0 && y < dims.y; y += step)
        for (int x = begin_x; x >= 0 && x < dims.x; x += step) {
          BrickEntry& entry = entries[flat_index({x, y, z}, dims)];
          if (entry.x & BrickVolume::occupied_bit) continue;
          std::uint32_t nearest = entry.x == 0 ? far : entry.x;
          // The 13 neighbours that this sweep has passed already.
          for (int dz = -1; dz <= 0; ++dz)
            for (int dy = -1; dy <= (dz < 0 ? 1 : 0); ++dy)
              for (int dx = -1; dx <= (dz < 0 || dy < 0 ? 1 : -1); ++dx) {
                const ivec3 n = ivec3(x, y, z) + ivec3(dx, dy, dz) * step;
                std::uint32_t d = far;
                if (n.x < 0 || n.y < 0 || n.z < 0 || n.x >= dims.x || n.y >= dims.y || n.z >= dims.z)
                  d = beyond_is_occupied ? 0 : far;
                else if (const std::uint32_t other = entries[flat_index(n, dims)].x;
                         other & BrickVolume::occupied_bit)
                  d = 0;
                else if (other != 0)
                  d = other;
                nearest = std::min(nearest, d + 1);
              }
          entry.x = std::min(nearest, far);
        }
  };
  sweep(1);
  sweep(-1);
}

}  // namespace

struct BrickVolumeBuilder::State {
  struct Block {
    std::vector<float> density, temperature;
  };
  std::mutex mutex;
  CellMap<Block> blocks;
  VoxelRepairs repairs;
};

BrickVolumeBuilder::BrickVolumeBuilder() : state_(new State) {}
BrickVolumeBuilder::~BrickVolumeBuilder() {
  delete state_;
}
const VoxelRepairs& BrickVolumeBuilder::repairs() const {
  return state_->repairs;
}

void BrickVolumeBuilder::add(ivec3 block, const float* density, const float* temperature) {
  const auto any = std::any_of(density, density + block_voxels, [](float v) { return v != 0.0f; });
  if (!any) return;
  State::Block copy;
  copy.density.assign(density, density + block_voxels);
  if (temperature) copy.temperature.assign(temperature, temperature + block_voxels);
  const std::lock_guard lock(state_->mutex);
  if (!state_->blocks.emplace(block, std::move(copy)).second)
    throw std::invalid_argument("a block of voxels was added twice");
}

BrickVolume BrickVolumeBuilder::build(const dmat4& medium_from_index) {
  CellMap<State::Block> blocks = std::move(state_->blocks);
  state_->blocks = {};
  VoxelRepairs& repairs = state_->repairs = {};
  BrickVolume volume;
  volume.medium_from_index = medium_from_index;

  // Mend the values and find their range.
  float largest = 0.0f, hottest = 0.0f;
  for (const auto& [key, block] : blocks) {
    for (const float v : block.density)
      if (std::isfinite(v)) largest = std::max(largest, v);
    for (const float t : block.temperature)
      if (std::isfinite(t)) hottest = std::max(hottest, t);
  }
  ivec3 low(std::numeric_limits<int>::max()), high(std::numeric_limits<int>::min());
  for (auto it = blocks.begin(); it != blocks.end();) {
    auto& [key, block] = *it;
    std::int64_t active = 0;
    for (int i = 0; i < block_voxels; ++i) {
      float& v = block.density[i];
      if (std::isnan(v)) {
        ++repairs.not_a_number;
        v = 0.0f;
      } else if (std::isinf(v)) {
        ++repairs.infinite;
        v = v > 0.0f ? largest : 0.0f;
      } else if (v < 0.0f) {
        ++repairs.negative;
        v = 0.0f;
      }
      if (v < std::numeric_limits<float>::min()) continue;
      ++active;
      const ivec3 voxel = key * 8 + ivec3(i & 7, (i >> 3) & 7, i >> 6);
      low = glm::min(low, voxel);
      high = glm::max(high, voxel);
    }
    for (float& t : block.temperature) t = std::isfinite(t) ? std::max(t, 0.0f) : 0.0f;
    volume.active_voxels += active;
    it = active ? std::next(it) : blocks.erase(it);
  }
  volume.leaf_count = static_cast<std::int64_t>(blocks.size());
  if (blocks.empty()) return volume;
  volume.density_max = largest;
  volume.bounds_min = low - 1;
  volume.bounds_max = high + 1;

  // A brick is needed where any of its 9^3 voxels is non-zero: a block's own brick, and the lower neighbours
  // that see its first layer as their apron.
  std::vector<ivec3> bricks;
  {
    CellMap<char> seen;
    seen.reserve(blocks.size() * 2);
    for (const auto& [key, block] : blocks)
      for (int corner = 0; corner < 8; ++corner) {
        const ivec3 lower(corner & 1, (corner >> 1) & 1, corner >> 2);
        bool needed = false;
        for (int z = 0; z < (lower.z ? 1 : 8) && !needed; ++z)
          for (int y = 0; y < (lower.y ? 1 : 8) && !needed; ++y)
            for (int x = 0; x < (lower.x ? 1 : 8) && !needed; ++x)
              needed = block.density[(z * 8 + y) * 8 + x] > 0.0f;
        if (needed && seen.emplace(key - lower, 1).second) bricks.push_back(key - lower);
      }
    // Along z, y, x: neighbours in space stay neighbours in memory, and the result does not depend on
    // hashing.
    std::sort(bricks.begin(), bricks.end(),
              [](ivec3 a, ivec3 b) { return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x); });
  }

  // Bricks with any temperature come first, so that only they store one.
  std::size_t hot_bricks = 0;
  if (hottest > 0.0f) {
    const auto is_hot = [&blocks](ivec3 brick) {
      for (int corner = 0; corner < 8; ++corner) {
        const ivec3 upper(corner & 1, (corner >> 1) & 1, corner >> 2);
        const auto found = blocks.find(brick + upper);
        if (found == blocks.end() || found->second.temperature.empty()) continue;
        for (int z = 0; z < (upper.z ? 1 : 8); ++z)
          for (int y = 0; y < (upper.y ? 1 : 8); ++y)
            for (int x = 0; x < (upper.x ? 1 : 8); ++x)
              if (found->second.temperature[(z * 8 + y) * 8 + x] > 0.0f) return true;
      }
      return false;
    };
    hot_bricks = static_cast<std::size_t>(std::stable_partition(bricks.begin(), bricks.end(), is_hot) -
                                          bricks.begin());
  }

  volume.density.resize(bricks.size() * BrickVolume::brick_voxels);
  volume.temperature.resize(hot_bricks * BrickVolume::brick_voxels);
  volume.temperature_max = hottest;
  std::vector<std::uint32_t> ranges(bricks.size());
  tbb::parallel_for(std::size_t(0), bricks.size(), [&](std::size_t b) {
    const State::Block* neighbours[8];
    for (int corner = 0; corner < 8; ++corner) {
      const auto found = blocks.find(bricks[b] + ivec3(corner & 1, (corner >> 1) & 1, corner >> 2));
      neighbours[corner] = found == blocks.end() ? nullptr : &found->second;
    }
    float values[BrickVolume::brick_voxels], heat[BrickVolume::brick_voxels];
    float minimum = std::numeric_limits<float>::max(), maximum = 0.0f;
    for (int z = 0, i = 0; z < 9; ++z)
      for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x, ++i) {
          const State::Block* block = neighbours[(x >> 3) | ((y >> 3) << 1) | ((z >> 3) << 2)];
          const int inside = ((z & 7) * 8 + (y & 7)) * 8 + (x & 7);
          values[i] = block ? block->density[inside] : 0.0f;
          heat[i] = block && !block->temperature.empty() ? block->temperature[inside] : 0.0f;
          minimum = std::min(minimum, values[i]);
          maximum = std::max(maximum, values[i]);
        }
    ranges[b] = pack_range(minimum / largest, maximum / largest);
    const float scale = glm::unpackHalf2x16(ranges[b]).y * largest;
    std::uint16_t* stored = volume.density.data() + b * BrickVolume::brick_voxels;
    for (int i = 0; i < BrickVolume::brick_voxels; ++i)
      stored[i] = static_cast<std::uint16_t>(std::min(values[i] / scale, 1.0f) * 65535.0f + 0.5f);
    ranges[b] |= occupied_octants(stored);
    if (b < hot_bricks)
      for (int i = 0; i < BrickVolume::brick_voxels; ++i)
        volume.temperature[b * BrickVolume::brick_voxels + i] =
            static_cast<std::uint16_t>(std::min(heat[i] / volume.temperature_max, 1.0f) * 65535.0f + 0.5f);
  });

  // The root: the finest level at which a dense grid over the bricks stays small.
  ivec3 brick_low = bricks.front(), brick_high = bricks.front();
  for (const ivec3 b : bricks) {
    brick_low = glm::min(brick_low, b);
    brick_high = glm::max(brick_high, b);
  }
  const auto cells_at = [&](int level) {
    const ivec3 dims = shift_right(brick_high, 3 * level) - shift_right(brick_low, 3 * level) + 1;
    // Long thin roots would not fit a texture.
    if (std::max({dims.x, dims.y, dims.z}) > BrickVolume::max_root_side) return HUGE_VAL;
    return double(dims.x) * dims.y * dims.z;
  };
  while (cells_at(volume.levels) > double(BrickVolume::max_root_cells)) ++volume.levels;
  const ivec3 root_low = shift_right(brick_low, 3 * volume.levels);
  volume.root_dims = shift_right(brick_high, 3 * volume.levels) - root_low + 1;
  volume.origin = root_low * volume.root_cell_size();
  volume.root.assign(flat_index({0, 0, volume.root_dims.z}, volume.root_dims), BrickEntry(0u));

  const auto widen = [](BrickEntry& entry, std::uint32_t range) {
    const auto minimum = [](std::uint32_t r) {
      return glm::unpackHalf2x16(r).y * float(r >> 8 & 255u) / 255.0f;
    };
    const auto maximum = [](std::uint32_t r) { return glm::unpackHalf2x16(r).y; };
    entry.y =
        pack_range(std::min(minimum(entry.y), minimum(range)), std::max(maximum(entry.y), maximum(range)));
  };
  for (std::size_t b = 0; b < bricks.size(); ++b) {
    std::size_t slot = flat_index(shift_right(bricks[b], 3 * volume.levels) - root_low, volume.root_dims);
    bool in_root = true;
    for (int level = volume.levels; level > 0; --level) {
      BrickEntry entry = in_root ? volume.root[slot] : volume.nodes[slot];
      if (entry.x == 0) {
        entry = {BrickVolume::occupied_bit | static_cast<std::uint32_t>(volume.nodes.size() / 512),
                 ranges[b]};
        volume.nodes.resize(volume.nodes.size() + 512, BrickEntry(0u));
      }
      widen(entry, ranges[b]);
      (in_root ? volume.root[slot] : volume.nodes[slot]) = entry;
      const ivec3 child = shift_right(bricks[b], 3 * (level - 1)) & 7;
      slot = (entry.x & ~BrickVolume::occupied_bit) * std::size_t(512) + flat_index(child, ivec3(8));
      in_root = false;
    }
    (in_root ? volume.root[slot] : volume.nodes[slot]) = {
        BrickVolume::occupied_bit | static_cast<std::uint32_t>(b), ranges[b]};
  }
  fill_distances(volume.root.data(), volume.root_dims, false);
  for (std::size_t node = 0; node < volume.nodes.size(); node += 512)
    fill_distances(volume.nodes.data() + node, ivec3(8), true);
  return volume;
}

}  // namespace plinian
