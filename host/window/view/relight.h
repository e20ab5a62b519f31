// A picture under lights of another brightness or colour, made of its layers: light adds up, so nothing need
// be rendered again.
#pragma once

#include <optional>

#include "core/scene/frame.h"
#include "core/scene/snapshot.h"

namespace plinian::window {

/// The frame of `wanted`, made of a frame of `scene`. None where they differ in more than the power of lights
/// and the colour of the sky's light, or where a channel that was dark is to shine.
std::optional<Frame> relit(const Frame& frame, const SceneSnapshot& scene, const SceneSnapshot& wanted);

}  // namespace plinian::window
