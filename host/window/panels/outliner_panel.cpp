// A tree, a filter, names in place.
#include "host/window/panels/outliner_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "host/graph/model/conversion.h"
#include "host/graph/model/hierarchy.h"
#include "host/window/nodes/node_colours.h"
#include "host/window/nodes/node_failure.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

bool contains_word(std::string text, std::string word) {
  for (std::string* s : {&text, &word})
    for (char& c : *s) c = char(std::tolower((unsigned char)c));
  return text.find(word) != text.npos;
}

// At the right edge of the last widget, a row.
void show_badge(Studio& studio, const graph::Node& node, const NodeFailure& failure) {
  const ImVec2 begin = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  const ImVec2 middle(
      std::round(std::min(end.x, ImGui::GetWindowDrawList()->GetClipRectMax().x) - scaled(12)),
      std::round((begin.y + end.y) / 2));
  const float radius = scaled(7);
  const ImVec2 size = ImGui::CalcTextSize("!");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(middle, radius, failure.blocked ? colour::warning : colour::error, 20);
  list.AddText({std::round(middle.x - size.x / 2), std::round(middle.y - size.y / 2)}, 0xff1a1a1a, "!");
  studio.trace.item("failed " + node.name, vec2(middle.x, middle.y) - radius, vec2(2.0f * radius));
}

constexpr const char* dragged_node = "node";  // what a drag carries: a NodeId

// The last widget takes nodes that are dragged to it, to stand under a transform or at the top.
void take_dragged(Studio& studio, const std::string& parent) {
  if (!ImGui::BeginDragDropTarget()) return;
  if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(dragged_node)) {
    graph::NodeId id;
    std::memcpy(&id, payload->Data, sizeof id);
    if (const graph::Node* node = studio.session().graph().find(id))
      studio.run(parent.empty() ? "parent -world " + node->name : "parent " + node->name + " " + parent);
  }
  ImGui::EndDragDropTarget();
}

// The last widget, a row of the tree, can be dragged to another.
void drag_and_drop(Studio& studio, const graph::Node& node) {
  if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoHoldToOpenOthers)) {
    ImGui::SetDragDropPayload(dragged_node, &node.id, sizeof node.id);
    ImGui::Text("%s: drop it on a transform, or below at the top", node.name.c_str());
    ImGui::EndDragDropSource();
  }
  if (node.type->spec().holds_children) take_dragged(studio, node.name);
}

}  // namespace

void OutlinerPanel::select(Studio& studio, const graph::Node& node) {
  const auto& selection = studio.session().graph().selection();
  const bool selected = std::find(selection.begin(), selection.end(), node.id) != selection.end();
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl || io.KeyShift)
    studio.run(std::string("select ") + (selected ? "-remove " : "-add ") + node.name);
  else if (!selected || selection.size() != 1)
    studio.run("select " + node.name);
}

void OutlinerPanel::show_node(Studio& studio, const graph::Node& node, bool tree) {
  const graph::Graph& graph = studio.session().graph();
  const auto& selection = graph.selection();
  const bool filtered = filter_[0] != 0;
  const bool matches =
      !filtered || contains_word(node.name, filter_) || contains_word(node.type->name(), filter_);
  const auto& children = graph.children(node.id);
  bool open = true;
  if (matches) {
    ImGui::PushID(int(node.id.value));
    const bool selected = std::find(selection.begin(), selection.end(), node.id) != selection.end();
    const bool leaf = !tree || children.empty() || filtered;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    open = ImGui::TreeNodeEx("##row", (leaf ? ImGuiTreeNodeFlags_Leaf : 0) |
                                          (selected ? ImGuiTreeNodeFlags_Selected : 0) |
                                          ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_DefaultOpen |
                                          ImGuiTreeNodeFlags_SpanFullWidth | ImGuiTreeNodeFlags_FramePadding |
                                          ImGuiTreeNodeFlags_NoTreePushOnOpen);
    studio.trace.item("node " + node.name, vec2(at.x, at.y), vec2(scaled(120), ImGui::GetFrameHeight()));
    if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) select(studio, node);
    if (tree) drag_and_drop(studio, node);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
      renamed_ = node.id;
      focus_ = true;
      std::snprintf(name_, sizeof name_, "%s", node.name.c_str());
    }
    const std::optional<NodeFailure> failure = failure_of(studio.session(), node.id);
    help(failure ? failure->message : node.type->name() + ": " + node.type->spec().help);
    if (failure) show_badge(studio, node, *failure);
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::SetCursorScreenPos({at.x + scaled(20), at.y});
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float middle = std::round(at.y + ImGui::GetFrameHeight() / 2);
    list->AddRectFilled({at.x + scaled(20), middle - scaled(4)}, {at.x + scaled(28), middle + scaled(4)},
                        node_colour(node.type->name()), scaled(2));
    ImGui::SetCursorScreenPos({at.x + scaled(35), at.y});
    if (renamed_ == node.id) {
      ImGui::SetNextItemWidth(-1.0f);
      if (focus_) ImGui::SetKeyboardFocusHere();
      const bool entered =
          ImGui::InputText("##name", name_, sizeof name_,
                           ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
      if (entered && node.name != name_) studio.run("rename " + node.name + " " + graph::quote(name_));
      if (entered || (!focus_ && ImGui::IsItemDeactivated())) renamed_ = {};
      focus_ = false;
    } else {
      const graph::AttributeIndex seen = graph::visibility_of(*node.schema);
      const bool hidden = seen != graph::no_attribute && graph::number_of(node.value(seen)) == 0.0;
      ImGui::AlignTextToFramePadding();
      if (hidden)
        ImGui::TextDisabled("%s", node.name.c_str());
      else
        ImGui::TextUnformatted(node.name.c_str());
    }
    ImGui::PopID();
  }
  if (!tree || !open) return;
  if (!filtered) ImGui::Indent(scaled(14));
  for (const graph::NodeId child : children) show_node(studio, *graph.find(child), true);
  if (!filtered) ImGui::Unindent(scaled(14));
}

void OutlinerPanel::show(Studio& studio, const PaneRect& pane) {
  const graph::Graph& graph = studio.session().graph();
  begin_pane("##outliner", pane);
  heading("Outliner");
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##filter", "filter", filter_, sizeof filter_);
  ImGui::Dummy({0.0f, scaled(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, 0.0f));
  const std::set<graph::NodeId> top = graph.children({});
  for (const graph::NodeId id : top) show_node(studio, *graph.find(id), true);
  ImGui::Dummy({0.0f, scaled(6)});
  for (const graph::Node* node : graph.nodes())
    if (!node->parent && !top.contains(node->id)) show_node(studio, *node, false);
  ImGui::PopStyleVar();
  // The empty part beneath takes the selection away.
  const ImVec2 left = ImGui::GetContentRegionAvail();
  if (left.y > 4.0f) {
    if (ImGui::InvisibleButton("##nothing", {std::max(left.x, 1.0f), left.y}) && !graph.selection().empty())
      studio.run("select -clear");
    take_dragged(studio, "");
  }
  end_pane();
}

}  // namespace plinian::window
