// Default lights.
#include "core/scene/default_lights.h"

#include <cmath>

#include "core/shared/light_falloff.h"

namespace plinian {

namespace {

// Degrees around the subject from the camera, and above the horizon.
constexpr double key_azimuth = 58.0, key_elevation = 42.0;
constexpr double rim_azimuth = -138.0, rim_elevation = 8.0;

Light directional(const char* name, const Camera& camera, double azimuth, double elevation, vec3 colour,
                  float exposure) {
  // The camera's right-hand axis says where it stands even when it looks straight down.
  const dvec3 right(camera.world_from_camera[0]);
  const double camera_azimuth = glm::degrees(std::atan2(-right.z, right.x));
  Light light;
  light.name = name;
  light.toward = vec3(direction_from(camera_azimuth + azimuth, elevation));
  light.colour = colour / luminance(colour);
  light.intensity = key_intensity;
  light.exposure = exposure;
  return light;
}

}  // namespace

float luminance(vec3 colour) {
  return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f));
}

Light default_key(const Camera& camera) {
  return directional("key", camera, key_azimuth, key_elevation, vec3(1.0f, 0.95f, 0.88f), key_exposure);
}

Light default_rim(const Camera& camera) {
  return directional("rim", camera, rim_azimuth, rim_elevation, vec3(0.75f, 0.87f, 1.0f), rim_exposure);
}

float new_light_exposure(const Light& light, const SceneBounds& bounds) {
  float arriving = luminance(light.colour) * light.intensity;
  if (light.type != LightType::directional) {
    const float distance = float(glm::length(dvec3(light.position) - bounds.centre()));
    arriving *= shared::distance_falloff(int(light.falloff), distance, light.radius);
  }
  if (!(arriving > 0.0f)) return key_exposure;
  return std::log2(key_intensity * std::exp2(key_exposure) / arriving);
}

}  // namespace plinian
