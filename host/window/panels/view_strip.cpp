// Quality, exposure, view transform, layer, camera.
#include "host/window/panels/view_strip.h"

#include <imgui.h>

#include <algorithm>

#include "host/window/fields/arithmetic.h"
#include "host/window/hotkeys/actions.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

void note_item(Studio& studio, const char* name) {
  studio.trace.item(name, vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                    vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
}

void show_ways_to_compare(Studio& studio) {
  Comparison& comparison = studio.comparison;
  const bool is_on = comparison.mode() != CompareMode::off;
  ImGui::SameLine(0.0f, scaled(14));
  ImGui::SetNextItemWidth(scaled(98));
  if (is_on) ImGui::PushStyleColor(ImGuiCol_Text, colour::accent);
  const bool open = ImGui::BeginCombo("##compare", is_on ? name_of(comparison.mode()) : "compare");
  if (is_on) ImGui::PopStyleColor();
  note_item(studio, "compare");
  if (open) {
    for (const CompareMode mode : compare_modes) {
      if (ImGui::Selectable(name_of(mode), comparison.mode() == mode)) comparison.set_mode(mode);
      note_item(studio, (std::string("compare ") + name_of(mode)).c_str());
    }
    ImGui::EndCombo();
  } else {
    help("How the picture is compared with " + comparison.name + ".");
  }
  if (comparison.mode() == CompareMode::flicker) {
    FieldLook look;
    look.width = scaled(60);
    look.unit = "/s";
    NumberRange rate;
    rate.minimum = 0.0;
    rate.maximum = 20.0;
    ImGui::SameLine(0.0f, scaled(2));
    const FieldEdit edit = number_field("##rate", comparison.flicker_rate, rate, look);
    help("How often the pictures change places in a second; 0: by hand (X).");
    if (edit.dragged) comparison.flicker_rate = float(*edit.dragged);
    if (edit.typed)
      if (const auto typed = typed_number(*edit.typed, comparison.flicker_rate))
        comparison.flicker_rate = std::clamp(float(*typed), 0.0f, 20.0f);
  }
  const ReferenceImage& image = studio.comparison.images.reference;
  if (comparison.mode() == CompareMode::flicker || comparison.kind != OtherKind::file || !image.picture() ||
      image.picture()->layers.size() < 2)
    return;
  ImGui::SameLine(0.0f, scaled(2));
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
  help("The layer of " + comparison.name + " that is compared with.");
}

void show_what_is_drawn(Studio& studio) {
  ImGui::SameLine(0.0f, scaled(14));
  if (ImGui::Button("show")) ImGui::OpenPopup("##show");
  note_item(studio, "show");
  help("What is drawn over the picture. Nothing of it is in a picture that is written.");
  if (!ImGui::BeginPopup("##show")) return;
  OverlayChoice& overlay = studio.overlay;
  const std::pair<const char*, bool*> rows[] = {
      {"ground grid", &overlay.grid},          {"axes", &overlay.axes},
      {"scale bar", &overlay.scale_bar},       {"bounds of what is selected", &overlay.bounds},
      {"lights and cameras", &overlay.icons},  {"gate of the scene's camera", &overlay.gate},
      {"plug-in drawings", &overlay.drawings}, {"handles", &studio.tools.show}};
  for (const auto& [name, on] : rows) {
    ImGui::Checkbox(name, on);
    note_item(studio, (std::string("show ") + name).c_str());
  }
  ImGui::EndPopup();
}

// The tools by their keys, as on a keyboard.
void show_tools(Studio& studio) {
  const auto chord = [&](Action action) { return text_of(studio.hotkeys.chord(action)); };
  const struct {
    Action action;
    Tool tool;
    const char *letter, *name, *what;
  } rows[] = {
      {Action::tool_select, Tool::select, "Q", "tool select", "Select, with nothing to take hold of"},
      {Action::tool_translate, Tool::translate, "W", "tool translate", "Move what is selected by its arrows"},
      {Action::tool_rotate, Tool::rotate, "E", "tool rotate", "Turn it by its rings"},
      {Action::tool_scale, Tool::scale, "R", "tool scale", "Scale it by its boxes"}};
  for (const auto& row : rows) {
    const std::string keys = chord(row.action), label = keys.size() == 1 ? keys : row.letter;
    const std::string what = std::string(row.what) + (keys == "none" ? "." : " (" + keys + ").");
    if (toggle((label + "##" + row.name).c_str(), studio.tools.tool == row.tool, what.c_str()))
      act(studio, row.action);
    note_item(studio, row.name);
    ImGui::SameLine(0.0f, scaled(1));
  }
  const bool moves = studio.tools.tool == Tool::translate || studio.tools.tool == Tool::rotate;
  if (moves) {
    const std::string what = "Along the world's axes, or its own (" + chord(Action::axis_space) + ").";
    const bool local = studio.tools.space() == AxisSpace::local;
    if (toggle(local ? "own" : "world", false, what.c_str())) act(studio, Action::axis_space);
    note_item(studio, "axes of the tool");
    ImGui::SameLine();
  }
  ImGui::SameLine(0.0f, scaled(12));
}

}  // namespace

