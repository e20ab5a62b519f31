// Panes, number fields, toggles.
#include "host/window/panels/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/shared/view_curve.h"
#include "host/window/panels/typing.h"
#include "host/window/platform/theme.h"
#include "host/window/platform/trace.h"

namespace plinian::window {

namespace {

// Of the one field that is dragged or typed into.
struct {
  ImGuiID dragged = 0, typed = 0;
  bool moved = false, focus = false;
  double anchor_value = 0.0, last_value = 0.0;
  float anchor_x = 0.0f;  // [points]
  DragPace pace = DragPace::usual;
  char text[256] = "";
  // Where Tab goes on: to that field, or to the next one in that window; in the picture after.
  ImGuiID wanted = 0, before = 0;  // before: the last field that was shown and is not typed into
  const ImGuiWindow* next_in = nullptr;
  int asked = -2;        // picture in which Tab was pressed
  bool is_next = false;  // the next one that is shown takes the keys
} field;

void begin_typing(ImGuiID id, double value) {
  field.typed = id;
  field.focus = true;
  expect_typing();
  const std::string text = shown_number(value);
  std::snprintf(field.text, sizeof field.text, "%s", text.c_str());
}

DragPace pace_now() {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyCtrl ? DragPace::fine : io.KeyShift ? DragPace::coarse : DragPace::usual;
}

void draw_field(ImVec2 begin, ImVec2 end, double value, const NumberRange& range, const FieldLook& look,
                bool hot) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImGuiStyle& style = ImGui::GetStyle();
  list->AddRectFilled(begin, end, ImGui::GetColorU32(hot ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                      style.FrameRounding);
  if (const auto share = share_of(range, value); share && *share > 0.0f) {
    list->PushClipRect(begin, {begin.x + (end.x - begin.x) * *share, end.y}, true);
    list->AddRectFilled(begin, end, (colour::accent & 0x00ffffff) | 0x2c000000, style.FrameRounding);
    list->PopClipRect();
  }
  const float middle = std::round((begin.y + end.y - ImGui::GetTextLineHeight()) / 2);
  const unsigned faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  float right = end.x - style.FramePadding.x, left = begin.x + style.FramePadding.x;
  list->PushClipRect(begin, end, true);
  if (!look.prefix.empty()) {
    list->AddText({left, middle}, faint, look.prefix.c_str());
    left += ImGui::CalcTextSize(look.prefix.c_str()).x + scaled(4);
  }
  if (!look.unit.empty()) {
    const float width = ImGui::CalcTextSize(look.unit.c_str()).x;
    list->AddText({right - width, middle}, faint, look.unit.c_str());
    right -= width + scaled(4);
  }
  // Fewer digits rather than some of them: a number without its beginning is another one.
  std::string number = shown_number(value);
  for (int digits = 5; digits > 1 && ImGui::CalcTextSize(number.c_str()).x > right - left; --digits)
    number = shown_number(value, digits);
  const unsigned ink = look.driven     ? ImGui::GetColorU32(ImVec4(0.55f, 0.80f, 0.62f, 1.0f))
                       : !look.enabled ? faint
                       : look.changed  ? ImGui::GetColorU32(ImVec4(1.0f, 0.97f, 0.92f, 1.0f))
                                       : ImGui::GetColorU32(ImGuiCol_Text);
  list->AddText({right - ImGui::CalcTextSize(number.c_str()).x, middle}, ink, number.c_str());
  list->PopClipRect();
}

}  // namespace

void begin_pane(const char* id, const PaneRect& pane, bool scrolls) {
  ImGui::SetNextWindowPos({pane.begin.x, pane.begin.y});
  ImGui::SetNextWindowSize({pane.size.x, pane.size.y});
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   (scrolls ? 0 : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse));
}

void end_pane() {
  ImGui::End();
}

