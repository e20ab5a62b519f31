// Text on the picture, and vectors as Dear ImGui has them.
#pragma once

#include <imgui.h>

#include <string>

#include "core/shared/glue.h"

namespace plinian::window {

inline ImVec2 to_im(vec2 v) {
  return {v.x, v.y};
}

/// Text in the current window, readable on white as on black. colour: as theme.h packs them.
inline void draw_text(vec2 at, unsigned colour, const std::string& text) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddText({at.x + 1.0f, at.y + 1.0f}, 0xc0000000, text.c_str());
  list->AddText(to_im(at), colour, text.c_str());
}

}  // namespace plinian::window
