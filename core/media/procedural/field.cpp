// The octree walk and the distance to the lobes of one block.
#include "core/media/procedural/field.h"

#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <mutex>

#include "core/media/procedural/lattice.h"

namespace plinian::procedural {
namespace {

constexpr int block_size = 8;
constexpr float unreached = 1e3f;  // [object] a distance where no lobe is near

/// Lobes that can matter somewhere in a cell of the octree.
struct Nearby {
  std::vector<std::uint32_t> hull, surface;
  float hull_bound = unreached;     // [object] nowhere in the cell is the hull farther than this
  float surface_bound = unreached;  // [object] likewise
};

class Walk {
 public:
  Walk(const Shape& shape, int resolution, BrickVolumeBuilder& builder, const ShapeProgress& progress)
      : shape_(shape),
        resolution_(resolution),
        voxel_(1.0f / static_cast<float>(resolution)),
        builder_(builder),
        progress_(progress) {}

  VoxeliseStats run() {
    const LobeFamily& family = shape_.family();
    Nearby all;
    const std::size_t hull_end = family.begin[std::min(shape_.hull_generations, family.generations())];
    for (std::uint32_t i = 0; i < family.lobes.size(); ++i) {
      if (i < hull_end) all.hull.push_back(i);
      all.surface.push_back(i);
    }
    const int blocks = (resolution_ + block_size - 1) / block_size;
    const int side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(blocks)));
    volume_ = double(side) * side * side;
    descend({0, 0, 0}, side, all);
    return {cancelled_, shaded_, solid_, visits_};
  }

