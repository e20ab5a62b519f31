// The light that a scene without lights stands in: a key from the upper side, a rim from behind the other
// side, and a dim cool sky, all placed around the camera so that any volume shows its relief and its edge.
#pragma once

#include "core/lights/light.h"
#include "core/scene/camera.h"
#include "core/scene/framing.h"

namespace plinian {

/// Irradiance of the key [radiance * sr] facing it. An opaque medium of albedo 0.8 that scatters evenly then
/// shows about 0.5 to 0.8 on its lit side: 0.8 / (4 pi) * irradiance * cos_l / (cos_l + cos_v) with cosines
/// between surface, light and viewer, see Chandrasekhar, "Radiative Transfer", 1950, section 44.
inline constexpr float key_intensity = 12.566370614f;
inline constexpr float key_exposure = 0.75f;  // [stops]

/// The rim is brighter than the key: of the side that it lights only an edge is seen. [stops] on
/// key_intensity
inline constexpr float rim_exposure = 1.75f;

/// Sky of the default light [radiance]: the ambient that scatters, and what stands behind the media.
inline const vec3 default_ambient{0.020f, 0.027f, 0.038f};
inline const vec3 default_background{0.010f, 0.013f, 0.018f};

/// The key and the rim, directional, around a camera; +y is up.
Light default_key(const Camera& camera);
Light default_rim(const Camera& camera);

/// Exposure at which a new light lights the middle of the media as the default key does [stops]: with its
/// intensity, falloff, radius and position, and irradiances compared by luminance. A light without intensity
/// or colour gets key_exposure.
float new_light_exposure(const Light& light, const SceneBounds& bounds);

/// Rec.709 luminance [unit of the colour].
float luminance(vec3 colour);

}  // namespace plinian
