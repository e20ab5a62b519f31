// One medium of a scene, from its description: read from a file, made, or analytic, and placed in the world.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/media/medium.h"
#include "core/scene/scene_loader.h"

namespace plinian {

/// Appends to notes and warnings of `told`. Throws std::runtime_error (one line), SceneLoadCancelled.
Medium load_medium(const MediumDescription& description, const SceneLoadOptions& options, LoadedScene& told);

}  // namespace plinian