 private:
  /// Keeps what can be nearest, and within reach, anywhere within `radius` of `centre`.
  template <class Radius>
  static float filter(const std::vector<std::uint32_t>& from, const std::vector<Lobe>& lobes,
                      Radius radius_of, vec3 centre, float radius, float reach,
                      std::vector<std::uint32_t>& to) {
    float bound = unreached;
    thread_local std::vector<float> distance;
    distance.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
      distance[i] = glm::length(lobes[from[i]].centre - centre) - radius_of(from[i]);
      bound = std::min(bound, distance[i] + radius);
    }
    for (std::size_t i = 0; i < from.size(); ++i)
      if (distance[i] - radius <= std::min(bound, reach)) to.push_back(from[i]);
    return bound;
  }

  /// Those of `wider` that matter within `radius` of `centre`, both after warping.
  Nearby narrow(const Nearby& wider, vec3 centre, float radius) const {
    const LobeFamily& family = shape_.family();
    Nearby near;
    near.hull_bound = filter(
        wider.hull, family.lobes, [&](std::uint32_t i) { return family.lobes[i].radius; }, centre, radius,
        shape_.hull_reach, near.hull);
    near.surface_bound = filter(
        wider.surface, family.lobes, [&](std::uint32_t i) { return family.body[i]; }, centre, radius,
        shape_.surface_reach, near.surface);
    return near;
  }

  void descend(ivec3 block, int side, const Nearby& wider) {
    if (cancelled_) return;
    const ivec3 first_voxel = block * block_size;
    if (first_voxel.x >= resolution_ || first_voxel.y >= resolution_ || first_voxel.z >= resolution_)
      return advance(side);
    const float half_side = 0.5f * static_cast<float>(side * block_size) * voxel_;
    const Nearby near =
        narrow(wider, vec3(first_voxel) * voxel_ + half_side, 1.7321f * half_side + shape_.warp_reach);
    if (near.hull.empty() && near.surface.empty()) return advance(side);
    if (side == 1) {
      evaluate(block, near);
      return advance(1);
    }
    const int half = side / 2;
    const auto child = [&, half](int i) {
      descend(block + half * ivec3(i & 1, (i >> 1) & 1, i >> 2), half, near);
    };
    if (side >= 4)
      tbb::parallel_for(0, 8, child);
    else
      for (int i = 0; i < 8; ++i) child(i);
  }

  void advance(int side) {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    done_ += double(side) * side * side;
    if (done_ < reported_ + 0.01 * volume_ && done_ < volume_) return;
    reported_ = done_;
    if (!progress_(std::min(1.0, done_ / volume_))) cancelled_ = true;
  }

  /// Warped positions. Returns a ball around them.
  std::pair<vec3, float> place(BlockField& field) const {
    for_each_interpolated(
        field.corner, voxel_, shape_.warp_wavelength, [&](vec3 p) { return shape_.warp(p); },
        [&](int i, vec3 offset) {
          const vec3 p = field.position(i) + offset;
          field.x[i] = p.x;
          field.y[i] = p.y;
          field.z[i] = p.z;
        });
    vec3 low(field.x[0], field.y[0], field.z[0]), high = low;
    for (int i = 1; i < BlockField::count; ++i) {
      const vec3 p(field.x[i], field.y[i], field.z[i]);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    return {0.5f * (low + high), 0.5f * glm::length(high - low)};
  }

  /// Least distance to some lobes for every voxel of the block.
  template <class Radius>
  void distances(const BlockField& field, const std::vector<std::uint32_t>& near, Radius radius_of,
                 float* out) const {
    std::fill(out, out + BlockField::count, unreached);
    const std::vector<Lobe>& lobes = shape_.family().lobes;
    for (const std::uint32_t i : near) {
      const vec3 c = lobes[i].centre;
      const float radius = radius_of(i);
      for (int v = 0; v < BlockField::count; ++v) {
        const float dx = field.x[v] - c.x, dy = field.y[v] - c.y, dz = field.z[v] - c.z;
        const float d = std::sqrt(dx * dx + dy * dy + dz * dz) - radius;
        out[v] = d < out[v] ? d : out[v];
      }
    }
  }

  void evaluate(ivec3 block, const Nearby& wider) {
    thread_local BlockField field;
    field.voxel = voxel_;
    field.corner = (vec3(block * block_size) + 0.5f) * voxel_;
    const LobeFamily& family = shape_.family();
    // The warp moves the block more than it stretches it: where it ends up, fewer lobes matter.
    const auto [centre, radius] = place(field);
    const Nearby near = narrow(wider, centre, radius);
    if (near.hull.empty() && near.surface.empty()) return;
    field.solid = near.surface_bound < -shape_.solid_depth && near.hull_bound < -shape_.solid_depth;
    if (field.solid) {
      ++solid_;
      std::fill(field.hull, field.hull + BlockField::count, near.hull_bound);
      std::fill(field.surface, field.surface + BlockField::count, near.surface_bound);
    } else {
      visits_ += static_cast<std::int64_t>(near.hull.size() + near.surface.size());
      distances(
          field, near.hull, [&](std::uint32_t i) { return family.lobes[i].radius; }, field.hull);
      distances(
          field, near.surface, [&](std::uint32_t i) { return family.body[i]; }, field.surface);
    }
    ++shaded_;
    float density[BlockField::count], temperature[BlockField::count] = {};
    const bool hot = shape_.shade(field, density, temperature);
    if (resolution_ % block_size != 0)  // what hangs over the edge of the object
      for (int i = 0; i < BlockField::count; ++i) {
        const ivec3 v = block * block_size + ivec3(i & 7, (i >> 3) & 7, i >> 6);
        if (std::max({v.x, v.y, v.z}) >= resolution_) density[i] = temperature[i] = 0.0f;
      }
    builder_.add(block, density, hot ? temperature : nullptr);
  }

  const Shape& shape_;
  const int resolution_;
  const float voxel_;
  BrickVolumeBuilder& builder_;
  const ShapeProgress& progress_;
  std::mutex mutex_;
  double done_ = 0.0, reported_ = 0.0, volume_ = 0.0;
  std::atomic<bool> cancelled_ = false;
  std::atomic<std::int64_t> shaded_ = 0, solid_ = 0, visits_ = 0;
};

}  // namespace

VoxeliseStats voxelise(const Shape& shape, int resolution, BrickVolumeBuilder& builder,
                       const ShapeProgress& progress) {
  return Walk(shape, resolution, builder, progress).run();
}

}  // namespace plinian::procedural
