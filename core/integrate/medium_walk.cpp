#include "core/integrate/medium_walk.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace plinian {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Cuts [begin, end] to the part of the line o + t d inside a box. False where nothing is left.
bool clip_to_box(dvec3 o, dvec3 d, dvec3 low, dvec3 high, double& begin, double& end) {
  for (int a = 0; a < 3; ++a) {
    if (d[a] == 0.0) {
      if (o[a] < low[a] || o[a] > high[a]) return false;
      continue;
    }
    const double t0 = (low[a] - o[a]) / d[a], t1 = (high[a] - o[a]) / d[a];
    begin = std::max(begin, std::min(t0, t1));
    end = std::min(end, std::max(t0, t1));
  }
  return begin < end;
}

/// Likewise for the unit ball. Roots about the point of closest approach: far cameras do not cancel digits.
bool clip_to_ball(dvec3 o, dvec3 d, double& begin, double& end) {
  const double length2 = glm::dot(d, d);
  const double closest = -glm::dot(o, d) / length2;
  const dvec3 p = o + closest * d;
  const double inside = 1.0 - glm::dot(p, p);
  if (!(inside > 0.0)) return false;
  const double half = std::sqrt(inside / length2);
  begin = std::max(begin, closest - half);
  end = std::min(end, closest + half);
  return begin < end;
}

/// The part of a ray inside one cell of the grid.
struct CellVisit {
  const std::uint16_t* v;  // the cell's lowest voxel in its brick
  dvec3 p, q;              // [cells] local point of entry, and the way from there to the exit
  double begin, end;       // [world] distances along the ray
  double scale;            // density of a stored 1
};

constexpr int stride_y = BrickVolume::brick_stride, stride_z = stride_y * stride_y;

/// The cubic that a trilinear density is along a line.
DensityPiece cubic(const CellVisit& cell) {
  const std::uint16_t* v = cell.v;
  const int v000 = v[0], v100 = v[1], v010 = v[stride_y], v110 = v[stride_y + 1];
  v += stride_z;
  const int v001 = v[0], v101 = v[1], v011 = v[stride_y], v111 = v[stride_y + 1];
  // f = a + bx x + by y + bz z + cxy x y + cyz y z + cxz x z + e x y z, whole numbers so far.
  const double a = v000, bx = v100 - v000, by = v010 - v000, bz = v001 - v000;
  const double cxy = v110 - v100 - v010 + v000, cyz = v011 - v010 - v001 + v000,
               cxz = v101 - v100 - v001 + v000;
  const double e = v111 - v110 - v101 - v011 + v100 + v010 + v001 - v000;
  const double x = cell.p.x, y = cell.p.y, z = cell.p.z, u = cell.q.x, w = cell.q.y, r = cell.q.z;
  const double c0 = a + bx * x + y * (by + cxy * x) + z * (bz + cxz * x + y * (cyz + e * x));
  const double c1 = bx * u + by * w + bz * r + cxy * (x * w + y * u) + cyz * (y * r + z * w) +
                    cxz * (x * r + z * u) + e * (u * y * z + x * w * z + x * y * r);
  const double c2 = cxy * u * w + cyz * w * r + cxz * u * r + e * (u * w * z + u * y * r + x * w * r);
  const double c3 = e * u * w * r;
  return {cell.begin, cell.end, {cell.scale * c0, cell.scale * c1, cell.scale * c2, cell.scale * c3}};
}

