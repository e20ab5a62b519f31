// Tools, quality, exposure, view transform, layer, camera, what is drawn over the picture, ways to compare.
#include "host/window/panels/view_strip.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/window/fields/arithmetic.h"
#include "host/window/hotkeys/actions.h"
#include "host/window/panels/display_controls.h"
#include "host/window/panels/strip_rows.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

float modes_width(Room room) {
  return list_width(room, 98.0f, "side by side");
}

void show_modes(Studio& studio, Room room) {
  Comparison& comparison = studio.comparison;
  const bool is_on = comparison.mode() != CompareMode::off;
  ImGui::BeginDisabled(!comparison.has_other());
  ImGui::SetNextItemWidth(modes_width(room));
  if (is_on) ImGui::PushStyleColor(ImGuiCol_Text, colour::accent);
  const bool open =
      ImGui::BeginCombo("##compare", is_on ? name_of(comparison.mode()) : "compare", list_flags(room));
  if (is_on) ImGui::PopStyleColor();
  note_item(studio.trace, "compare");
  if (open) {
    for (const CompareMode mode : compare_modes) {
      if (ImGui::Selectable(name_of(mode), comparison.mode() == mode)) comparison.set_mode(mode);
      note_item(studio.trace, std::string("compare ") + name_of(mode));
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  if (open) return;
  const FilePicturePtr& file = comparison.images.reference.picture();
  help(comparison.has_other()
           ? "How the picture is compared with " + (comparison.other ? comparison.name : file->name) + "."
           : "There is nothing to compare with: keep a snapshot (" +
                 text_of(studio.hotkeys.chord(Action::snapshot_picture)) + "), render the reference (" +
                 text_of(studio.hotkeys.chord(Action::reference)) + ") or load one (" +
                 text_of(studio.hotkeys.chord(Action::load_reference)) + ").");
}

void show_flicker_rate(Studio& studio, Room) {
  Comparison& comparison = studio.comparison;
  FieldLook look;
  look.width = scaled(60);
  look.unit = "/s";
  NumberRange rate;
  rate.minimum = 0.0;
  rate.maximum = 20.0;
  const FieldEdit edit = number_field("##rate", comparison.flicker_rate, rate, look);
  help("How often the pictures change places in a second; 0: by hand (X).");
  if (edit.dragged) comparison.flicker_rate = float(*edit.dragged);
  if (edit.typed)
    if (const auto typed = typed_number(*edit.typed, comparison.flicker_rate))
      comparison.flicker_rate = std::clamp(float(*typed), 0.0f, 20.0f);
}

bool has_reference_layers(Studio& studio) {
  const ReferenceImage& image = studio.comparison.images.reference;
  return studio.comparison.other && studio.comparison.kind == OtherKind::file && image.picture() &&
         image.picture()->layers.size() > 1;
}

void show_reference_layers(Studio& studio, Room) {
  const ReferenceImage& image = studio.comparison.images.reference;
  ImGui::SetNextItemWidth(scaled(76));
  const std::string name = image.node() + ".layer";
  const graph::Plug plug = studio.session().graph().plug(name);
  const auto now = std::get<std::string>(studio.session().graph().find(plug.node)->value(plug.attribute));
  if (ImGui::BeginCombo("##layer of the reference", now.empty() ? "RGB" : now.c_str())) {
    for (const std::string& layer : image.picture()->layers)
      if (ImGui::Selectable(layer.empty() ? "RGB" : layer.c_str(), layer == now))
        studio.run("setAttr " + name + " " + graph::quote(layer));
    ImGui::EndCombo();
  }
  help("The layer of " + studio.comparison.name + " that is compared with.");
}

void show_what_is_drawn(Studio& studio, Room) {
  if (ImGui::Button("show")) ImGui::OpenPopup("##show");
  // The button stays to be seen.
  const float widest = scaled(220);  // of the list
  const ImVec2 beneath(
      std::max(0.0f, std::min(ImGui::GetItemRectMin().x, ImGui::GetMainViewport()->Size.x - widest)),
      ImGui::GetItemRectMax().y + scaled(3));
  note_item(studio.trace, "show");
  help("What is drawn over the picture. Nothing of it is in a picture that is written.");
  ImGui::SetNextWindowPos(beneath, ImGuiCond_Appearing);
  if (!ImGui::BeginPopup("##show")) return;
  OverlayChoice& overlay = studio.overlay;
  const std::pair<const char*, bool*> rows[] = {
      {"ground grid", &overlay.grid},          {"axes", &overlay.axes},
      {"scale bar", &overlay.scale_bar},       {"bounds of what is selected", &overlay.bounds},
      {"lights and cameras", &overlay.icons},  {"gate of the scene's camera", &overlay.gate},
      {"plug-in drawings", &overlay.drawings}, {"handles", &overlay.handles}};
  for (const auto& [name, on] : rows) {
    ImGui::Checkbox(name, on);
    note_item(studio.trace, std::string("show ") + name);
  }
  ImGui::EndPopup();
}

struct ToolButton {
  Action action;
  Tool tool;
  const char *letter, *name, *what;
};
constexpr ToolButton tool_buttons[] = {
    {Action::tool_select, Tool::select, "Q", "tool select", "Select, with nothing to take hold of"},
    {Action::tool_translate, Tool::translate, "W", "tool translate", "Move what is selected by its arrows"},
    {Action::tool_rotate, Tool::rotate, "E", "tool rotate", "Turn it by its rings"},
    {Action::tool_scale, Tool::scale, "R", "tool scale", "Scale it by its boxes"}};

// By their keys, as on a keyboard.
std::string label_of(const Studio& studio, const ToolButton& button) {
  const std::string keys = text_of(studio.hotkeys.chord(button.action));
  return (keys.size() == 1 ? keys : button.letter) + ("##" + std::string(button.name));
}

float width_of_tools(const Studio& studio) {
  float width = button_width("world");
  for (const ToolButton& button : tool_buttons)
    width += button_width(label_of(studio, button).c_str()) + scaled(1);
  return width;
}

void show_tools(Studio& studio, Room) {
  for (const ToolButton& button : tool_buttons) {
    const std::string keys = text_of(studio.hotkeys.chord(button.action));
    const std::string what = std::string(button.what) + (keys == "none" ? "." : " (" + keys + ").");
    if (toggle(label_of(studio, button).c_str(), studio.tools.tool == button.tool, what.c_str()))
      act(studio, button.action);
    note_item(studio.trace, button.name);
    ImGui::SameLine(0.0f, scaled(1));
  }
  const bool moves = studio.tools.tool == Tool::translate || studio.tools.tool == Tool::rotate;
  const bool local = moves && studio.tools.space() == AxisSpace::local;
  const std::string what =
      "Along the world's axes, or its own (" + text_of(studio.hotkeys.chord(Action::axis_space)) + ").";
  ImGui::BeginDisabled(!moves);
  if (toggle(local ? "own" : "world", false, what.c_str(), button_width("world")))
    act(studio, Action::axis_space);
  ImGui::EndDisabled();
  note_item(studio.trace, "axes of the tool");
}

void show_quality(Studio& studio, Room) {
  const std::string& quality = studio.workspace.view().quality;
  if (toggle("fast", quality == "fast", "The quality set fast (1).")) act(studio, Action::quality_fast);
  note_item(studio.trace, "fast");
  ImGui::SameLine(0.0f, scaled(2));
  if (toggle("high", quality == "high", "The quality set high (2).")) act(studio, Action::quality_high);
  note_item(studio.trace, "high");
}

float camera_width(Room room) {
  return button_width(room == Room::ample ? "scene camera" : "camera");
}

void show_camera(Studio& studio, Room room) {
  const bool free = studio.viewpoint.look.free.has_value(), ample = room == Room::ample;
  const char* label = free ? (ample ? "free camera" : "free") : ample ? "scene camera" : "camera";
  if (toggle(label, !free, "Look through the scene's camera (C). Moving the view leaves to a free one.",
             camera_width(room)))
    studio.viewpoint.look_through_scene_camera();
  note_item(studio.trace, "camera of the view");
}

void show_full_range(Studio& studio, Room) {
  if (toggle("full-range maps", true,
             "The original method instead of adaptive maps (T), for this view only."))
    act(studio, Action::original_maps);
}

void show_solo(Studio& studio, Room) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour::changed);
  if (ImGui::Button("solo")) {
    studio.development.solo.clear();
    studio.development.solo_ambient = false;
  }
  ImGui::PopStyleColor();
  help("Lights are seen alone; click to see everything.");
}

