// From the mouse to the zoom.
#include "host/window/panels/zoom_hand.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <utility>

#include "host/window/panels/overlay_text.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

// Of its own pixels, whatever they have to be shrunk by to fit the pane.
std::string badge_text(const PicturePlaces& places) {
  return fmt::format("{:.0f} %", 100.0f * places.pixel_side);
}

vec2 badge_margin() {
  return {scaled(6), scaled(2)};
}

}  // namespace

bool ZoomHand::move(Studio& studio, const PicturePlaces& places, bool hovered) {
  PictureZoom& zoom = studio.viewpoint.zoom;
  const ImGuiIO& io = ImGui::GetIO();
  vec2 mouse(io.MousePos.x, io.MousePos.y);
  mouse += places.way_to_picture(mouse);
  const vec2 centre = zoom.centre();
  const float factor = zoom.factor();
  const bool is_free = hovered && studio.zoom_key_held && !studio.tools.is_dragging;
  if (!ImGui::IsMouseDown(0)) held_ = false;
  if (is_free && ImGui::IsMouseClicked(0)) {
    held_ = true;
    pressed_ = {io.MousePos.x, io.MousePos.y};
    centre_ = centre;
  }
  int steps = std::exchange(studio.zoom_steps, 0);
  if (is_free && !held_) {
    wheel_ += io.MouseWheel;
    const float whole = std::trunc(wheel_);
    wheel_ -= whole;
    steps += int(whole);
  } else {
    wheel_ = 0.0f;
  }
  if (steps != 0 && !held_ && !studio.tools.is_dragging)
    zoom.step(steps, hovered ? mouse : places.whole.begin + 0.5f * places.whole.size, places.whole);
  if (held_) zoom.pan(centre_, vec2(io.MousePos.x, io.MousePos.y) - pressed_, places.whole);
  if (held_ || (is_free && zoom.is_on()))
    ImGui::SetMouseCursor(held_ ? ImGuiMouseCursor_ResizeAll : ImGuiMouseCursor_Hand);
  if (factor == zoom.factor() && centre == zoom.centre()) return false;
  if (studio.trace.is_on())
    studio.trace.note(
        fmt::format("zoom {:.2g}x at {:.4f} {:.4f}", zoom.factor(), zoom.centre().x, zoom.centre().y));
  return true;
}

float zoom_badge_width(const PicturePlaces& places) {
  if (!places.is_magnified) return 0.0f;
  return ImGui::CalcTextSize(badge_text(places).c_str()).x + 2.0f * badge_margin().x + scaled(6);
}

void show_zoom_badge(Studio& studio, const PicturePlaces& places, const PaneRect& pane) {
  if (!places.is_magnified) return;
  const std::string text = badge_text(places);
  const vec2 margin = badge_margin();
  const ImVec2 room = ImGui::CalcTextSize(text.c_str());
  const vec2 begin = pane.begin + vec2(scaled(10), scaled(8)) - vec2(0.0f, margin.y),
             size = vec2(room.x, room.y) + 2.0f * margin;
  ImGui::SetNextWindowPos(to_im(begin));
  ImGui::SetNextWindowSize(to_im(size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  ImGui::Begin("##zoom", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar(3);
  if (ImGui::InvisibleButton("##whole", to_im(size))) studio.viewpoint.zoom = {};
  const bool hovered = ImGui::IsItemHovered();
  note_item(studio.trace, "zoom badge");
  help(fmt::format("The picture is magnified: each of its pixels is {:.2g} of the screen wide. ",
                   places.pixel_side) +
       "Click to see all of it (" + text_of(studio.hotkeys.chord(Action::zoom_whole)) + "). With " +
       text_of(studio.hotkeys.chord(Action::zoom_hand)) +
       " held the wheel magnifies and a drag pans. The camera stays.");
  ImGui::GetWindowDrawList()->AddRectFilled(to_im(begin), to_im(begin + size),
                                            hovered ? colour::accent : 0xd0202020u, scaled(3));
  draw_text(begin + margin, hovered ? colour::text : colour::changed, text);
  ImGui::End();
}

}  // namespace plinian::window
