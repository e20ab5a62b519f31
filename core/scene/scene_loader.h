// From a scene's description to the snapshot that renderers take: volumes are read or made, and what was left
// open (scale, camera, lights, exposures) is filled in. Everything assumed on the way is told, to be said
// aloud.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/scene/framing.h"
#include "core/scene/scene_description.h"
#include "core/scene/snapshot.h"

namespace plinian {

struct SceneLoadOptions {
  double vdb_time_limit_s = 0.0;             // [s] for reading one file; 0: grows with the file
  std::uint64_t vdb_memory_limit_bytes = 0;  // for reading one file; 0: grows with the file
  std::function<bool(double)> progress;      // called with a share in [0, 1]; returning false cancels
  int width = 512, height = 512;             // [pixels] where the scene gives no size
};

/// Thrown when `progress` returned false.
struct SceneLoadCancelled : std::runtime_error {
  SceneLoadCancelled() : std::runtime_error("cancelled") {}
};

struct LoadedScene {
  SceneSnapshot snapshot;             // without quality
  std::vector<std::string> notes;     // what was assumed or chosen, one line each
  std::vector<std::string> warnings;  // what was mended, one line each
  std::optional<int> seed;            // of the first procedural medium
};

/// The camera with everything that the description leaves open, for pictures of that size. Appends to the
/// notes of `told`. Throws std::runtime_error (one line).
Camera make_camera(const SceneDescription& scene, const SceneBounds& bounds, const ivec2& size,
                   LoadedScene& told);

/// A light of the scene, likewise. camera: around which the default lights stand.
Light make_light(const SceneDescription& scene, const LightDescription& description, const Camera& camera,
                 const SceneBounds& bounds, LoadedScene& told);

/// The sky of the scene [radiance].
vec3 ambient_of(const SceneDescription& scene);
vec3 background_of(const SceneDescription& scene);

/// Throws std::runtime_error (one line) for what cannot be read or used, SceneLoadCancelled.
LoadedScene load_scene(const SceneDescription& scene, const SceneLoadOptions& options = {});

}  // namespace plinian
