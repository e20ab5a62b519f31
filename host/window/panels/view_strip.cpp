// Quality, exposure, view transform, layer, camera.
#include "host/window/panels/view_strip.h"

#include <imgui.h>

#include "host/window/fields/arithmetic.h"
#include "host/window/hotkeys/actions.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

void show_view_strip(Studio& studio, const PaneRect& pane) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(8), scaled(4)));
  begin_pane("##strip", pane, false);
  ImGui::PopStyleVar();
  const std::string& quality = studio.workspace.view().quality;
  const auto trace = [&](const char* name) {
    studio.trace.item(name, vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                      vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
  };
  if (toggle("fast", quality == "fast", "The quality set fast (1).")) act(studio, Action::quality_fast);
  trace("fast");
  ImGui::SameLine(0.0f, scaled(2));
  if (toggle("high", quality == "high", "The quality set high (2).")) act(studio, Action::quality_high);
  trace("high");
  ImGui::SameLine(0.0f, scaled(14));

  Development& how = studio.development;
  FieldLook look;
  look.width = scaled(104);
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
  ImGui::SetNextItemWidth(scaled(84));
  if (ImGui::BeginCombo("##view", views[int(how.view.view)])) {
    for (int i = 0; i < 3; ++i)
      if (ImGui::Selectable(views[i], int(how.view.view) == i)) how.view.view = View(i);
    ImGui::EndCombo();
  }
  help("How linear radiance is turned into what the display shows.");
  ImGui::SameLine(0.0f, scaled(6));
  ImGui::SetNextItemWidth(scaled(92));
  if (ImGui::BeginCombo("##layer", how.layer.empty() ? "beauty" : how.layer.c_str())) {
    for (const char* layer : {"beauty", "alpha", "depth", "ambient", "emission"}) {
      const bool beauty = std::string(layer) == "beauty";
      if (ImGui::Selectable(layer, beauty ? how.layer.empty() : how.layer == layer))
        how.layer = beauty ? "" : layer;
    }
    ImGui::EndCombo();
  }
  help("The layer that is seen.");
  ImGui::SameLine(0.0f, scaled(14));
  if (toggle(studio.viewpoint.look.free ? "free camera" : "scene camera", !studio.viewpoint.look.free,
             "Look through the scene's camera (C). Moving the view leaves to a free one."))
    studio.viewpoint.look_through_scene_camera();
  if (studio.comparison.other) {
    ImGui::SameLine(0.0f, scaled(6));
    if (toggle("wipe", studio.comparison.wipes,
               "Wipe between the picture and the one kept (Shift+W); drag the line."))
      act(studio, Action::wipe);
    ImGui::SameLine(0.0f, scaled(2));
    if (toggle("diff", studio.development.difference, "How far it is from the one kept (Shift+D)."))
      act(studio, Action::difference);
  }
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
