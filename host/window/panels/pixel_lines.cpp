// From the pointer to lines of text.
#include "host/window/panels/pixel_lines.h"

#include <imgui.h>

#include <algorithm>

#include "core/scene/nearest_word.h"
#include "host/window/compare/pixel_readout.h"
#include "host/window/panels/fitted.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/panels/snapshot_strip.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

float row() {
  return ImGui::GetTextLineHeight() + scaled(3);
}

// Around the pixel, where one could not tell which it is.
void draw_pixel(const PaneRect& place, const PaneRect& room, ivec2 pixels, vec2 at) {
  const vec2 side = place.size / vec2(pixels);
  const vec2 begin = place.begin + glm::floor(at * vec2(pixels)) * side;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(to_im(room.begin), to_im(room.begin + room.size), true);
  list->AddRect(to_im(begin - 1.0f), to_im(begin + side + 1.0f), 0xc0000000);
  list->AddRect(to_im(begin), to_im(begin + side), 0xd0ffffff);
  list->PopClipRect();
}

}  // namespace

float PixelLines::more_height(const Studio& studio) {
  const bool compares = studio.comparison.mode() != CompareMode::off;
  // A click on a snapshot compares, and the next one ends that: it must not move away between them.
  return compares || snapshot_strip_height(studio) > 0.0f ? 2.0f * row() : 0.0f;
}

void PixelLines::show(Studio& studio, const DevelopedPtr& shown, const PicturePlaces& places,
                      const PaneRect& picture, const PaneRect& pane, bool hovered) {
  if (!shown || !hovered) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const vec2 way = places.way_to_picture({mouse.x, mouse.y}), at = vec2(mouse.x, mouse.y) + way;
  if (!holds(places.room, at)) return;
  const auto share = [](vec2 point, const PaneRect& place) { return (point - place.begin) / place.size; };
  const bool compares = studio.comparison.mode() != CompareMode::off;
  const ViewPicturePtr other = compares ? studio.comparison.other : nullptr;
  std::optional<vec2> other_at;
  PaneRect other_place;
  if (other) {
    other_place = fitted(places.other, vec2(other->frame.width, other->frame.height));
    other_at = share(at + places.other.begin - places.picture.begin, other_place);
  }
  const vec2 picture_at = share(at, picture);
  const auto readout = read_pixel(*shown, studio.development, picture_at, other_at, studio.comparison.name);
  if (!readout) return;
  if (places.shows_squares) {
    draw_pixel(picture, places.room, {shown->width, shown->height}, picture_at);
    if (readout->other && places.other.begin != places.picture.begin)
      draw_pixel(other_place, places.other_room, {other->frame.width, other->frame.height}, *other_at);
  }
  ImGui::PushFont(fonts().fixed);
  const float columns = (pane.size.x - scaled(20)) / ImGui::CalcTextSize("0").x;
  const std::vector<std::string> lines = readout_lines(*readout, std::size_t(std::max(columns, 1.0f)));
  float width = 0.0f;
  for (const std::string& line : lines) width = std::max(width, ImGui::CalcTextSize(line.c_str()).x);
  const float height = ImGui::GetTextLineHeight();
  vec2 begin =
      pane.begin + vec2(scaled(10), pane.size.y - height - scaled(8) - float(lines.size() - 1) * row());
  const vec2 margin(scaled(4), scaled(3)), size(width, float(lines.size() - 1) * row() + height);
  ImGui::GetWindowDrawList()->AddRectFilled(to_im(begin - margin), to_im(begin + size + margin), 0xa0000000,
                                            scaled(3));
  for (const std::string& line : lines) {
    draw_text(begin, colour::text, line);
    begin.y += row();
  }
  ImGui::PopFont();
  if (!studio.trace.is_on()) return;
  if (const std::string text = join(readout_lines(*readout), " | "); text != told_) {
    told_ = text;
    studio.trace.note("pixel " + text);
  }
}

}  // namespace plinian::window
