// Three groups of rows.
#include "host/window/panels/place_list.h"

#include <imgui.h>

#include <cmath>
#include <utility>

#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"
#include "host/window/platform/trace.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

void group(const char* title) {
  ImGui::Dummy({0.0f, scaled(6)});
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + scaled(8));
  ImGui::TextDisabled("%s", title);
  ImGui::Dummy({0.0f, scaled(2)});
}

}  // namespace

void PlaceList::begin(fs::path scene, std::vector<std::string> recent) {
  scene_ = std::move(scene);
  recent_ = std::move(recent);
  bookmarks_.refresh();
  gather();
}

void PlaceList::gather() {
  places_ = places_of(scene_, recent_, bookmarks_.all());
}

PlaceList::Click PlaceList::show_place(Trace& trace, const Place& place, const fs::path& here,
                                       bool has_cross) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight() + scaled(7);
  ImGui::PushID(place.folder.c_str());
  const bool pressed = list_row("##place", place.folder == here, height);
  ImGui::PopID();
  note_item(trace, "place " + place.label);
  const bool hovered = ImGui::IsItemHovered();
  const float cross = at.x + width - scaled(24);
  const bool on_cross = has_cross && hovered && ImGui::GetIO().MousePos.x >= cross;
  help(on_cross ? "Forget this bookmark." : place.folder.string());
  const float y = std::round(at.y + (height - ImGui::GetTextLineHeight()) / 2);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(at, {has_cross && hovered ? cross : at.x + width - scaled(4), at.y + height}, true);
  list->AddText({at.x + scaled(16), y}, colour::text, place.label.c_str());
  list->PopClipRect();
  if (has_cross) {
    trace.item("forget " + place.label, vec2(cross, at.y), vec2(scaled(24), height));
    const ImVec2 middle(cross + scaled(12), std::round(at.y + height / 2));
    const float arm = scaled(4), thick = scaled(1.5f);
    const unsigned ink = on_cross ? colour::text : colour::faint_text;
    if (hovered) {
      list->AddLine({middle.x - arm, middle.y - arm}, {middle.x + arm, middle.y + arm}, ink, thick);
      list->AddLine({middle.x - arm, middle.y + arm}, {middle.x + arm, middle.y - arm}, ink, thick);
    }
  }
  return !pressed ? Click::none : on_cross ? Click::cross : Click::place;
}

std::optional<fs::path> PlaceList::show(Trace& trace, const fs::path& here, vec2 size) {
  std::optional<fs::path> gone_to;
  std::optional<fs::path> forgotten;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("##places", {size.x, size.y}, true);
  ImGui::PopStyleVar();  // tooltips have their own
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  group("Places");
  for (const Place& place : places_.fixed)
    if (show_place(trace, place, here, false) != Click::none) gone_to = place.folder;
  group("Bookmarks");
  ImGui::PushID("bookmarks");
  for (const Place& place : places_.bookmarks) {
    const Click click = show_place(trace, place, here, true);
    if (click == Click::place) gone_to = place.folder;
    if (click == Click::cross) forgotten = place.folder;
  }
  bool added = false;
  if (!bookmarks_.has(here)) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight() + scaled(7);
    added = list_row("##add", false, height);
    note_item(trace, "bookmark this folder");
    ImGui::GetWindowDrawList()->AddText(
        {at.x + scaled(16), std::round(at.y + (height - ImGui::GetTextLineHeight()) / 2)},
        ImGui::IsItemHovered() ? colour::text : colour::faint_text, "+ this folder");
    help("Remembers " + here.string() + " here.");
  }
  ImGui::PopID();
  if (!places_.recent.empty()) {
    group("Recent");
    for (const Place& place : places_.recent)
      if (show_place(trace, place, here, false) != Click::none) gone_to = place.folder;
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  if (added) bookmarks_.add(here);
  if (forgotten) bookmarks_.remove(*forgotten);
  if (added || forgotten) gather();
  return gone_to;
}

}  // namespace plinian::window
