// Lights and cameras as lines in the world, of a size that is chosen for the screen.
#pragma once

#include <vector>

#include "core/lights/light.h"
#include "core/scene/camera.h"

namespace plinian::window {

struct WorldLine {
  dvec3 from{0.0}, to{0.0};  // [world]
};

/// A sun with the way it shines, a cone, or a star. at: [world] where it stands. facing: columns x, y of the
/// screen [world, unit]. size: [world] of the icon's radius.
std::vector<WorldLine> light_icon(const Light& light, const dvec3& at, const dmat3& facing, double size);

/// A frustum with the shape of its film, and what is up in it.
std::vector<WorldLine> camera_icon(const Camera& camera, double size);

}  // namespace plinian::window
