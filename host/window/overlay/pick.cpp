// Slabs of boxes.
#include "host/window/overlay/pick.h"

#include <algorithm>
#include <limits>

#include "core/scene/framing.h"

namespace plinian::window {

std::optional<double> box_ahead(const dvec3& origin, const dvec3& direction, const dvec3& minimum,
                                const dvec3& maximum) {
  double near = 0.0, far = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (direction[i] == 0.0) {
      if (origin[i] < minimum[i] || origin[i] > maximum[i]) return std::nullopt;
      continue;
    }
    const double a = (minimum[i] - origin[i]) / direction[i], b = (maximum[i] - origin[i]) / direction[i];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  if (near > far) return std::nullopt;
  return near;
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

}  // namespace plinian::window
