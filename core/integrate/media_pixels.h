// Where in a picture media can be seen at all: elsewhere there is nothing to march.
#pragma once

#include "core/integrate/flat_scene.h"
#include "core/scene/camera.h"
#include "core/scene/pixel_box.h"

namespace plinian {

/// The pixels whose rays may meet the bounds of a medium, some more at the rim, within the picture; all of it
/// where a medium reaches the camera's plane.
PixelBox media_pixels(const FlatScene& flat, const Camera& camera, int width, int height);

}  // namespace plinian
