// A number and two lists; nothing of it is a part of the scene.
#include "host/window/panels/display_controls.h"

#include <algorithm>
#include <string>
#include <vector>

#include "host/window/fields/arithmetic.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

constexpr float dot = 14.0f, gap = 2.0f;  // [points at a scale of 1] behind the exposure

float number_width(Room room) {
  return scaled(room == Room::ample ? 92.0f : 70.0f);
}

std::string name_of(const ViewSettings& view) {
  if (view.view == View::srgb) return "sRGB";
  if (view.view == View::filmic) return "filmic";
  return view.ocio_view.empty() ? "OCIO" : view.ocio_view;
}

void show_ocio_views(Studio& studio) {
  ViewSettings& view = studio.development.view;
  const std::vector<OcioView>& views = studio.ocio_views();
  for (const OcioView& known : views) {
    const bool on =
        view.view == View::ocio && view.ocio_display == known.display && view.ocio_view == known.view;
    if (ImGui::Selectable((known.display + " / " + known.view).c_str(), on)) {
      view.view = View::ocio;
      view.ocio_display = known.display;
      view.ocio_view = known.view;
    }
  }
  if (views.empty()) ImGui::TextDisabled("$OCIO names no configuration");
}

void show_gamma(Studio& studio) {
  float& gamma = studio.development.view.gamma;
  FieldLook look;
  look.width = scaled(100);
  look.prefix = "gamma";
  look.changed = gamma != 1.0f;
  NumberRange range{0.01, 100.0, 0.2, 5.0, false, true};
  const FieldEdit edit = number_field("##gamma", gamma, range, look);
  note_item(studio.trace, "gamma");
  help("After the view transform. No part of the scene.");
  if (edit.dragged) gamma = float(*edit.dragged);
  if (edit.typed)
    if (const auto typed = typed_number(*edit.typed, gamma))
      gamma = float(std::clamp(*typed, *range.minimum, *range.maximum));
}

}  // namespace

ImGuiComboFlags list_flags(Room room) {
  return room == Room::ample ? ImGuiComboFlags_None : ImGuiComboFlags_NoArrowButton;
}

float list_width(Room room, float ample, const char* word) {
  return room == Room::ample ? scaled(ample) : button_width(word);
}

float exposure_width(Room room) {
  return number_width(room) + scaled(gap + dot);
}

void show_exposure(Studio& studio, Room room) {
  Development& how = studio.development;
  FieldLook look;
  look.width = number_width(room);
  look.prefix = "exp";
  if (room == Room::ample) look.unit = "stops";
  look.changed = how.view.exposure != 0.0f;
  NumberRange stops;
  stops.soft_minimum = -8.0;
  stops.soft_maximum = 8.0;
  const FieldEdit edit = number_field("##exposure", how.view.exposure, stops, look);
  note_item(studio.trace, "exposure");
  help("Exposure of the display, in stops. No part of the scene.");
  if (edit.dragged) how.view.exposure = float(*edit.dragged);
  if (edit.typed)
    if (const auto typed = typed_number(*edit.typed, how.view.exposure)) how.view.exposure = float(*typed);
  if (!look.changed) return;
  ImGui::SameLine(0.0f, scaled(gap));
  if (show_changed_dot(scaled(dot), "Not at its default; click to put it back.")) how.view.exposure = 0.0f;
}

float transform_width(Room room) {
  return list_width(room, 76.0f, "filmic");
}

void show_view_transform(Studio& studio, Room room) {
  ViewSettings& view = studio.development.view;
  ImGui::SetNextItemWidth(transform_width(room));
  const bool changed = view.gamma != 1.0f;
  if (changed) ImGui::PushStyleColor(ImGuiCol_Text, colour::changed);
  const bool open =
      ImGui::BeginCombo("##view", name_of(view).c_str(), list_flags(room) | ImGuiComboFlags_HeightLarge);
  if (changed) ImGui::PopStyleColor();
  note_item(studio.trace, "view transform");
  if (!open) {
    help("How linear radiance is turned into what the display shows: " + name_of(view) +
         (changed ? ", gamma " + shown_number(view.gamma) : "") + ".");
    return;
  }
  for (const View kind : {View::srgb, View::filmic})
    if (ImGui::Selectable(name_of(ViewSettings{.view = kind}).c_str(), view.view == kind)) view.view = kind;
  ImGui::Separator();
  show_ocio_views(studio);
  ImGui::Separator();
  show_gamma(studio);
  ImGui::EndCombo();
}

float layer_width(Room room) {
  return list_width(room, 84.0f, "map error");
}

void show_layer(Studio& studio, Room room) {
  Development& how = studio.development;
  ImGui::SetNextItemWidth(layer_width(room));
  if (ImGui::BeginCombo("##layer", how.layer.empty() ? "beauty" : how.layer.c_str(), list_flags(room))) {
    for (const char* layer : {"beauty", "alpha", "depth", "ambient", "emission", "map error"}) {
      const bool beauty = std::string(layer) == "beauty";
      if (ImGui::Selectable(layer, beauty ? how.layer.empty() : how.layer == layer))
        how.layer = beauty ? "" : layer;
    }
    ImGui::EndCombo();
  }
  note_item(studio.trace, "layer");
  help("The layer that is seen; map error: how far the maps of the lights are from the exact transmittance.");
}

}  // namespace plinian::window