void heading(const std::string& text) {
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

FieldEdit number_field(const char* id, double value, const NumberRange& range, const FieldLook& look) {
  FieldEdit edit;
  const ImGuiID self = ImGui::GetID(id);
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  const ImVec2 size(std::max(look.width, scaled(16)), ImGui::GetFrameHeight());
  if (look.enabled) {
    if (field.asked < ImGui::GetFrameCount() - 1) field.wanted = 0, field.next_in = nullptr;
    if (std::exchange(field.is_next, false) || field.wanted == self ||
        (field.next_in && field.next_in == ImGui::GetCurrentWindow()->RootWindow)) {
      field.wanted = 0;
      field.next_in = nullptr;
      begin_typing(self, value);
    }
    if (field.typed != self) field.before = self;
  }
  if (field.typed == self) {
    ImGui::SetNextItemWidth(size.x);
    if (field.focus) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputText(id, field.text, sizeof field.text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    // Tab takes over what was typed and goes on to the next number, or back.
    if (!field.focus && ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab))) {
      ImGui::ClearActiveID();
      edit.typed = field.text;
      field.typed = 0;
      if (ImGui::GetIO().KeyShift)
        field.wanted = field.before;
      else
        field.next_in = ImGui::GetCurrentWindow()->RootWindow;
      field.asked = ImGui::GetFrameCount();
      expect_typing();
      return edit;
    }
    const bool left = !field.focus && !entered && ImGui::IsItemDeactivated();
    const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    field.focus = false;
    if (entered || (left && !escaped)) edit.typed = field.text;
    if (entered || left) field.typed = 0;
    return edit;
  }
  ImGui::InvisibleButton(id, size);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && look.enabled) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  const float x = ImGui::GetIO().MousePos.x;
  const float scale = scaled(100) / 100.0f;
  if (ImGui::IsItemActivated() && look.enabled) {
    field.dragged = self;
    field.moved = false;
    field.anchor_value = field.last_value = value;
    field.anchor_x = x;
    field.pace = pace_now();
  }
  if (field.dragged == self && ImGui::IsItemActive()) {
    if (!field.moved && std::abs(x - field.anchor_x) >= 3.0f * scale) {
      field.moved = edit.begun = true;
      field.anchor_x = x;
    }
    if (field.moved) {
      if (pace_now() != field.pace) {  // the value stays, only the pace is another one from here on
        field.pace = pace_now();
        field.anchor_value = field.last_value;
        field.anchor_x = x;
      }
      const double now = dragged(range, field.anchor_value, (x - field.anchor_x) / scale, field.pace);
      if (now != field.last_value && x != field.anchor_x) {
        field.last_value = now;
        edit.dragged = now;
      }
    }
  }
  if (field.dragged == self && ImGui::IsItemDeactivated()) {
    field.dragged = 0;
    edit.ended = field.moved;
    if (!field.moved && hovered) {
      begin_typing(self, value);
    }
  }
  draw_field(begin, {begin.x + size.x, begin.y + size.y}, value, range, look,
             look.enabled && (hovered || field.dragged == self));
  return edit;
}

std::optional<std::string> text_field(const char* id, const std::string& text, float width, bool enabled,
                                      const char* hint) {
  static ImGuiID edited = 0;
  static char buffer[4096];
  const ImGuiID self = ImGui::GetID(id);
  char shown[4096];
  std::snprintf(shown, sizeof shown, "%s", text.c_str());
  ImGui::SetNextItemWidth(width);
  if (enabled && std::exchange(field.is_next, false)) {
    ImGui::SetKeyboardFocusHere();
    expect_typing();
  }
  const bool mine = edited == self;
  const bool entered = ImGui::InputTextWithHint(
      id, hint, mine ? buffer : shown, sizeof shown,
      ImGuiInputTextFlags_EnterReturnsTrue | (enabled ? 0 : ImGuiInputTextFlags_ReadOnly));
  if (!mine && ImGui::IsItemActive()) {
    edited = self;
    std::memcpy(buffer, shown, sizeof buffer);
  }
  if (!mine || !(entered || ImGui::IsItemDeactivated())) return std::nullopt;
  edited = 0;
  return enabled && text != buffer ? std::optional<std::string>(buffer) : std::nullopt;
}

void want_typing(bool wanted) {
  field.is_next = wanted;
}

float button_width(const char* label) {
  return ImGui::CalcTextSize(label, nullptr, true).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

bool toggle(const char* label, bool on, const char* text, float width) {
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_Header));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetColorU32(ImGuiCol_HeaderActive));
  }
  const bool pressed = ImGui::Button(label, {width, 0.0f});
  if (on) ImGui::PopStyleColor(2);
  help(text);
  return pressed;
}

bool list_row(const char* id, bool chosen, float height) {
  if (chosen) ImGui::PushStyleColor(ImGuiCol_HeaderHovered, ImGui::GetColorU32(ImGuiCol_HeaderActive));
  const bool clicked = ImGui::Selectable(
      id, chosen, ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups,
      {0.0f, height});
  if (chosen) ImGui::PopStyleColor();
  return clicked;
}

void note_item(Trace& trace, const std::string& name) {
  const ImVec2 begin = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  trace.item(name, vec2(begin.x, begin.y), vec2(size.x, size.y));
}

void help(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsMouseDown(0))
    return;
  if (GImGui->HoveredIdTimer < 0.5f) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(340));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool show_changed_dot(float width, const std::string& what) {
  const bool clicked = ImGui::InvisibleButton("reset", {width, ImGui::GetFrameHeight()});
  const ImVec2 begin = ImGui::GetItemRectMin();
  ImGui::GetWindowDrawList()->AddCircleFilled({begin.x + width / 2, begin.y + ImGui::GetFrameHeight() / 2},
                                              scaled(ImGui::IsItemHovered() ? 5 : 3), colour::changed, 12);
  help(what);
  return clicked;
}

vec3 display_colour(const vec3& linear) {
  vec3 colour;
  for (int i = 0; i < 3; ++i) colour[i] = shared::srgb_from_linear(std::clamp(linear[i], 0.0f, 1.0f));
  return colour;
}

}  // namespace plinian::window