/// The integral of that cubic: the two-point Gauss rule is exact for it. Both points at once, in the two
/// lanes of a vector: this is where the reference spends its time.
double integral(const CellVisit& cell) {
  using Lanes = double __attribute__((vector_size(16)));
  const std::uint16_t* v = cell.v;
  const double v000 = v[0], v010 = v[stride_y], v001 = v[stride_z], v011 = v[stride_z + stride_y];
  const double d00 = v[1] - v[0], d10 = v[stride_y + 1] - v[stride_y], d01 = v[stride_z + 1] - v[stride_z],
               d11 = v[stride_z + stride_y + 1] - v[stride_z + stride_y];
  constexpr Lanes share{0.2113248654051871, 0.7886751345948129};
  const Lanes x = cell.p.x + cell.q.x * share, y = cell.p.y + cell.q.y * share,
              z = cell.p.z + cell.q.z * share;
  const Lanes r00 = v000 + d00 * x, r10 = v010 + d10 * x, r01 = v001 + d01 * x, r11 = v011 + d11 * x;
  const Lanes near = r00 + (r10 - r00) * y, far = r01 + (r11 - r01) * y;
  const Lanes density = near + (far - near) * z;
  return 0.5 * cell.scale * (cell.end - cell.begin) * (density[0] + density[1]);
}

bool finite(const dmat4& m) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (!std::isfinite(m[i][j])) return false;
  return true;
}

}  // namespace

MediumWalk::MediumWalk(const Medium& medium) : shape_(medium.shape) {
  dmat4 world_from_local = medium.world_from_medium;
  if (shape_ == MediumShape::voxels) {
    if (!medium.volume) throw std::invalid_argument("medium '" + medium.name + "' has no volume");
    volume_ = medium.volume.get();
    world_from_local = world_from_local * volume_->medium_from_index;
  }
  local_from_world_ = glm::inverse(world_from_local);
  if (!finite(local_from_world_))
    throw std::invalid_argument("medium '" + medium.name + "': its transform cannot be inverted");
}

bool MediumWalk::shape_chord(const Ray& ray, double& begin, double& end) const {
  const dvec3 o(local_from_world_ * dvec4(ray.origin, 1.0));
  const dvec3 d(local_from_world_ * dvec4(ray.direction, 0.0));
  return shape_ == MediumShape::box ? clip_to_box(o, d, dvec3(-1.0), dvec3(1.0), begin, end)
                                    : clip_to_ball(o, d, begin, end);
}