struct Control {
  StripWidth place;
  void (*show)(Studio& studio, Room room);
};

// Those that are always there. Their widths do not depend on what they say, so that nothing jumps.
std::vector<Control> standing_controls(const Studio& studio, Room room) {
  const bool ample = room == Room::ample;
  const float wide = scaled(ample ? 10.0f : 6.0f), near = scaled(ample ? 6.0f : 4.0f), close = scaled(2);
  const float quality = button_width("fast") + close + button_width("high");
  return {{{width_of_tools(studio), 0.0f}, show_tools},
          {{quality, wide}, show_quality},
          {{exposure_width(room), wide}, show_exposure},
          {{transform_width(room), near}, show_view_transform},
          {{layer_width(room), near}, show_layer},
          {{camera_width(room), wide}, show_camera},
          {{button_width("show"), wide}, show_what_is_drawn},
          {{modes_width(room), wide}, show_modes}};
}

// ... and those that there are now.
std::vector<Control> controls_of(Studio& studio, Room room) {
  const float near = scaled(room == Room::ample ? 6.0f : 4.0f), close = scaled(2);
  std::vector<Control> controls = standing_controls(studio, room);
  if (studio.comparison.mode() == CompareMode::flicker)
    controls.push_back({{scaled(60), close}, show_flicker_rate});
  else if (has_reference_layers(studio))
    controls.push_back({{scaled(76), close}, show_reference_layers});
  if (studio.original_maps) controls.push_back({{button_width("full-range maps"), near}, show_full_range});
  if (!studio.development.solo.empty() || studio.development.solo_ambient)
    controls.push_back({{button_width("solo"), near}, show_solo});
  return controls;
}

