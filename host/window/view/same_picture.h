// Whether two snapshots show the same, told without looking at voxels: volumes are compared by identity.
#pragma once

#include "core/scene/snapshot.h"

namespace plinian::window {

bool same_camera(const Camera& a, const Camera& b);

/// Names and what the light maps are made with count; equal snapshots give equal pictures.
bool same_picture(const SceneSnapshot& a, const SceneSnapshot& b);

}  // namespace plinian::window