// From cell to cell through occupied bricks, from brick to brick through empty ones, until visit returns
// false. Cells are counted in whole numbers and planes are found anew in each brick, so nothing drifts on a
// long way.
template <class Visit>
void MediumWalk::walk_voxels(const Ray& ray, double begin, double end, Visit visit) const {
  const BrickVolume& volume = *volume_;
  const dvec3 o(local_from_world_ * dvec4(ray.origin, 1.0));
  const dvec3 d(local_from_world_ * dvec4(ray.direction, 0.0));
  if (volume.empty() || !clip_to_box(o, d, dvec3(volume.bounds_min), dvec3(volume.bounds_max), begin, end))
    return;
  ivec3 cell, step;
  dvec3 inverse, delta;
  for (int a = 0; a < 3; ++a) {
    step[a] = d[a] > 0.0 ? 1 : -1;
    inverse[a] = 1.0 / d[a];
    delta[a] = std::abs(inverse[a]);
    cell[a] = std::clamp(static_cast<int>(std::floor(o[a] + d[a] * begin)), volume.bounds_min[a],
                         volume.bounds_max[a] - 1);
  }
  // Distance at which the ray leaves the slab of cells [low, high) along an axis.
  const auto leave = [&](int a, int low, int high) {
    return d[a] == 0.0 ? infinity : ((d[a] > 0.0 ? high : low) - o[a]) * inverse[a];
  };

  double t = begin;
  while (t < end) {
    const BrickVolume::Lookup found = volume.find(cell);
    const ivec3 low = found.corner, high = low + found.size;
    if ((found.entry.x & BrickVolume::occupied_bit) == 0) {
      int axis = 0;
      double exit = infinity;
      for (int a = 0; a < 3; ++a)
        if (const double at = leave(a, low[a], high[a]); at < exit) exit = at, axis = a;
      t = std::max(t, exit);
      if (!(t < end)) return;
      for (int a = 0; a < 3; ++a) {
        if (a == axis) {
          cell[a] = step[a] > 0 ? high[a] : low[a] - 1;
        } else if (d[a] != 0.0) {
          // Never backwards, whatever rounding says: the walk always ends.
          const int here = std::clamp(static_cast<int>(std::floor(o[a] + d[a] * t)), low[a], high[a] - 1);
          cell[a] = step[a] > 0 ? std::max(cell[a], here) : std::min(cell[a], here);
        }
      }
      continue;
    }

    const std::uint16_t* brick =
        volume.density.data() +
        static_cast<std::size_t>(found.entry.x & ~BrickVolume::occupied_bit) * BrickVolume::brick_voxels;
    const double scale = double(glm::unpackHalf2x16(found.entry.y).y) * double(volume.density_max) / 65535.0;
    // Everything per axis in its own variable, and no branch on which axis is next: rays cross cells in no
    // order that a processor could guess.
    double next_x = leave(0, cell.x, cell.x + 1), next_y = leave(1, cell.y, cell.y + 1),
           next_z = leave(2, cell.z, cell.z + 1);
    const dvec3 from_corner = o - dvec3(low);
    ivec3 local = cell - low;
    for (;;) {
      const double until = std::min(std::min(next_x, next_y), std::min(next_z, end));
      if (until > t) {
        const std::uint16_t* v = brick + local.z * stride_z + local.y * stride_y + local.x;
        if (!visit(CellVisit{v, from_corner - dvec3(local) + d * t, d * (until - t), t, until, scale}))
          return;
        t = until;
      }
      if (!(t < end)) return;
      const bool x = next_x <= t, y = next_y <= t, z = next_z <= t;
      local.x += x ? step.x : 0;
      local.y += y ? step.y : 0;
      local.z += z ? step.z : 0;
      next_x += x ? delta.x : 0.0;
      next_y += y ? delta.y : 0.0;
      next_z += z ? delta.z : 0.0;
      // One comparison for both ends: -1 is a large unsigned number.
      if (((unsigned(local.x) | unsigned(local.y) | unsigned(local.z)) & ~7u) != 0u) break;
    }
    cell = low + local;
  }
}

void MediumWalk::pieces(const Ray& ray, double begin, double end, double enough,
                        std::vector<DensityPiece>& out) const {
  if (shape_ != MediumShape::voxels) {
    if (shape_chord(ray, begin, end)) out.push_back({begin, end, {1.0, 0.0, 0.0, 0.0}});
    return;
  }
  double sum = 0.0;
  walk_voxels(ray, begin, end, [&](const CellVisit& cell) {
    const DensityPiece piece = cubic(cell);
    if (piece.c[0] == 0.0 && piece.c[1] == 0.0 && piece.c[2] == 0.0 && piece.c[3] == 0.0) return true;
    out.push_back(piece);
    sum += piece.integral(piece.end);
    return sum <= enough;
  });
}

double MediumWalk::integral(const Ray& ray, double begin, double end, double enough) const {
  if (shape_ != MediumShape::voxels) return shape_chord(ray, begin, end) ? end - begin : 0.0;
  double sum = 0.0;
  walk_voxels(ray, begin, end, [&](const CellVisit& cell) {
    sum += plinian::integral(cell);
    return sum <= enough;
  });
  return std::max(sum, 0.0);
}

double MediumWalk::voxel_length(dvec3 world_direction) const {
  const double local = glm::length(dvec3(local_from_world_ * dvec4(world_direction, 0.0)));
  return (shape_ == MediumShape::voxels ? 1.0 : 1.0 / 64.0) / local;
}

float MediumWalk::stored_temperature(dvec3 world_position) const {
  return has_temperature() ? volume_->sample_temperature(vec3(local_from_world_ * dvec4(world_position, 1.0)))
                           : 0.0f;
}

}  // namespace plinian
