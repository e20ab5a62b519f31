// Slabs of boxes, and what the picture shows in them.
#include "host/window/overlay/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene/framing.h"

namespace plinian::window {

namespace {

struct Crossing {
  double near = 0.0, far = std::numeric_limits<double>::infinity();  // in lengths of the direction
};

std::optional<Crossing> crossing(const dvec3& origin, const dvec3& direction, const dvec3& minimum,
                                 const dvec3& maximum) {
  Crossing met;
  for (int i = 0; i < 3; ++i) {
    if (direction[i] == 0.0) {
      if (origin[i] < minimum[i] || origin[i] > maximum[i]) return std::nullopt;
      continue;
    }
    const double a = (minimum[i] - origin[i]) / direction[i], b = (maximum[i] - origin[i]) / direction[i];
    met.near = std::max(met.near, std::min(a, b));
    met.far = std::min(met.far, std::max(a, b));
  }
  return met.near > met.far ? std::nullopt : std::optional(met);
}

// The pixel nearest to a place, within a hand's breadth, where the picture shows something.
std::optional<std::size_t> seen_pixel(const Frame& frame, vec2 at) {
  constexpr float least_alpha = 0.004f;  // a step of an 8-bit picture
  const ivec2 size(frame.width, frame.height),
      middle = glm::clamp(ivec2(at * vec2(size)), ivec2(0), size - 1);
  const int reach = std::max(1, frame.height / 100);
  std::optional<std::size_t> found;
  int nearest = reach * reach + 1;
  for (int y = std::max(0, middle.y - reach); y <= std::min(size.y - 1, middle.y + reach); ++y)
    for (int x = std::max(0, middle.x - reach); x <= std::min(size.x - 1, middle.x + reach); ++x) {
      const int away = (x - middle.x) * (x - middle.x) + (y - middle.y) * (y - middle.y);
      const std::size_t pixel = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
      const vec3 t = frame.transmittance[pixel];
      if (away >= nearest || 1.0f - (t.x + t.y + t.z) / 3.0f < least_alpha) continue;
      nearest = away;
      found = pixel;
    }
  return found;
}

}  // namespace

std::optional<double> box_ahead(const dvec3& origin, const dvec3& direction, const dvec3& minimum,
                                const dvec3& maximum) {
  const auto met = crossing(origin, direction, minimum, maximum);
  return met ? std::optional(met->near) : std::nullopt;
}

std::optional<std::size_t> medium_ahead(const SceneSnapshot& scene, const dvec3& origin,
                                        const dvec3& direction) {
  std::optional<std::size_t> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const SceneBounds bounds = scene_bounds({scene.media[i]});
    if (bounds.outline.empty()) continue;
    const auto met = box_ahead(origin, direction, bounds.minimum, bounds.maximum);
    if (!met || *met >= nearest) continue;
    nearest = *met;
    found = i;
  }
  return found;
}

std::optional<std::size_t> medium_seen(const SceneSnapshot& scene, const Frame& frame, vec2 at,
                                       const dvec3& origin, const dvec3& direction) {
  const auto pixel = seen_pixel(frame, at);
  if (!pixel) return std::nullopt;
  const double depth = double(frame.depth[*pixel]);
  if (!std::isfinite(depth)) return medium_ahead(scene, origin, direction);
  // Where boxes lie in one another the tighter one says more.
  std::optional<std::size_t> found;
  double tightest = std::numeric_limits<double>::infinity();
  const dvec3 unit = glm::normalize(direction);
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const SceneBounds bounds = scene_bounds({scene.media[i]});
    if (bounds.outline.empty()) continue;
    const auto met = crossing(origin, unit, bounds.minimum, bounds.maximum);
    constexpr double tolerance = 1e-3;
    if (!met || depth < met->near * (1.0 - tolerance) || depth > met->far * (1.0 + tolerance)) continue;
    if (met->far - met->near >= tightest) continue;
    tightest = met->far - met->near;
    found = i;
  }
  return found ? found : medium_ahead(scene, origin, direction);
}

}  // namespace plinian::window
