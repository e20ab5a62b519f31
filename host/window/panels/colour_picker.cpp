// A square of saturation and value, a bar of hues, and numbers.
#include "host/window/panels/colour_picker.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/shared/view_curve.h"
#include "host/graph/values/value_text.h"
#include "host/window/fields/arithmetic.h"
#include "host/window/fields/edit_lines.h"
#include "host/window/handles/drag_ends.h"
#include "host/window/panels/beside.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/desktop.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

constexpr const char* popup = "picker";

unsigned packed(const vec3& linear) {
  const vec3 shown = display_colour(linear);
  return ImGui::ColorConvertFloat4ToU32({shown.x, shown.y, shown.z, 1.0f});
}

// As short as an eye needs it, so that the command reads well.
float rounded(float linear) {
  const double grain = linear > 1.0f ? std::pow(10.0, std::floor(std::log10(double(linear))) - 4.0) : 1e-4;
  return float(std::round(double(linear) / grain) * grain);
}

vec2 mouse_in(ImVec2 begin, ImVec2 size) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  return glm::clamp(vec2((at.x - begin.x) / size.x, (at.y - begin.y) / size.y), 0.0f, 1.0f);
}

// White above, dark outside: seen on any colour.
void draw_ring(ImDrawList& list, ImVec2 at) {
  list.AddCircle(at, scaled(5), 0xff000000, 16, scaled(2.5f));
  list.AddCircle(at, scaled(5), 0xffffffff, 16, scaled(1.2f));
}

NumberRange range_of_hue() {
  NumberRange range;
  range.soft_minimum = 0.0;
  range.soft_maximum = 360.0;
  range.wraps = true;
  return range;
}

NumberRange range_from_zero(std::optional<double> maximum) {
  NumberRange range;
  range.minimum = range.soft_minimum = 0.0;
  range.maximum = maximum;
  range.soft_maximum = maximum.value_or(1.0);
  return range;
}

}  // namespace

void ColourPicker::show(Studio& studio, const ColourField& field) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ImGui::GetFrameHeight();
  const vec3 shown = display_colour(field.linear);
  const bool clicked = ImGui::ColorButton(
      "##swatch", {shown.x, shown.y, shown.z, 1.0f},
      ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoDragDrop,
      {side, side});
  note_item(studio.trace, field.name + " swatch");
  // A dark colour would be lost in the pane.
  ImGui::GetWindowDrawList()->AddRect(at, {at.x + side, at.y + side}, 0x50ffffff,
                                      ImGui::GetStyle().FrameRounding);
  constexpr float worth_telling = 1.1f;  // of a colour of luminance 1 a channel is a little over 1
  const bool clipped = std::max({field.linear.x, field.linear.y, field.linear.z}) > worth_telling;
  if (clipped) {  // a corner says so
    const float right = at.x + side - 1.0f, top = at.y + 1.0f, size = std::round(side * 0.4f);
    ImGui::GetWindowDrawList()->AddTriangleFilled({right, top}, {right, top + size}, {right - size, top},
                                                  0xff303030);
  }
  help(!field.enabled ? field.help
                      : std::string("Chooses the colour. It is shown sRGB-encoded") +
                            (clipped ? ", up to 1: it is brighter than a display shows." : "."));
  if (clicked && field.enabled && open_.empty()) {
    open(studio, field);
    row_ = at.y;
  }
  if (open_ != field.name) return;
  const ImVec2 room = ImGui::GetMainViewport()->Size;
  const vec2 corner = beside({pane_begin_, pane_size_}, row_, size_, vec2(room.x, room.y), scaled(6));
  ImGui::SetNextWindowPos({std::round(corner.x), std::round(corner.y)});
  if (!ImGui::BeginPopup(popup, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_AlwaysAutoResize))
    return close(studio, ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)));
  follow(field);
  ImGui::TextDisabled("%s", field.name.c_str());
  show_hand(studio, field);
  show_numbers(studio, field);
  show_before(studio, field);
  // Where it has room is known once it was laid out: then it is drawn again.
  const vec2 size(ImGui::GetWindowSize().x, ImGui::GetWindowSize().y);
  if (std::exchange(size_, size) != size) Desktop::wake();
  if (!ImGui::IsWindowAppearing())
    studio.trace.item("picker", vec2(ImGui::GetWindowPos().x, ImGui::GetWindowPos().y), size_);
  ImGui::EndPopup();
}

