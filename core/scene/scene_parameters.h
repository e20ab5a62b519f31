// Every key of a scene, declared once: scene files, --set and the help listing derive from these tables.
#pragma once

#include <vector>

#include "core/scene/parameter.h"
#include "core/scene/scene_description.h"

namespace plinian {

const std::vector<Parameter<MediumDescription>>& medium_parameters();
const std::vector<Parameter<CameraDescription>>& camera_parameters();
const std::vector<Parameter<LightDescription>>& light_parameters();
/// Keys of the scene itself, beside `size`, `camera`, `lights` and the media.
const std::vector<Parameter<SceneDescription>>& scene_parameters();

}  // namespace plinian
