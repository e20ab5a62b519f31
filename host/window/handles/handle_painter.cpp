// Thin lines on a soft dark edge, so that they are read on white ash as on a black sky.
#include "host/window/handles/handle_painter.h"

#include <imgui.h>

#include <cmath>

#include "host/window/panels/overlay_text.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

// sRGB 0xBBGGRR; the axes' are those of the overlay, brighter because these are to be taken hold of.
constexpr unsigned axis_colours[] = {0x5c5cf0, 0x6ed482, 0xf0a05a};
constexpr unsigned yellow = 0x40d8ff, grey_colour = 0x8c8c8c, centre_colour = 0xe0dcd8;

unsigned packed(unsigned colour, float alpha) {
  return colour | (unsigned(std::lround(255.0f * alpha)) << 24);
}

unsigned colour_of(Part part) {
  const int axis = axis_of(part);
  return axis < 0 ? centre_colour : axis_colours[axis];
}

void polyline(const std::vector<vec2>& points, unsigned colour, float width, bool closed = false) {
  std::vector<ImVec2> list;
  for (const vec2& point : points) list.push_back(to_im(point));
  ImGui::GetWindowDrawList()->AddPolyline(list.data(), int(list.size()), colour,
                                          closed ? ImDrawFlags_Closed : ImDrawFlags_None, scaled(width));
}

// Dear ImGui fills what runs with the clock, y running down; other outlines lose their soft edge.
void fill(std::vector<vec2> points, unsigned colour) {
  float twice_area = 0.0f;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec2 a = points[i], b = points[(i + 1) % points.size()];
    twice_area += a.x * b.y - b.x * a.y;
  }
  std::vector<ImVec2> list;
  for (const vec2& point : points) list.push_back(to_im(point));
  if (twice_area < 0.0f) list = {list.rbegin(), list.rend()};
  ImGui::GetWindowDrawList()->AddConvexPolyFilled(list.data(), int(list.size()), colour);
}

}  // namespace

void paint_handles(const std::vector<PartShape>& shapes, Part lit, const std::vector<bool>& grey,
                   bool is_held) {
  for (const PartShape& shape : shapes) {
    const bool is_lit = shape.part == lit, is_grey = grey.at(std::size_t(shape.part));
    const unsigned colour = is_grey ? grey_colour : is_lit ? yellow : colour_of(shape.part);
    float alpha = shape.strength * (is_grey ? 0.55f : is_held && !is_lit ? 0.3f : 0.95f);
    if (shape.part == Part::view && !is_lit) alpha *= 0.55f;
    const bool outlined = is_plane(shape.part) || shape.part == Part::centre;
    for (const auto& line : shape.hidden) polyline(line, packed(colour, alpha * 0.2f), 1.0f);
    for (const auto& line : shape.strokes) polyline(line, packed(0x000000, alpha * 0.3f), 3.4f);
    for (const auto& line : shape.strokes) polyline(line, packed(colour, alpha), is_lit ? 2.2f : 1.7f);
    if (shape.area.size() < 3) continue;
    if (!outlined) {
      polyline(shape.area, packed(0x000000, alpha * 0.3f), 2.0f, true);
      fill(shape.area, packed(colour, alpha));
      continue;
    }
    fill(shape.area, packed(colour, alpha * (is_lit ? 0.4f : 0.16f)));
    polyline(shape.area, packed(0x000000, alpha * 0.25f), 2.6f, true);
    polyline(shape.area, packed(colour, alpha * 0.85f), 1.2f, true);
  }
}

void paint_readout(vec2 mouse, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const vec2 at = mouse + vec2(scaled(16), scaled(14)), pad(scaled(6), scaled(3));
  ImGui::GetWindowDrawList()->AddRectFilled(to_im(at - pad), to_im(at + vec2(size.x, size.y) + pad),
                                            0xb0101010, scaled(3));
  draw_text(at, colour::text, text);
}

}  // namespace plinian::window
