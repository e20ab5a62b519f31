// Snapshots from descriptions.
#include "core/scene/scene_loader.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "core/media/blackbody.h"
#include "core/scene/default_lights.h"
#include "core/scene/framing.h"
#include "core/scene/medium_loader.h"
#include "core/scene/placement.h"

namespace plinian {

namespace {

// "scene.json: light0.toward", the start of an error about a light.
std::string where(const SceneDescription& scene, const std::string& object, const char* key) {
  return (scene.file.empty() ? "" : scene.file + ": ") + object + "." + key;
}

Camera make_lens(const CameraDescription& d) {
  Camera camera;
  if (d.film_back) camera.film_back = *d.film_back;
  if (d.film_fit) camera.fit = *d.film_fit;
  if (d.film_offset) camera.film_offset = *d.film_offset;
  if (d.pixel_aspect) camera.pixel_aspect = *d.pixel_aspect;
  if (d.near_clip) camera.near_clip = *d.near_clip;
  if (d.focal_length) camera.focal_length = *d.focal_length;
  if (d.fov_y_degrees) {
    camera.fit = FilmFit::vertical;
    camera.focal_length =
        float(0.5 * camera.film_back.y / std::tan(glm::radians(double(*d.fov_y_degrees)) / 2.0));
  }
  return camera;
}

}  // namespace

Camera make_camera(const SceneDescription& scene, const SceneBounds& bounds, const ivec2& size,
                   LoadedScene& told) {
  const CameraDescription& d = scene.camera;
  Camera camera = make_lens(d);
  if (d.eye) {
    const dvec3 target = d.target.value_or(bounds.centre());
    if (*d.eye == target)
      throw std::runtime_error(where(scene, "camera", "eye") +
                               ": is where the camera looks; move it away from its target");
    camera.world_from_camera = look_at(*d.eye, target, d.up.value_or(dvec3(0, 1, 0)), 40.0).world_from_camera;
  } else if (d.translate || d.rotate) {
    camera.world_from_camera = rotation_xyz(d.rotate.value_or(dvec3(0.0)));
    camera.world_from_camera[3] = dvec4(d.translate.value_or(dvec3(0.0)), 1.0);
  } else {
    if (d.target)
      throw std::runtime_error(
          where(scene, "camera", "target") +
          ": needs camera.eye, where it looks from; without both the camera is placed to "
          "show everything, from camera.azimuth and camera.elevation");
    const double azimuth = d.azimuth.value_or(float(default_azimuth));
    const double elevation = d.elevation ? double(*d.elevation) : default_elevation(bounds);
    camera = frame_bounds(camera, bounds, azimuth, elevation, size.x, size.y);
    told.notes.push_back(
        fmt::format("camera: placed to show everything, azimuth {:.0f}, elevation {:.0f}, {:.3g} m away from "
                    "media of {}",
                    azimuth, elevation, length(dvec3(camera.world_from_camera[3]) - bounds.centre()),
                    extent_text(bounds)));
  }
  return camera;
}

namespace {

vec3 direction(const SceneDescription& scene, const std::string& light, const char* key,
               const dvec3& vector) {
  const double size = length(vector);
  if (!(size > 0.0)) throw std::runtime_error(where(scene, light, key) + ": has no length, so no direction");
  return vec3(vector / size);
}

}  // namespace

Light make_light(const SceneDescription& scene, const LightDescription& d, const Camera& camera,
                 const SceneBounds& bounds, LoadedScene& told) {
  Light light;
  if (d.role == LightRole::key) light = default_key(camera);
  if (d.role == LightRole::rim) light = default_rim(camera);
  light.name = d.name;
  light.type = d.type;
  if (d.type != LightType::directional) {
    if (!d.position)
      throw std::runtime_error(where(scene, d.name, "position") + ": a spot or point light needs one");
    light.position = vec3(*d.position);
  }
  if (d.toward)
    light.toward = direction(scene, d.name, "toward", *d.toward);
  else if (d.type == LightType::spot)
    light.toward = direction(scene, d.name, "target", *d.position - d.target.value_or(bounds.centre()));
  else if (d.type == LightType::directional && d.role == LightRole::placed)
    throw std::runtime_error(where(scene, d.name, "toward") +
                             ": a directional light needs one, pointing to the light");

  if (d.colour) light.colour = *d.colour;
  if (d.kelvin) light.colour = planck_colour(*d.kelvin);
  if (d.intensity) light.intensity = *d.intensity;
  if (d.irradiance) {
    light.intensity = std::max({d.irradiance->x, d.irradiance->y, d.irradiance->z});
    light.colour = light.intensity > 0.0f ? *d.irradiance / light.intensity : vec3(1.0f);
    light.exposure = 0.0f;
  }
  if (d.falloff) light.falloff = *d.falloff;
  if (d.radius) light.radius = *d.radius;
  if (d.cone_angle) light.cone_angle = *d.cone_angle;
  if (d.penumbra) light.penumbra = *d.penumbra;
  if (d.exposure) {
    light.exposure = *d.exposure;
  } else if ((d.role == LightRole::placed || d.type != LightType::directional) && !d.intensity &&
             !d.irradiance) {
    light.exposure = new_light_exposure(light, bounds);
    told.notes.push_back(
        fmt::format("{}: exposure {:.2f}, which lights the middle of the media as the default key would",
                    d.name, light.exposure));
  }
  return light;
}

vec3 ambient_of(const SceneDescription& scene) {
  return scene.ambient.value_or(scene.default_lights ? default_ambient : vec3(0.0f));
}

vec3 background_of(const SceneDescription& scene) {
  return scene.background.value_or(scene.default_lights ? default_background : vec3(0.0f));
}

LoadedScene load_scene(const SceneDescription& scene, const SceneLoadOptions& options) {
  LoadedScene loaded;
  SceneSnapshot& snapshot = loaded.snapshot;
  const ivec2 size = scene.size.value_or(ivec2(options.width, options.height));
  snapshot.width = size.x;
  snapshot.height = size.y;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    SceneLoadOptions share = options;
    if (options.progress)
      share.progress = [&, i](double part) {
        return options.progress((double(i) + part) / double(scene.media.size()));
      };
    snapshot.media.push_back(load_medium(scene.media[i], share, loaded));
  }
  const SceneBounds bounds = scene_bounds(snapshot.media);
  snapshot.camera = make_camera(scene, bounds, size, loaded);
  for (const LightDescription& light : scene.lights)
    snapshot.lights.push_back(make_light(scene, light, snapshot.camera, bounds, loaded));
  snapshot.ambient = ambient_of(scene);
  snapshot.background = background_of(scene);
  return loaded;
}

}  // namespace plinian
