// Lights: directional, spot and point, as a scene sees them.
#pragma once

#include <string>

#include "core/shared/glue.h"

namespace plinian {

enum class LightType { directional, spot, point };
enum class Falloff { inverse_square, linear, none };  // of irradiance with distance r: 1/r^2, 1/r, 1

struct Light {
  std::string name = "light";
  LightType type = LightType::directional;
  vec3 toward{0.0f, 1.0f, 0.0f};  // [-] unit; points from the scene to the light. For a spot: from where it
                                  // shines at back to the lamp, so the beam runs along -toward
  vec3 position{0.0f};            // [world] spot and point
  vec3 colour{1.0f};              // [-] linear Rec.709
  float intensity = 1.0f;  // directional: irradiance facing the light; spot and point: irradiance at r = 1
  float exposure = 0.0f;   // [stops] intensity is multiplied by 2^exposure
  Falloff falloff = Falloff::inverse_square;  // spot and point
  float radius = 0.0f;                        // [world] >= 0: falloff is evaluated at max(r, radius)
  float cone_angle = 40.0f;                   // [degrees] full angle of a spot's cone
  float penumbra = 5.0f;                      // [degrees] soft edge inside the cone, per side

  /// colour * intensity * 2^exposure.
  vec3 power() const { return colour * (intensity * glm::exp2(exposure)); }
};

}  // namespace plinian
