// Blocks of voxels out of OpenVDB trees. See vdb_worker_blocks.h.
#include "core/media/vdb_worker_blocks.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/media/vdb_protocol.h"

namespace plinian::vdb {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;
using openvdb::FloatGrid;
using openvdb::FloatTree;
using openvdb::Vec3d;
using openvdb::math::Transform;
using Accessor = openvdb::tree::ValueAccessor<const FloatTree, /*IsSafe=*/false>;

/// How a grid's voxels relate to the target's.
struct Source {
  FloatGrid::ConstPtr grid;
  bool aligned = true;         // voxel for voxel the target's
  bool linear = true;          // else a frustum: positions go through the transforms
  openvdb::Mat4d from_target;  // index to index, row vectors; for linear ones
  const Transform* target = nullptr;
  float outside = 0.0f;  // value of what is not active

  Vec3d position(const Vec3d& p) const {
    if (!linear) return grid->transform().worldToIndex(target->indexToWorld(p));
    return from_target.transform(p);
  }
};

Source make_source(const FloatGrid::ConstPtr& grid, const Transform& target) {
  Source source{grid, same_lattice(grid->transform(), target), grid->transform().isLinear(),
                openvdb::Mat4d::identity(), &target};
  if (!source.aligned && source.linear)
    source.from_target = target.baseMap()->getAffineMap()->getMat4() *
                         grid->transform().baseMap()->getAffineMap()->getMat4().inverse();
  return source;
}

/// 512 values of an aligned grid, x fastest.
void fetch(Accessor& tree, Coord origin, float outside, float* values) {
  if (const auto* leaf = tree.probeConstLeaf(origin)) {
    const float* stored = leaf->buffer().data();
    const auto& mask = leaf->valueMask();
    // OpenVDB's leaves run z fastest.
    for (int x = 0, from = 0; x < 8; ++x)
      for (int y = 0; y < 8; ++y)
        for (int z = 0; z < 8; ++z, ++from)
          values[(z << 6) | (y << 3) | x] = mask.isOn(from) ? stored[from] : outside;
    return;
  }
  float value;
  std::fill_n(values, block_voxels, tree.probeValue(origin, value) ? value : outside);
}

float voxel(Accessor& tree, Coord at, float outside) {
  float value;
  return tree.probeValue(at, value) ? value : outside;
}

/// 512 values of a grid under another transform: trilinear at the target's voxel centres.
// Biased: a grid finer than the target is sampled at points, not averaged over the target's voxels.
void resample(Accessor& tree, const Source& source, Coord origin, float* values) {
  constexpr double limit = 1 << 30;
  for (int i = 0; i < block_voxels; ++i) {
    Vec3d p =
        source.position(Vec3d(origin.x() + (i & 7), origin.y() + ((i >> 3) & 7), origin.z() + (i >> 6)));
    values[i] = source.outside;
    if (!(std::abs(p[0]) < limit && std::abs(p[1]) < limit && std::abs(p[2]) < limit)) continue;
    for (int axis = 0; axis < 3; ++axis)  // lattices that meet up to rounding pass values on untouched
      if (const double whole = std::round(p[axis]); std::abs(p[axis] - whole) < 1e-6) p[axis] = whole;
    const Coord base = Coord::floor(p);
    const Vec3d f = p - base.asVec3d();
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const int x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2;
      const double weight = (x ? f[0] : 1.0 - f[0]) * (y ? f[1] : 1.0 - f[1]) * (z ? f[2] : 1.0 - f[2]);
      if (weight > 0.0) sum += weight * voxel(tree, base.offsetBy(x, y, z), source.outside);
    }
    values[i] = static_cast<float>(sum);
  }
}

void evaluate(Accessor& tree, const Source& source, Coord origin, float* values) {
  if (source.aligned)
    fetch(tree, origin, source.outside, values);
  else
    resample(tree, source, origin, values);
}

bool before(const Coord& a, const Coord& b) {
  return a.z() != b.z() ? a.z() < b.z() : a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
}

/// The blocks that hold density, gathered under a cap.
class BlockList {
 public:
  BlockList(std::uint64_t most_bytes, std::uint64_t bytes_per_block)
      : most_(static_cast<std::int64_t>(std::min<std::uint64_t>(most_bytes / bytes_per_block, 1ull << 34))),
        bytes_per_block_(bytes_per_block) {}

  /// Adds the blocks of a box of voxels.
  void add(const CoordBBox& box) {
    const auto side = [&](int axis) {
      return (std::int64_t(box.max()[axis]) >> 3) - (std::int64_t(box.min()[axis]) >> 3) + 1;
    };
    for (int axis = 0; axis < 3; ++axis)
      if (box.min()[axis] / 8 <= -max_block_coordinate || box.max()[axis] / 8 >= max_block_coordinate)
        throw BadFile("its voxels lie too far from the origin of index space");
    // Sides are under 2^28 and room under 2^35: no product here can overflow.
    const std::int64_t room = most_ + 1;
    const std::int64_t area = side(0) * side(1);
    if (area > room || area * side(2) > room - std::int64_t(blocks_.size())) {
      tidy();
      if (area > room || area * side(2) > room - std::int64_t(blocks_.size()))
        refuse(double(area) * double(side(2)));
    }
    for (int z = box.min().z() >> 3; z <= box.max().z() >> 3; ++z)
      for (int y = box.min().y() >> 3; y <= box.max().y() >> 3; ++y)
        for (int x = box.min().x() >> 3; x <= box.max().x() >> 3; ++x) blocks_.emplace_back(x, y, z);
  }

