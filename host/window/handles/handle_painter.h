// Draws handles over the picture.
#pragma once

#include <string>
#include <vector>

#include "host/window/handles/handle_shape.h"

namespace plinian::window {

/// lit: the part under the mouse, or held. grey: whether a part cannot be moved, by its number. is_held: only
/// what is held is drawn at full strength. In the current window of the interface.
void paint_handles(const std::vector<PartShape>& shapes, Part lit, const std::vector<bool>& grey,
                   bool is_held);

/// What a drag has come to, beside the mouse.
void paint_readout(vec2 mouse, const std::string& text);

}  // namespace plinian::window