void ColourPicker::open(Studio& studio, const ColourField& field) {
  ImGui::OpenPopup(popup);
  open_ = field.name;
  pane_begin_ = vec2(ImGui::GetWindowPos().x, ImGui::GetWindowPos().y);
  pane_size_ = vec2(ImGui::GetWindowSize().x, ImGui::GetWindowSize().y);
  before_ = seen_ = sent_ = field.linear;
  hsv_ = hsv_of(field.linear, hsv_);
  brightest_ = std::max(1.0f, hsv_.value);
  merge_key_ = studio.commands.new_merge_key("colour");
  steps_ = studio.session().history().steps_made();
}

void ColourPicker::close(Studio& studio, bool takes_back) {
  open_.clear();
  if (takes_back) take_back(studio, steps_);
  studio.commands.end_drag();
}

// What was made of hue, saturation and value keeps them; what came from elsewhere has its own.
void ColourPicker::follow(const ColourField& field) {
  if (field.linear == seen_) return;
  seen_ = field.linear;
  if (seen_ != sent_) hsv_ = hsv_of(seen_, hsv_);
  brightest_ = std::max(brightest_, hsv_.value);
}

void ColourPicker::send(Studio& studio, const ColourField& field, const vec3& linear) {
  const std::string words = graph::write_number(linear.x) + " " + graph::write_number(linear.y) + " " +
                            graph::write_number(linear.z);
  for (const std::string& line : set_lines(studio.session().graph(), field.plug, words))
    studio.run(line, merge_key_);
  studio.keep_hand_on();
}

void ColourPicker::set(Studio& studio, const ColourField& field, const Hsv& hsv) {
  hsv_ = hsv;
  const NumberRange range = range_of(studio.session().graph().attribute(field.plug).spec);
  vec3 linear = linear_of(hsv);
  for (int i = 0; i < 3; ++i) {
    linear[i] = rounded(linear[i]);
    if (range.minimum) linear[i] = std::max(linear[i], float(*range.minimum));
    if (range.maximum) linear[i] = std::min(linear[i], float(*range.maximum));
  }
  if (linear == sent_) return;
  sent_ = linear;
  send(studio, field, linear);
}

// Saturation to the right, value up; hues beside it, red at both ends.
void ColourPicker::show_hand(Studio& studio, const ColourField& field) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 size(scaled(196), scaled(148)), bar(scaled(18), size.y);
  ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##square", size);
  note_item(studio.trace, "picker square");
  if (ImGui::IsItemActive()) {
    const vec2 share = mouse_in(at, size);
    set(studio, field, {hsv_.hue, share.x, (1.0f - share.y) * brightest_});
  }
  const ImVec2 end(at.x + size.x, at.y + size.y);
  const unsigned full = packed(linear_of({hsv_.hue, 1.0f, 1.0f}));
  list.AddRectFilledMultiColor(at, end, 0xffffffff, full, full, 0xffffffff);
  list.AddRectFilledMultiColor(at, end, 0, 0, 0xff000000, 0xff000000);
  if (brightest_ > 1.0f) {  // where a display ends
    const float one = std::round(end.y - size.y / brightest_);
    list.AddLine({at.x, one}, {end.x, one}, 0x90000000);
    list.AddText({at.x + scaled(4), one + scaled(1)}, 0xb0000000, "1");
  }
  draw_ring(list, {at.x + hsv_.saturation * size.x, end.y - hsv_.value / brightest_ * size.y});

  ImGui::SameLine(0.0f, scaled(8));
  at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##hue", bar);
  note_item(studio.trace, "picker hue");
  if (ImGui::IsItemActive())
    set(studio, field, {std::min(mouse_in(at, bar).y * 360.0f, 359.9f), hsv_.saturation, hsv_.value});
  for (int i = 0; i < 6; ++i) {
    const unsigned above = packed(linear_of({60.0f * float(i), 1.0f, 1.0f}));
    const unsigned below = packed(linear_of({60.0f * float(i + 1), 1.0f, 1.0f}));
    list.AddRectFilledMultiColor({at.x, std::round(at.y + size.y * float(i) / 6.0f)},
                                 {at.x + bar.x, std::round(at.y + size.y * float(i + 1) / 6.0f)}, above,
                                 above, below, below);
  }
  const float y = at.y + hsv_.hue / 360.0f * bar.y;
  list.AddRect({at.x - scaled(2), y - scaled(3)}, {at.x + bar.x + scaled(2), y + scaled(3)}, 0xff000000);
  list.AddRect({at.x - scaled(1), y - scaled(2)}, {at.x + bar.x + scaled(1), y + scaled(2)}, 0xffffffff);
}

