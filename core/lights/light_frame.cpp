#include "core/lights/light_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plinian {
namespace {

/// Two unit vectors that make a right-handed frame with the unit vector w; continuous but at one pole.
void complete_frame(dvec3 w, dvec3& u, dvec3& v) {
  const dvec3 helper = std::abs(w.y) < 0.999 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  u = glm::normalize(glm::cross(helper, w));
  v = glm::cross(w, u);
}

/// An interval grown to a snapped length: `cells` cells whose size is a power of 2^(1/8), from a whole cell
/// on.
void snap(double& low, double& high, int cells) {
  const double extent = std::max(high - low, 1e-9);
  // One cell more than needed on each side: half a texel of guard and the snap of the corner.
  const double cell = std::exp2(std::ceil(8.0 * std::log2(extent / (cells - 2))) / 8.0);
  low = (std::floor(low / cell - 0.5)) * cell;
  high = low + cell * cells;
}

vec4 row(dvec3 axis, double offset) {
  return vec4(vec3(axis), float(offset));
}

MapData orthographic(const Light& light, const Corners& corners, int resolution) {
  const dvec3 along = -glm::normalize(dvec3(light.toward));
  dvec3 u, v;
  complete_frame(along, u, v);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  dvec3 low(infinity), high(-infinity);
  for (const dvec3& c : corners) {
    const dvec3 p(glm::dot(c, u), glm::dot(c, v), glm::dot(c, along));
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  snap(low.x, high.x, resolution);
  snap(low.y, high.y, resolution);
  const double depth = std::max(high.z - low.z, 1e-9) * 1.0001;
  MapData map{};
  map.projection = projection_orthographic;
  const dvec3 size = high - low;
  map.row_u = row(u / size.x, -low.x / size.x);
  map.row_v = row(v / size.y, -low.y / size.y);
  map.row_k = row(along, -low.z);
  map.k_max = float(depth);
  map.ray_origin = vec3(u * low.x + v * low.y + along * low.z);
  map.ray_u = vec3(u * size.x);
  map.ray_v = vec3(v * size.y);
  map.ray_k = vec3(along);
  return map;
}

MapData perspective(const Light& light, const Corners& corners, dvec3 u, dvec3 v, dvec3 along,
                    double tangent) {
  const dvec3 position(light.position);
  double farthest = 1e-9;
  for (const dvec3& c : corners) farthest = std::max(farthest, glm::length(c - position));
  MapData map{};
  map.projection = projection_perspective;
  const double scale = 0.5 / tangent;
  map.row_u = row(u * scale, -glm::dot(u * scale, position));
  map.row_v = row(v * scale, -glm::dot(v * scale, position));
  map.row_k = row(along, -glm::dot(along, position));
  map.k_max = float(farthest * 1.0001);
  map.ray_origin = light.position;
  map.ray_u = vec3(u * tangent);
  map.ray_v = vec3(v * tangent);
  map.ray_k = vec3(along);
  return map;
}

}  // namespace

std::vector<MapData> light_frames(const Light& light, const Corners& corners, int resolution) {
  if (light.type == LightType::directional) return {orthographic(light, corners, resolution)};
  // A texel of guard all around, so that lookups near the border still find four texels.
  const double guard = 1.0 + 2.0 / resolution;
  if (light.type == LightType::spot && light.cone_angle <= 120.0f) {
    const dvec3 along = -glm::normalize(dvec3(light.toward));
    dvec3 u, v;
    complete_frame(along, u, v);
    return {perspective(light, corners, u, v, along,
                        std::tan(glm::radians(std::max(double(light.cone_angle), 0.01)) / 2.0) * guard)};
  }
  std::vector<MapData> faces;
  for (int face = 0; face < 6; ++face) {
    dvec3 along(0.0), u(0.0);
    along[face / 2] = face % 2 ? -1.0 : 1.0;
    u[(face / 2 + 1) % 3] = 1.0;
    faces.push_back(perspective(light, corners, u, glm::cross(along, u), along, guard));
  }
  return faces;
}

}  // namespace plinian
