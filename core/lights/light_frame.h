// The views that a light looks at the media from: the squares that transmittance maps cover.
//
// Directional: an orthographic frame fitted to the media. Its size grows in steps of 2^(1/8) and its corner
// lies on whole texels of the light's own grid, so that shadows do not swim while media move. Spot: its cone.
// Point: six faces of a cube. k runs from the near plane (directional) or the light (others), in world units.
#pragma once

#include <vector>

#include "core/lights/light.h"
#include "core/shared/scene_data.h"

namespace plinian {

/// Corners of the media's boxes in world space, 8 per medium.
using Corners = std::vector<dvec3>;

/// The maps of one light, with layer, group and exponent left for the caller. One, or six for a point light
/// or a very wide cone (order: +x -x +y -y +z -z). resolution: texels along a side.
std::vector<MapData> light_frames(const Light& light, const Corners& corners, int resolution);

}  // namespace plinian