  std::vector<Coord> take() {
    tidy();
    return std::move(blocks_);
  }

 private:
  void tidy() {
    std::sort(blocks_.begin(), blocks_.end(), before);
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
  }
  [[noreturn]] void refuse(double more) const {
    const double needed = (double(blocks_.size()) + more) * double(bytes_per_block_);
    throw TooManyVoxels("its active voxels take at least " +
                        std::to_string(std::llround(needed / (1 << 20))) +
                        " MiB, the limit on memory leaves " +
                        std::to_string((most_ * bytes_per_block_) >> 20) + " MiB for them");
  }
  std::int64_t most_;
  std::uint64_t bytes_per_block_;
  std::vector<Coord> blocks_;
};

/// The box of target voxels that a box of a source's voxels can reach by trilinear interpolation.
CoordBBox reach(const Source& source, const CoordBBox& box) {
  if (source.aligned) return box;
  Vec3d low(std::numeric_limits<double>::infinity()), high(-low);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p((corner & 1) ? box.max().x() + 1.0 : box.min().x() - 1.0,
                  (corner & 2) ? box.max().y() + 1.0 : box.min().y() - 1.0,
                  (corner & 4) ? box.max().z() + 1.0 : box.min().z() - 1.0);
    const Vec3d q = source.target->worldToIndex(source.grid->transform().indexToWorld(p));
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(q[axis]) < double(1 << 30)))
        throw BadFile("its voxels lie too far from each other to be resampled");
      low[axis] = std::min(low[axis], q[axis]);
      high[axis] = std::max(high[axis], q[axis]);
    }
  }
  return CoordBBox(Coord::ceil(low), Coord::floor(high));
}

/// Whether a tile of this value is density; what it is instead is counted.
bool holds_density(float value, std::int64_t voxels, Mended& skipped) {
  if (std::isnan(value))
    skipped.not_a_number += voxels;
  else if (std::isinf(value) && value < 0.0f)
    skipped.infinite += voxels;
  else if (value < 0.0f)
    skipped.negative += voxels;
  return value > 0.0f;
}

void gather(const Source& source, BlockList& blocks, Mended& skipped) {
  auto tile = source.grid->tree().cbeginValueOn();
  tile.setMaxDepth(tile.getLeafDepth() - 1);
  for (; tile; ++tile) {
    CoordBBox box;
    tile.getBoundingBox(box);
    if (holds_density(tile.getValue(), static_cast<std::int64_t>(box.volume()), skipped))
      blocks.add(reach(source, box));
  }
  for (auto leaf = source.grid->tree().cbeginLeaf(); leaf; ++leaf)
    if (!leaf->isEmpty()) blocks.add(reach(source, leaf->getNodeBoundingBox()));
}

/// Moves blocks that lie far out towards the origin: positions in index space are single precision later on.
openvdb::Vec3i rebase(std::vector<Coord>& blocks) {
  constexpr int near = 2048;  // [blocks] 16384 voxels: 1/1024 of a voxel is resolved
  if (blocks.empty()) return openvdb::Vec3i(0);
  CoordBBox box;
  for (const Coord& block : blocks) box.expand(block);
  const bool is_near = box.min().x() >= -near && box.min().y() >= -near && box.min().z() >= -near &&
                       box.max().x() < near && box.max().y() < near && box.max().z() < near;
  if (is_near) return openvdb::Vec3i(0);
  const Coord middle((box.min().x() + box.max().x()) >> 1, (box.min().y() + box.max().y()) >> 1,
                     (box.min().z() + box.max().z()) >> 1);
  for (Coord& block : blocks) block -= middle;
  return middle.asVec3i() * 8;
}

}  // namespace

bool same_lattice(const Transform& a, const Transform& b) {
  if (!a.isLinear() || !b.isLinear()) return &a == &b;
  const openvdb::Mat4d ma = a.baseMap()->getAffineMap()->getMat4(),
                       mb = b.baseMap()->getAffineMap()->getMat4();
  const double size = std::cbrt(std::abs(mb.det()));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      // Axes may differ by a millionth of a voxel over a thousand voxels, the origin by a millionth.
      if (!(std::abs(ma(i, j) - mb(i, j)) <= (i < 3 ? 1e-9 : 1e-6) * size)) return false;
  return true;
}

