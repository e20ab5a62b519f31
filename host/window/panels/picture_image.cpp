// Polygons with a texture.
#include "host/window/panels/picture_image.h"

#include <cstdint>

#include "host/window/panels/overlay_text.h"

namespace plinian::window {

void add_image(unsigned texture, const PaneRect& place, const std::vector<vec2>& polygon, bool upside_down) {
  if (polygon.size() < 3) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const int corners = int(polygon.size());
  list->PushTextureID(ImTextureID(std::intptr_t(texture)));
  list->PrimReserve((corners - 2) * 3, corners);
  const auto first = ImDrawIdx(list->_VtxCurrentIdx);
  for (int i = 2; i < corners; ++i) {
    list->PrimWriteIdx(first);
    list->PrimWriteIdx(ImDrawIdx(first + i - 1));
    list->PrimWriteIdx(ImDrawIdx(first + i));
  }
  for (const vec2& corner : polygon) {
    vec2 share = (corner - place.begin) / place.size;
    if (upside_down) share.y = 1.0f - share.y;
    list->PrimWriteVtx(to_im(corner), to_im(share), 0xffffffff);
  }
  list->PopTextureID();
}

void add_image(unsigned texture, const PaneRect& place, const PaneRect& room, bool upside_down) {
  const PaneRect part = common(place, room);
  if (part.size.x <= 0.0f || part.size.y <= 0.0f) return;
  const vec2 end = part.begin + part.size;
  add_image(texture, place, {part.begin, {end.x, part.begin.y}, end, {part.begin.x, end.y}}, upside_down);
}

}  // namespace plinian::window