constexpr float margin_x = 8.0f, margin_y = 4.0f;  // [points at a scale of 1] around the controls

// By what is always there, so that nothing is renamed by what comes and goes.
Room room_in(const Studio& studio, float width) {
  float all = 0.0f;
  for (const Control& control : standing_controls(studio, Room::ample))
    all += control.place.gap + control.place.width;
  return all <= width - 2.0f * scaled(margin_x) ? Room::ample : Room::scarce;
}

StripRows wrapped(const std::vector<Control>& controls, float width, int most) {
  std::vector<StripWidth> widths;
  for (const Control& control : controls) widths.push_back(control.place);
  return wrap(widths, width - 2.0f * scaled(margin_x), most, scaled(6) + button_width("»"));
}

// What comes and goes begins no row: the picture beneath would become another size each time.
StripRows rows_of(const Studio& studio, const std::vector<Control>& controls, float width) {
  constexpr int most = 2;  // more would take the picture's room
  return wrapped(controls, width,
                 wrapped(standing_controls(studio, room_in(studio, width)), width, most).count);
}

void show_more(Studio& studio, Room room, const std::vector<Control>& controls, const StripRows& rows) {
  if (ImGui::Button("»")) ImGui::OpenPopup("##more");
  note_item(studio.trace, "more of the strip");
  help("What the strip is too narrow for.");
  if (!ImGui::BeginPopup("##more")) return;
  for (std::size_t i = 0; i < controls.size(); ++i)
    if (rows.row[i] < 0) controls[i].show(studio, room);
  ImGui::EndPopup();
}

}  // namespace

float view_strip_height(Studio& studio, float width) {
  const int rows = rows_of(studio, controls_of(studio, room_in(studio, width)), width).count;
  return float(rows) * ImGui::GetFrameHeight() + float(rows - 1) * scaled(margin_y) + 2.0f * scaled(margin_y);
}

void show_view_strip(Studio& studio, const PaneRect& pane) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(margin_x), scaled(margin_y)));
  begin_pane("##strip", pane, false);
  ImGui::PopStyleVar();
  const Room room = room_in(studio, pane.size.x);
  const std::vector<Control> controls = controls_of(studio, room);
  const StripRows rows = rows_of(studio, controls, pane.size.x);
  const float left = pane.begin.x + scaled(margin_x);
  float x = left;
  const auto go_to = [&](int row, float at) {
    ImGui::SetCursorScreenPos(
        {at, pane.begin.y + scaled(margin_y) + float(row) * (ImGui::GetFrameHeight() + scaled(margin_y))});
  };
  int row = 0;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    if (rows.row[i] < 0) break;
    const StripWidth& place = controls[i].place;
    const bool first = i == 0 || rows.row[i] != row;
    row = rows.row[i];
    x = first ? left : x + place.gap;
    go_to(row, x);
    controls[i].show(studio, room);
    x += place.width;
  }
  if (rows.has_menu()) {
    // In the last row, which may hold nothing else.
    const bool alone = row != rows.count - 1;
    go_to(rows.count - 1, alone ? left : x + scaled(6));
    show_more(studio, room, controls, rows);
  }
  end_pane();
}

}  // namespace plinian::window
