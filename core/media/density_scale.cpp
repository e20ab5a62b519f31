// Optical depth through a volume's silhouette. See density_scale.h.
#include "core/media/density_scale.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/media/brick_walk.h"

namespace plinian {
namespace {

constexpr double rays_wanted = 12288.0;  // over the three views
constexpr std::size_t rays_enough = 64;  // that meet density, for a median

/// A line in index space; t runs in medium units.
struct Line {
  dvec3 origin, direction;
};

struct Column {
  double density = 0.0;          // [unit of the file * medium] integral of density
  double density_squared = 0.0;  // likewise, of its square
};

/// The part of a line inside a box, or an empty one (first > second).
std::pair<double, double> clip(const Line& line, dvec3 low, dvec3 high) {
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = line.origin[axis], d = line.direction[axis];
    if (d == 0.0) {
      if (o < low[axis] || o > high[axis]) return {1.0, 0.0};
      continue;
    }
    const double a = (low[axis] - o) / d, b = (high[axis] - o) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

/// The longest step between samples [voxels]: one, or in a volume of more than 256^3 voxels what makes some
/// 256 of a ray through it.
double longest_step(const BrickVolume& volume) {
  return std::clamp(std::cbrt(double(volume.brick_count()) * 512.0) / 256.0, 1.0, 4.0);
}

/// Integrates density along the whole line: cell by cell of the tree, in even steps inside bricks.
Column integrate(const BrickVolume& volume, const Line& line) {
  Column column;
  const double steps_per_voxel = 1.0 / longest_step(volume);
  const double voxels_per_unit = glm::length(line.direction);
  const double nudge = 1e-4 / voxels_per_unit;
  auto [t, end] = clip(line, dvec3(volume.bounds_min), dvec3(volume.bounds_max));
  while (t < end) {
    const dvec3 p = line.origin + line.direction * (t + nudge);
    const BrickVolume::Lookup cell = volume.find(ivec3(glm::floor(p)));
    const bool occupied = (cell.entry.x & BrickVolume::occupied_bit) != 0;
    const int around =
        occupied ? 0 : std::max(0, int(cell.entry.x) - 1);  // cells that are empty beside this one
    const auto [enter, leave] =
        clip(line, dvec3(cell.corner - around * cell.size), dvec3(cell.corner + (around + 1) * cell.size));
    const double next = std::min(end, std::max(leave, t + nudge));
    if (occupied) {
      const int steps = std::max(1, int(std::ceil((next - t) * voxels_per_unit * steps_per_voxel)));
      const double step = (next - t) / steps;
      for (int i = 0; i < steps; ++i) {
        const double density =
            volume.sample_density(vec3(line.origin + line.direction * (t + (i + 0.5) * step)));
        column.density += density * step;
        column.density_squared += density * density * step;
      }
    }
    t = next;
  }
  return column;
}

/// Rays along the three axes of medium space, evenly spaced over the three faces of its bounding box.
std::vector<Line> silhouette_rays(const BrickVolume& volume, const dmat4& index_from_medium) {
  dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 p((corner & 1) ? volume.bounds_max.x : volume.bounds_min.x,
                  (corner & 2) ? volume.bounds_max.y : volume.bounds_min.y,
                  (corner & 4) ? volume.bounds_max.z : volume.bounds_min.z);
    const dvec3 q(volume.medium_from_index * dvec4(p, 1.0));
    low = glm::min(low, q);
    high = glm::max(high, q);
  }
  const dvec3 size = high - low;
  const double spacing = std::sqrt((size.x * size.y + size.y * size.z + size.z * size.x) / rays_wanted);
  std::vector<Line> rays;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    // A box that is flat or thin keeps a ray across its width.
    const int columns = std::clamp(int(size[u] / spacing + 0.5), 1, 1 << 14);
    const int rows = std::clamp(int(size[v] / spacing + 0.5), 1, 1 << 14);
    dvec3 direction(0.0);
    direction[axis] = 1.0;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        dvec3 origin(0.0);
        origin[axis] = low[axis];
        origin[u] = low[u] + size[u] * (i + 0.5) / columns;
        origin[v] = low[v] + size[v] * (j + 0.5) / rows;
        rays.push_back({dvec3(index_from_medium * dvec4(origin, 1.0)),
                        dvec3(index_from_medium * dvec4(direction, 0.0))});
      }
  }
  return rays;
}