Transform::Ptr common_lattice(const std::vector<FloatGrid::Ptr>& grids) {
  const FloatGrid* finest = nullptr;
  const auto cell = [](const FloatGrid& g) {
    return std::abs(g.transform().baseMap()->getAffineMap()->getMat4().det());
  };
  for (const auto& grid : grids)
    if (grid->transform().isLinear() && (!finest || cell(*grid) < cell(*finest))) finest = grid.get();
  if (finest) return finest->transform().copy();
  const FloatGrid& grid = *grids.front();
  const CoordBBox box = grid.evalActiveVoxelBoundingBox();
  const Vec3d middle = box.empty() ? Vec3d(0.0) : (box.min().asVec3d() + box.max().asVec3d()) * 0.5;
  const Vec3d size = grid.transform().voxelSize(middle);
  const double side = std::cbrt(std::abs(size[0] * size[1] * size[2]));
  if (!(side > 1e-18 && side < 1e18)) throw BadFile("its frustum transform is singular");
  return Transform::createLinearTransform(side);
}

Mended mend(FloatGrid& grid, float outside) {
  Mended mended;
  float largest = 0.0f;
  for (auto value = grid.cbeginValueOn(); value; ++value)
    if (std::isfinite(*value)) largest = std::max(largest, *value);
  const auto fix = [&](float value, std::int64_t voxels) {
    if (std::isnan(value)) {
      mended.not_a_number += voxels;
      return 0.0f;
    }
    if (std::isinf(value)) {
      mended.infinite += voxels;
      return value > 0.0f ? largest : 0.0f;
    }
    if (value < 0.0f) mended.negative += voxels;
    return std::max(value, 0.0f);
  };
  for (auto value = grid.beginValueOn(); value; ++value) {
    if (*value >= 0.0f && *value <= largest) continue;
    CoordBBox box;
    value.getBoundingBox(box);
    value.setValue(fix(*value, value.isTileValue() ? static_cast<std::int64_t>(box.volume()) : 1));
  }
  grid.tree().root().setBackground(outside, /*updateChildNodes=*/false);
  return mended;
}

BlockResult for_each_block(const BlockJob& job,
                           const std::function<void(Coord, const float*, const float*)>& sink,
                           const std::function<void(double)>& share) {
  BlockResult result;
  std::vector<Source> density, temperature;
  for (const auto& grid : job.density) density.push_back(make_source(grid, *job.target));
  for (const auto& grid : job.temperature) {
    temperature.push_back(make_source(grid, *job.target));
    temperature.back().outside = grid->background();
  }
  BlockList list(job.most_bytes, block_voxels * sizeof(float) * (temperature.empty() ? 1 : 2));
  for (const Source& source : density) {
    gather(source, list, result.skipped);
    result.resampled += source.aligned ? 0 : 1;
  }
  std::vector<Coord> blocks = list.take();
  result.rebased = rebase(blocks);
  const Coord offset(result.rebased);

  constexpr std::size_t batch = 512;
  const bool hot = !temperature.empty();
  std::vector<float> values(batch * block_voxels), kelvin(hot ? batch * block_voxels : 0);
  std::vector<char> any(batch), warm(batch);
  for (std::size_t begin = 0; begin < blocks.size(); begin += batch) {
    const std::size_t count = std::min(batch, blocks.size() - begin);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 32), [&](const auto& range) {
      std::vector<std::unique_ptr<Accessor>> trees;
      for (const Source& source : density) trees.push_back(std::make_unique<Accessor>(source.grid->tree()));
      for (const Source& source : temperature)
        trees.push_back(std::make_unique<Accessor>(source.grid->tree()));
      float one[block_voxels];
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        const Coord& block = blocks[begin + i];
        const Coord origin = Coord(block.x() * 8, block.y() * 8, block.z() * 8) + offset;
        float* sum = values.data() + i * block_voxels;
        evaluate(*trees[0], density[0], origin, sum);
        for (std::size_t s = 1; s < density.size(); ++s) {
          evaluate(*trees[s], density[s], origin, one);
          for (int v = 0; v < block_voxels; ++v) sum[v] += one[v];
        }
        any[i] = std::any_of(sum, sum + block_voxels, [](float v) { return v != 0.0f; });
        warm[i] = 0;
        if (!hot || !any[i]) continue;
        float* heat = kelvin.data() + i * block_voxels;
        evaluate(*trees[density.size()], temperature[0], origin, heat);
        for (std::size_t s = 1; s < temperature.size(); ++s) {
          evaluate(*trees[density.size() + s], temperature[s], origin, one);
          for (int v = 0; v < block_voxels; ++v) heat[v] = std::max(heat[v], one[v]);
        }
        for (int v = 0; v < block_voxels; ++v) heat[v] *= job.temperature_gain;
        warm[i] = std::any_of(heat, heat + block_voxels, [](float v) { return v > 0.0f; });
      }
    });
    for (std::size_t i = 0; i < count; ++i)
      if (any[i])
        sink(blocks[begin + i], values.data() + i * block_voxels,
             warm[i] ? kelvin.data() + i * block_voxels : nullptr);
    share(double(begin + count) / double(blocks.size()));
  }
  return result;
}

}  // namespace plinian::vdb