void ColourPicker::show_numbers(Studio& studio, const ColourField& field) {
  const graph::Graph& graph = studio.session().graph();
  const NumberRange range = range_of(graph.attribute(field.plug).spec);
  const float gap = scaled(3), width = std::floor((scaled(222) - 2.0f * gap) / 3.0f);
  const auto number = [&](const char* prefix, const char* unit, double value, const NumberRange& within) {
    const std::string id = std::string("##").append(prefix);
    const FieldEdit edit =
        number_field(id.c_str(), value, within, {.width = width, .prefix = prefix, .unit = unit});
    note_item(studio.trace, std::string("picker ").append(prefix));
    if (edit.dragged) return edit.dragged;
    return edit.typed ? typed_number(*edit.typed, value) : std::nullopt;
  };
  ImGui::TextDisabled("scene-linear, as in the fields");
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0.0f, gap);
    constexpr const char* letters[] = {"R", "G", "B"};
    if (const auto to = number(letters[i], "", double(field.linear[i]), range)) {
      vec3 linear = field.linear;
      linear[i] = float(*to);
      send(studio, field, linear);
    }
  }
  ImGui::TextDisabled("of its sRGB encoding");
  if (const auto to = number("H", "°", double(std::round(hsv_.hue * 10.0f)) / 10.0, range_of_hue()))
    set(studio, field, {float(wrapped(range_of_hue(), *to)), hsv_.saturation, hsv_.value});
  ImGui::SameLine(0.0f, gap);
  const auto shown = [](float v) { return double(std::round(v * 1000.0f)) / 1000.0; };
  if (const auto to = number("S", "", shown(hsv_.saturation), range_from_zero(1.0)))
    set(studio, field, {hsv_.hue, std::clamp(float(*to), 0.0f, 1.0f), hsv_.value});
  ImGui::SameLine(0.0f, gap);
  const std::optional<double> most =
      range.maximum ? std::optional(double(shared::srgb_from_linear(float(*range.maximum)))) : std::nullopt;
  if (const auto to = number("V", "", shown(hsv_.value), range_from_zero(most)))
    set(studio, field, {hsv_.hue, hsv_.saturation, std::max(float(std::min(*to, most.value_or(*to))), 0.0f)});
}

// What it was beside what it is; a click goes back.
void ColourPicker::show_before(Studio& studio, const ColourField& field) {
  ImGui::Dummy({0.0f, scaled(1)});
  const ImVec2 at = ImGui::GetCursorScreenPos(), size(scaled(222), ImGui::GetFrameHeight());
  const float middle = std::round(at.x + size.x / 2);
  if (ImGui::InvisibleButton("##before", {size.x / 2, size.y}) && field.linear != before_)
    send(studio, field, before_);
  note_item(studio.trace, "picker before");
  help("As it was; a click puts it back. So does Escape, and closes this.");
  ImGui::SameLine(0.0f, 0.0f);
  ImGui::Dummy({size.x / 2, size.y});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {middle, at.y + size.y}, packed(before_));
  list.AddRectFilled({middle, at.y}, {at.x + size.x, at.y + size.y}, packed(field.linear));
  const auto name = [&](const char* text, float x, const vec3& under) {
    const bool bright = shared::srgb_from_linear(std::clamp(under.y, 0.0f, 1.0f)) > 0.5f;
    list.AddText({x + scaled(5), at.y + ImGui::GetStyle().FramePadding.y}, bright ? 0xc0000000 : 0xc0ffffff,
                 text);
  };
  name("before", at.x, before_);
  name("now", middle, field.linear);
}

}  // namespace plinian::window
