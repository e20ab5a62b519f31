// Controls of the view strip that say how the picture is shown: exposure, view transform, layer.
#pragma once

#include <imgui.h>

#include "host/window/studio.h"

namespace plinian::window {

/// Where there is no room for all controls of the strip in one row, lists do without their arrows and words
/// are shorter.
enum class Room { ample, scarce };

/// Of a list in the strip.
ImGuiComboFlags list_flags(Room room);
/// ... whose longest common word is that; ample: [points at a scale of 1]. Returns [points].
float list_width(Room room, float ample, const char* word);

/// Widths do not depend on what the controls say, so that nothing jumps. [points]
float exposure_width(Room room);
void show_exposure(Studio& studio, Room room);
float transform_width(Room room);
void show_view_transform(Studio& studio, Room room);
float layer_width(Room room);
void show_layer(Studio& studio, Room room);

}  // namespace plinian::window
