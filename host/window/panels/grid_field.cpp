// Typed, or chosen from a list.
#include "host/window/panels/grid_field.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "host/nodes/read_facts.h"
#include "host/window/files/file_list.h"
#include "host/window/files/grid_lists.h"
#include "host/window/panels/widgets.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

// A line of the list: what is chosen by it, and what is said beside it.
struct Offer {
  std::string value, label, kind, extent, size;
  std::string refusal;  // why it cannot be chosen; empty where it can
};

// "density[1]" of "density".
std::string family(const std::string& name) {
  return name.ends_with(']') ? name.substr(0, name.rfind('[')) : name;
}

std::vector<Offer> offers_of(const GridList& list, const GridWidget& widget, const std::string& by_name) {
  std::vector<Offer> offers;
  offers.push_back({"", by_name.empty() ? "chosen by name" : "chosen by name: " + by_name, "", "", "", ""});
  if (widget.or_none) offers.push_back({"none", "none", "", "", "", ""});
  for (const VdbGridInfo& grid : list.grids) {
    // What can be converted is a choice all the same: the reader says how.
    const bool scalar = !grid.value_type.starts_with("vec") && !grid.value_type.starts_with("ptdata") &&
                        !grid.value_type.starts_with("mask") && !grid.value_type.starts_with("string");
    offers.push_back({grid.name, grid.name, kind_text(grid), extent_text(grid),
                      grid.stored_bytes > 0 ? size_text(grid.stored_bytes) : "",
                      !grid.error.empty() ? grid.error
                      : !scalar           ? grid.refusal
                                          : ""});
  }
  // Where several are called alike their sum can be read, too.
  for (std::size_t i = 0; i < list.grids.size(); ++i) {
    const std::string& name = list.grids[i].name;
    if (!name.ends_with("[0]")) continue;
    const std::string sum = family(name) + "[*]";
    offers.push_back({sum, sum, widget.or_none ? "their largest" : "their sum", "", "", ""});
  }
  return offers;
}

float width_of(const std::vector<Offer>& offers, std::string Offer::*text) {
  float width = 0.0f;
  for (const Offer& offer : offers) width = std::max(width, ImGui::CalcTextSize((offer.*text).c_str()).x);
  return width;
}

// In columns, as the list of a file's grids.
std::optional<std::string> show_offers(Studio& studio, const std::vector<Offer>& offers,
                                       const std::string& now) {
  std::optional<std::string> chosen;
  const float gap = scaled(18), label = width_of(offers, &Offer::label) + gap;
  const float kind = width_of(offers, &Offer::kind) + gap, extent = width_of(offers, &Offer::extent) + gap;
  const float whole = label + kind + extent + width_of(offers, &Offer::size);
  for (const Offer& offer : offers) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(offer.value.c_str());
    ImGui::BeginDisabled(!offer.refusal.empty());
    if (ImGui::Selectable("##grid", offer.value == now, 0, {whole, 0.0f})) chosen = offer.value;
    ImGui::EndDisabled();
    ImGui::PopID();
    if (!ImGui::IsWindowAppearing())  // else it is not yet where it will be
      note_item(studio.trace, "grid " + (offer.value.empty() ? "by name" : offer.value));
    help(offer.refusal);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const unsigned faint = colour::faint_text;
    const bool usable = offer.refusal.empty();
    list->AddText(at, usable && !offer.value.empty() ? colour::text : faint, offer.label.c_str());
    list->AddText({at.x + label, at.y}, faint, offer.kind.c_str());
    list->AddText({at.x + label + kind, at.y}, faint, offer.extent.c_str());
    list->AddText({std::round(at.x + whole - ImGui::CalcTextSize(offer.size.c_str()).x), at.y}, faint,
                  offer.size.c_str());
  }
  return chosen;
}

}  // namespace

std::optional<GridWidget> grid_widget(const std::string& widget) {
  std::istringstream words(widget);
  std::string grid, of, file, or_word, none;
  words >> grid >> of >> file >> or_word >> none;
  if (grid != "grid" || of != "of" || file.empty()) return std::nullopt;
  return GridWidget{file, or_word == "or" && none == "none"};
}

std::string grid_by_name(graph::Session& session, const graph::Plug& attribute, const GridWidget& widget) {
  const graph::Node& node = *session.graph().find(attribute.node);
  const std::string* named = std::get_if<std::string>(&node.value(attribute.attribute, attribute.element));
  const graph::AttributeIndex facts = node.schema->find("facts");
  if (!named || !named->empty() || facts == graph::no_attribute ||
      (*node.schema)[facts].spec.data_type != nodes::facts_type)
    return "";
  const graph::ResultPtr result = session.evaluator().known({node.id, facts});
  const auto* data = result && result->has_value ? std::get_if<graph::DataPtr>(&result->value) : nullptr;
  if (!data || !*data) return "";
  const auto& read = *static_cast<const VdbFacts*>((*data)->object.get());
  const std::vector<VdbGridInfo>& grids = widget.or_none ? read.temperature : read.density;
  if (read.path.empty()) return "";
  return grids.empty() ? "none" : grids.size() == 1 ? grids[0].name : family(grids[0].name) + "[*]";
}

std::optional<std::string> grid_field(Studio& studio, const std::string& name, const std::string& now,
                                      const std::string& by_name, const GridWidget& widget,
                                      const std::string& path, float width, bool enabled) {
  const auto list = studio.grids.of(path);
  const bool offers = list && !list->grids.empty();
  const float arrow = offers ? ImGui::GetFrameHeight() : 0.0f;
  const std::string hint = !by_name.empty()         ? "by name: " + by_name
                           : offers || path.empty() ? "chosen by name"
                                                    : "";
  std::optional<std::string> chosen = text_field("##value", now, width - arrow, enabled, hint.c_str());
  if (!offers) return chosen;
  ImGui::SameLine(0.0f, 0.0f);
  ImGui::BeginDisabled(!enabled);
  if (ImGui::BeginCombo("##grids", "", ImGuiComboFlags_NoPreview | ImGuiComboFlags_PopupAlignLeft)) {
    if (const auto picked = show_offers(studio, offers_of(*list, widget, by_name), now)) chosen = picked;
    ImGui::EndCombo();
  } else {
    note_item(studio.trace, name + " list");
  }
  ImGui::EndDisabled();
  return chosen;
}

}  // namespace plinian::window
