// The camera of a picture as OpenGL takes it, and the picture's depth beside it.
#pragma once

#include <vector>

#include "core/scene/camera.h"
#include "core/scene/frame.h"
#include "core/scene/framing.h"
#include "core/scene/snapshot.h"

namespace plinian::window {

struct ViewMatrices {
  dmat4 view_from_world{1.0};  // looks along -z, +y up
  dmat4 clip_from_view{1.0};   // perspective with no far plane: depth 1 - near_depth / depth along the axis
  double near_depth = 0.01;    // [world] along the axis; what is nearer is cut off
};

/// Of the picture that shows a scene, and how far its media reach. The near plane stands at a thousandth of
/// the way to the media, so that floats of depth tell apart what is 1e-4 of its distance apart there.
ViewMatrices view_matrices(const SceneSnapshot& scene, const SceneBounds& bounds);

/// What a depth buffer of size [pixels] holds where the media of a picture stand (the bottom row first): 1
/// where there is nothing. Biased: a medium is taken for a wall where alpha passes 0.5.
std::vector<float> depth_buffer_of(const Frame& frame, const SceneSnapshot& scene,
                                   const ViewMatrices& matrices, ivec2 size);

}  // namespace plinian::window
