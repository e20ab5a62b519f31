// The sparse volume that the CPU and the GPU march: 8^3-cell bricks with a one-sided apron, quantised to 16
// bits, under a shallow tree that knows the range of each brick and how far the next one is.
//
// Index space is the file's: voxel centres at whole coordinates, trilinear in between, zero outside. A brick
// at coordinate b covers the cells [8b, 8b+8) and so stores the 9^3 voxels 8b .. 8b+8 (inclusive): every
// trilinear lookup reads one brick only. The quantisation (1/65535 of each brick's maximum) is far below
// half-float noise.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/shared/glue.h"

namespace plinian {

/// One cell of the index tree, as the shaders read it.
/// x: bit 31 set: occupied, the low bits are a brick number (on the last level) or a node number.
///    bit 31 clear: empty; the value d >= 1 says that every cell of the same level and node (or root) at a
///    Chebyshev distance below d is empty too.
/// y: bits 16-31: the maximum of the values below relative to density_max, a half, rounded up; a brick's
/// voxels
///    are stored as fractions of it. Bits 8-15: the minimum in 255ths of that maximum, rounded down. Bits
///    0-7, of a brick: which of its octants of 4^3 cells hold anything, x + 2 y + 4 z being the number of a
///    bit.
using BrickEntry = uvec2;

class BrickVolume {
 public:
  static constexpr int brick_size = 8;      // cells along a side of a brick
  static constexpr int brick_stride = 9;    // voxels along a side of a brick, apron included
  static constexpr int brick_voxels = 729;  // brick_stride^3
  static constexpr int node_size = 8;       // children along a side of a node
  static constexpr std::uint32_t occupied_bit = 0x80000000u;
  static constexpr std::size_t max_root_cells = 1u << 18;
  static constexpr int max_root_side = 1024;  // cells

  ivec3 origin{0};     // index-space voxel of the first cell of the root; a multiple of the root's cell size
  ivec3 root_dims{0};  // cells of the root along each axis; all zero for an empty volume
  int levels = 0;      // node levels between root and bricks: 0 means that root entries are bricks
  std::vector<BrickEntry> root;            // root_dims.x * y * z entries, x fastest
  std::vector<BrickEntry> nodes;           // 512 entries per node, x fastest
  std::vector<std::uint16_t> density;      // 729 per brick, x fastest: fraction of the brick's maximum
  std::vector<std::uint16_t> temperature;  // 729 for each of the first hot_brick_count() bricks: fraction of
                                           // temperature_max; the bricks behind them are at 0 K throughout
  float density_max = 0.0f;                // [unit of the file] largest voxel
  float temperature_max = 0.0f;            // [K] what a stored temperature of 65535 stands for
  ivec3 bounds_min{0}, bounds_max{0};      // index-space box outside which density is zero (support of the
                                           // trilinear reconstruction: voxel bounds grown by one)
  dmat4 medium_from_index{1.0};            // affine; the file's transform
  std::int64_t active_voxels = 0;          // voxels with a non-zero density
  std::int64_t leaf_count = 0;             // 8^3-aligned blocks of voxels with a non-zero voxel in them

  std::size_t brick_count() const { return density.size() / brick_voxels; }
  /// Bricks are numbered so that those with any temperature come first: most of a medium is cold, and then
  /// costs no memory for it.
  std::size_t hot_brick_count() const { return temperature.size() / brick_voxels; }
  bool empty() const { return density.empty(); }
  /// Bytes that the volume takes on the CPU; on the GPU it takes the same, plus what is lost at the atlas'
  /// edge.
  std::size_t bytes() const;
  /// Side of a root cell in voxels.
  int root_cell_size() const { return brick_size << (3 * levels); }

  /// The entry whose cell holds the index-space cell `cell`, and that cell's side in voxels and lower corner.
  struct Lookup {
    BrickEntry entry;  // occupied: a brick; empty otherwise
    int size;          // [voxels] side of the cell
    ivec3 corner;      // [voxels] its lower corner
  };
  Lookup find(ivec3 cell) const;

  /// Trilinear density at an index-space position [unit of the file], zero outside.
  float sample_density(vec3 index_position) const;
  /// Trilinear temperature at an index-space position [K], zero where there is no density nearby.
  float sample_temperature(vec3 index_position) const;
  /// The voxel at a whole index-space coordinate, as stored (dequantised).
  float voxel_density(ivec3 voxel) const;

 private:
  float sample(const std::vector<std::uint16_t>& bricks, vec3 index_position, bool brick_scaled) const;
};

/// What had to be mended in the voxels of a source, counted so that it can be said aloud.
struct VoxelRepairs {
  std::int64_t not_a_number = 0;  // read as 0
  std::int64_t infinite = 0;      // read as the largest finite voxel (+) or 0 (-)
  std::int64_t negative = 0;      // read as 0
  std::int64_t total() const { return not_a_number + infinite + negative; }
};

/// Collects 8^3 blocks of voxels and makes a BrickVolume of them. Memory follows the blocks that are added,
/// not their bounding box. `add` may be called from several threads, at most once per block.
class BrickVolumeBuilder {
 public:
  static constexpr int block_voxels = 512;

  BrickVolumeBuilder();
  ~BrickVolumeBuilder();
  BrickVolumeBuilder(const BrickVolumeBuilder&) = delete;
  BrickVolumeBuilder& operator=(const BrickVolumeBuilder&) = delete;

  /// block: coordinate of the block (its first voxel is block * 8). density: 512 values, x fastest.
  /// temperature: null or 512 values [K]. Blocks without any non-zero voxel are dropped.
  void add(ivec3 block, const float* density, const float* temperature = nullptr);

  /// Makes the volume and empties the builder. Values that are not finite or negative are repaired and
  /// counted.
  BrickVolume build(const dmat4& medium_from_index);

  /// What the last build() repaired.
  const VoxelRepairs& repairs() const;

 private:
  struct State;
  State* state_;
};

}  // namespace plinian