void show_view_strip(Studio& studio, const PaneRect& pane) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(8), scaled(4)));
  begin_pane("##strip", pane, false);
  ImGui::PopStyleVar();
  const std::string& quality = studio.workspace.view().quality;
  const auto trace = [&](const char* name) {
    studio.trace.item(name, vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                      vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
  };
  show_tools(studio);
  if (toggle("fast", quality == "fast", "The quality set fast (1).")) act(studio, Action::quality_fast);
  trace("fast");
  ImGui::SameLine(0.0f, scaled(2));
  if (toggle("high", quality == "high", "The quality set high (2).")) act(studio, Action::quality_high);
  trace("high");
  ImGui::SameLine(0.0f, scaled(14));

  Development& how = studio.development;
  FieldLook look;
  look.width = scaled(92);
  look.prefix = "exp";
  look.unit = "stops";
  look.changed = how.view.exposure != 0.0f;
  NumberRange stops;
  stops.soft_minimum = -8.0;
  stops.soft_maximum = 8.0;
  const FieldEdit edit = number_field("##exposure", how.view.exposure, stops, look);
  trace("exposure");
  help("Exposure of the display. No part of the scene.");
  if (edit.dragged) how.view.exposure = float(*edit.dragged);
  if (edit.typed)
    if (const auto typed = typed_number(*edit.typed, how.view.exposure)) how.view.exposure = float(*typed);
  if (look.changed) {
    ImGui::SameLine(0.0f, scaled(2));
    ImGui::PushStyleColor(ImGuiCol_Text, colour::changed);
    if (ImGui::Button("0")) how.view.exposure = 0.0f;
    ImGui::PopStyleColor();
    help("The exposure is off its default; click to put it back.");
  }
  ImGui::SameLine(0.0f, scaled(6));
  static const char* const views[] = {"sRGB", "filmic", "OCIO"};
  ImGui::SetNextItemWidth(scaled(76));
  if (ImGui::BeginCombo("##view", views[int(how.view.view)])) {
    for (int i = 0; i < 3; ++i)
      if (ImGui::Selectable(views[i], int(how.view.view) == i)) how.view.view = View(i);
    ImGui::EndCombo();
  }
  help("How linear radiance is turned into what the display shows.");
  ImGui::SameLine(0.0f, scaled(6));
  ImGui::SetNextItemWidth(scaled(84));
  if (ImGui::BeginCombo("##layer", how.layer.empty() ? "beauty" : how.layer.c_str())) {
    for (const char* layer : {"beauty", "alpha", "depth", "ambient", "emission", "map error"}) {
      const bool beauty = std::string(layer) == "beauty";
      if (ImGui::Selectable(layer, beauty ? how.layer.empty() : how.layer == layer))
        how.layer = beauty ? "" : layer;
    }
    ImGui::EndCombo();
  }
  help("The layer that is seen; map error: how far the maps of the lights are from the exact transmittance.");
  note_item(studio, "layer");
  ImGui::SameLine(0.0f, scaled(14));
  if (toggle(studio.viewpoint.look.free ? "free camera" : "scene camera", !studio.viewpoint.look.free,
             "Look through the scene's camera (C). Moving the view leaves to a free one."))
    studio.viewpoint.look_through_scene_camera();
  show_what_is_drawn(studio);
  if (studio.comparison.other) show_ways_to_compare(studio);
  if (studio.original_maps) {
    ImGui::SameLine(0.0f, scaled(6));
    if (toggle("full-range maps", true,
               "The original method instead of adaptive maps (T), for this view only."))
      act(studio, Action::original_maps);
  }
  if (!how.solo.empty() || how.solo_ambient) {
    ImGui::SameLine(0.0f, scaled(6));
    ImGui::PushStyleColor(ImGuiCol_Text, colour::changed);
    if (ImGui::Button("solo")) {
      how.solo.clear();
      how.solo_ambient = false;
    }
    ImGui::PopStyleColor();
    help("Lights are seen alone; click to see everything.");
  }
  end_pane();
}

}  // namespace plinian::window