/// Rays along the same axes through the bricks themselves, for a volume that a regular grid of rays misses.
// Biased: a column is met as often as it has bricks, so the median leans to deep ones.
std::vector<Line> brick_rays(const BrickVolume& volume, const dmat4& index_from_medium) {
  const std::size_t stride = volume.brick_count() / 1024 + 1;
  std::vector<Line> rays;
  std::size_t i = 0;
  for_each_brick(volume, [&](ivec3 corner, std::size_t brick, BrickEntry) {
    if (i++ % stride != 0) return;
    const std::uint16_t* voxels = volume.density.data() + brick * BrickVolume::brick_voxels;
    const int at = int(std::max_element(voxels, voxels + BrickVolume::brick_voxels) - voxels);
    constexpr int side = BrickVolume::brick_stride;
    const dvec3 through = dvec3(corner + ivec3(at % side, at / side % side, at / (side * side)));
    for (int axis = 0; axis < 3; ++axis) rays.push_back({through, dvec3(index_from_medium[axis])});
  });
  return rays;
}

std::vector<Column> integrate(const BrickVolume& volume, const std::vector<Line>& rays) {
  std::vector<Column> columns(rays.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 64), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) columns[i] = integrate(volume, rays[i]);
  });
  std::erase_if(columns, [](const Column& c) { return !(c.density > 0.0); });
  return columns;
}

}  // namespace

DensityFacts measure_density(const BrickVolume& volume, const dmat4& world_from_medium) {
  if (volume.empty()) return {};
  const dmat4 index_from_medium = glm::inverse(volume.medium_from_index);
  std::vector<Column> columns = integrate(volume, silhouette_rays(volume, index_from_medium));
  if (columns.size() < rays_enough) columns = integrate(volume, brick_rays(volume, index_from_medium));
  if (columns.empty()) return {};
  double sum = 0.0, sum_squared = 0.0;
  for (const Column& column : columns) {
    sum += column.density;
    sum_squared += column.density_squared;
  }
  const auto middle = columns.begin() + std::ptrdiff_t(columns.size() / 2);
  std::nth_element(columns.begin(), middle, columns.end(),
                   [](const Column& a, const Column& b) { return a.density < b.density; });
  // An uneven scale has no single length; its volume's is as good a mean as any.
  const double world_per_medium = std::cbrt(std::abs(glm::determinant(dmat3(world_from_medium))));
  return {float(middle->density * world_per_medium), float(sum_squared / sum), int(columns.size())};
}

float automatic_density_scale(const BrickVolume& volume, const dmat4& world_from_medium,
                              float optical_depth) {
  const float column = measure_density(volume, world_from_medium).median_column;
  const float scale = optical_depth / column;
  return column > 0.0f && std::isfinite(scale) ? scale : 1.0f;
}

vec3 mean_free_path(const Medium& medium, float density) {
  return 1.0f / (density * medium.density_scale * (medium.sigma_s + medium.sigma_a));
}

void rescale_volume(Medium& medium, double factor, Keep keep) {
  if (!(factor > 0.0) || !std::isfinite(factor))
    throw std::invalid_argument("a volume is scaled by a factor above zero");
  medium.world_from_medium = glm::scale(medium.world_from_medium, dvec3(factor));
  if (keep == Keep::optical_depth) medium.density_scale = float(medium.density_scale / factor);
}

}  // namespace plinian
