// Text on the picture, and vectors as Dear ImGui has them.
#pragma once

#include <imgui.h>

#include <string>

#include "core/shared/glue.h"

namespace plinian::window {

inline ImVec2 to_im(vec2 v) {
  return {v.x, v.y};
}

/// Text in the current window, readable on white, grey and black. colour: as theme.h packs them.
inline void draw_text(vec2 at, unsigned colour, const std::string& text) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const vec2 way : {vec2(1, 0), vec2(-1, 0), vec2(0, -1), vec2(0, 1), vec2(1, 1)})
    list->AddText(to_im(at + way), 0x90000000, text.c_str());
  list->AddText(to_im(at), colour, text.c_str());
}

}  // namespace plinian::window
