// A scene as a person writes it: what is given, with everything else left open. scene_loader.h makes a
// snapshot of it, filling in what is open. Leaves out files and JSON (scene_file.h).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/lights/light.h"
#include "core/media/density_scale.h"
#include "core/media/vdb_reader.h"
#include "core/scene/camera.h"

namespace plinian {

enum class UpAxis { y, z };

struct MediumDescription {
  std::string name;    // empty: "medium", or "medium1", ... where there are several
  std::string volume;  // a .vdb file, a procedural medium, "box" or "sphere"
  std::string folder;  // what a relative file name is relative to; empty: the current folder

  std::optional<std::string> grid;              // of the file: name, name[index] or name[*]
  std::optional<std::string> temperature_grid;  // of the file; empty text: none
  std::optional<LevelSetMode> level_set;        // of the file
  std::optional<FrustumMode> frustum;           // of the file
  std::optional<int> resolution;                // [voxels] of a procedural medium's longest side
  std::optional<int> seed;                      // of a procedural medium
  std::map<std::string, float> shape;           // shape parameters of a procedural medium, by name
  std::optional<UpAxis> up_axis;                // of the file
  std::optional<float> file_unit;               // [world units per unit of the file] > 0
  std::optional<Keep> rescale;                  // what stays where scale or file_unit resizes a volume

  std::optional<dvec3> translate;  // [world]
  std::optional<dvec3> rotate;     // [degrees] about x, then y, then z
  std::optional<dvec3> scale;      // [-]

  std::optional<float> density_scale;       // [1 / unit of the file]
  std::optional<vec3> albedo, extinction;   // [-], [1/world unit at density * density_scale = 1]
  std::optional<vec3> sigma_s, sigma_a;     // [1/world unit], instead of albedo and extinction
  std::optional<PhaseKind> phase;           // not given: isotropic, or Henyey-Greenstein where g is given
  std::optional<float> g, g_back, blend;    // [-]
  std::optional<float> emission_scale;      // as in Emission
  std::optional<float> emission_exposure;   // [stops]
  std::optional<float> temperature_scale;   // [K per unit of the file]
  std::optional<float> temperature_offset;  // [K]

  bool guess_orientation = false;  // what up_axis and file_unit leave open is guessed from the file; else the
                                   // file's space is the world's
};

struct CameraDescription {
  std::optional<dvec3> eye, target, up;    // [world]
  std::optional<dvec3> translate, rotate;  // [world], [degrees], as in Maya, instead of eye and target
  std::optional<float> fov_y_degrees;      // vertical, for pictures of any shape
  std::optional<float> focal_length;       // [mm] instead of fov_y_degrees
  std::optional<vec2> film_back;           // [mm]
  std::optional<FilmFit> film_fit;
  std::optional<vec2> film_offset;          // [mm]
  std::optional<float> pixel_aspect;        // [-]
  std::optional<float> near_clip;           // [world]
  std::optional<float> azimuth, elevation;  // [degrees] from where a camera without eye looks
};

/// Who fills in what a light leaves open.
enum class LightRole {
  placed,  // the scene's own light
  key,     // the default lights
  rim,
};

struct LightDescription {
  std::string name;
  LightRole role = LightRole::placed;
  LightType type = LightType::directional;
  std::optional<dvec3> toward, position, target;  // [-], [world], [world]
  std::optional<vec3> colour;                     // [-] linear Rec.709
  std::optional<float> kelvin;                    // [K] instead of colour
  std::optional<float> intensity;                 // irradiance, at r = 1 for spot and point
  std::optional<vec3> irradiance;                 // intensity and colour in one
  std::optional<float> exposure;                  // [stops]
  std::optional<Falloff> falloff;
  std::optional<float> radius;                // [world]
  std::optional<float> cone_angle, penumbra;  // [degrees]
};

struct SceneDescription {
  std::string file;  // where it was read; empty: no file
  std::vector<MediumDescription> media;
  CameraDescription camera;
  std::vector<LightDescription> lights;
  std::optional<vec3> ambient, background;  // [radiance]; not given: as default_lights says, else none
  std::optional<ivec2> size;                // [pixels]
  bool default_lights = false;              // the lights are the default ones: key and rim
};

}  // namespace plinian
