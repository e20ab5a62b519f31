// Scenes from JSON files, and edits of a scene from the command line.
//
//   { "volume": "smoke.vdb", "density_scale": 4, "albedo": [0.8, 0.8, 0.8],
//     "camera": {"eye": [52, 62, 172], "target": [0, 40, 0], "fov_y_degrees": 36},
//     "lights": [{"type": "directional", "toward": [0.8, 0.45, 0.25], "irradiance": [12, 12, 12]}],
//     "size": [512, 512] }
//
// The keys are those of scene_parameters.h. Several media stand in "media": [{...}, ...]; a single one may
// stand in the scene itself. File names are relative to the scene file. Keys that begin with `_` are
// comments. What is left out is filled in when the scene is loaded (scene_loader.h).
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene_description.h"

namespace plinian {

/// Reads a scene file. Throws std::runtime_error with one line, "FILE: lights[0].irradiance: expected 3
/// numbers >= 0, got ...": unknown key, wrong type, out of range, keys that exclude each other, names taken.
SceneDescription read_scene_file(const std::string& path);

/// The scene that an input of the command line stands for: a .json scene; else one medium (a .vdb file, a
/// procedural medium, box or sphere) under the default camera and lights.
SceneDescription describe_input(const std::string& input);

/// Sets one value, as --set does: "camera.focal_length", "medium.albedo" (every medium), "NAME.KEY" for the
/// medium or light of that name, "lights.exposure" (every light), "ambient", "background", "size".
/// where: what errors begin with; empty: "--set NAME".
/// Throws std::runtime_error, naming the nearest known name: no such object or key, wrong type, out of range.
void set_scene_value(SceneDescription& scene, const std::string& name, const std::string& value,
                     const std::string& where = "");

/// The names that set_scene_value takes before the dot.
std::vector<std::string> scene_object_names(const SceneDescription& scene);

/// Analytic media by name.
inline const std::vector<std::string> analytic_media = {"box", "sphere"};

}  // namespace plinian
