// Rows of labels, fields and marks.
#include "host/window/panels/attribute_panel.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/graph/values/file_path.h"
#include "host/scene/looks.h"
#include "host/window/fields/arithmetic.h"
#include "host/window/fields/edit_lines.h"
#include "host/window/panels/field_row.h"
#include "host/window/panels/grid_field.h"
#include "host/window/panels/path_field.h"
#include "host/window/panels/typing.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

using graph::AttributeType;
using graph::Plug;

namespace {

void send(Studio& studio, const Plug& plug, const std::string& words, const std::string& merge_key = "") {
  for (const std::string& line : set_lines(studio.session().graph(), plug, words))
    studio.run(line, merge_key);
}

// Several nodes that are edited by one confirmation are one step of undo, too.
void send_once(Studio& studio, const Plug& plug, const std::string& words) {
  send(studio, plug, words, studio.commands.new_merge_key("set"));
  studio.commands.end_drag();
}

// A path that was typed, whole; empty where there is none.
std::string whole_path(Studio& studio, const std::string& typed) {
  try {
    return graph::expand_path(typed, studio.session().scene_folder());
  } catch (const graph::GraphError&) {
    return "";
  }
}

// What an attribute of the row's node names, whole; empty where there is none.
std::string file_of(Studio& studio, const AttributeRow& row, const std::string& attribute) {
  const graph::Node& node = *studio.session().graph().find(row.plug.node);
  const int index = node.schema->find(attribute);
  const std::string* typed = index < 0 ? nullptr : std::get_if<std::string>(&node.value(index));
  return typed ? whole_path(studio, *typed) : "";
}

std::string short_unit(const std::string& unit) {
  return unit == "degrees" ? "°" : unit.size() <= 6 ? unit : "";
}

// Why it cannot be edited; empty where it can.
std::string why_not(const AttributeRow& row) {
  std::string why;
  if (!row.driver.empty()) why = "Driven by " + row.driver + ".";
  if (row.locked) why += why.empty() ? "Locked." : "\nLocked.";
  return why;
}

std::string tooltip(const graph::Graph& graph, const AttributeRow& row) {
  const graph::AttributeSpec& spec = graph.attribute(row.plug).spec;
  std::string text = row.name;
  if (!spec.help.empty()) text += "\n" + spec.help;
  std::string facts;
  if (!spec.unit.empty()) facts += "Unit: " + spec.unit + ".  ";
  if (spec.minimum || spec.maximum)
    facts += "Range: " + (spec.minimum ? shown_number(*spec.minimum) : "-∞") + " to " +
             (spec.maximum ? shown_number(*spec.maximum) : "∞") + ".  ";
  if (!facts.empty()) text += "\n" + facts;
  if (const std::string why = why_not(row); !why.empty()) text += "\n" + why;
  return text;
}

}  // namespace

double AttributePanel::number_now(Studio& studio, const AttributeRow& row, const Plug& part) {
  return row.driver.empty() ? number_at(studio.session().graph(), part)
                            : driven.number(studio.session(), part);
}

void AttributePanel::refresh(Studio& studio) {
  const graph::Graph& graph = studio.session().graph();
  if (generation_ == graph.generation()) return;
  generation_ = graph.generation();
  groups_.clear();
  node_ = graph.selection().empty() ? graph::NodeId() : graph.selection().back();
  if (const graph::Node* node = graph.find(node_)) groups_ = attribute_groups(graph, *node);
}

void AttributePanel::seek(std::string name) {
  sought_ = std::move(name);
  sought_for_ = 0;
  is_in_sight_ = false;
  expect_typing();
}

// Its node is selected with the next turn, or not at all.
void AttributePanel::begin_seeking() {
  constexpr int most = 8;
  if (ImGui::IsMouseClicked(0) || ImGui::GetIO().MouseWheel != 0.0f) marked_.clear();
  if (sought_.empty()) return;
  if (++sought_for_ > most)
    sought_.clear();
  else
    expect_typing();
}

bool AttributePanel::is_sought(const AttributeGroup& group) const {
  return !sought_.empty() && std::any_of(group.rows.begin(), group.rows.end(),
                                         [&](const AttributeRow& row) { return row.name == sought_; });
}

// Dear ImGui gives no keys to what was out of sight.
void AttributePanel::find_sought(Studio& studio, const AttributeRow& row) {
  if (!std::exchange(is_in_sight_, true)) return ImGui::SetScrollHereY(0.4f);
  studio.trace.note("sought " + row.name);
  want_typing(true);
  marked_ = std::exchange(sought_, "");
}

void AttributePanel::show(Studio& studio, const PaneRect& pane) {
  refresh(studio);
  begin_seeking();
  begin_pane("##attributes", pane);
  const graph::Graph& graph = studio.session().graph();
  const graph::Node* node = graph.find(node_);
  if (!node) {
    heading("Attributes");
    ImGui::Spacing();
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextDisabled("Select a node in the outliner to see what it can be set to.");
    ImGui::PopTextWrapPos();
    end_pane();
    return;
  }
  heading(node->name);
  ImGui::SameLine();
  const std::size_t others = graph.selection().size() - 1;
  ImGui::TextDisabled("%s%s", node->type->name().c_str(),
                      others > 0 ? (" and " + std::to_string(others) + " more").c_str() : "");
  help(node->type->spec().help);
  ImGui::Spacing();
  bool hidden_under = false;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const AttributeGroup& group = groups_[g];
    bool holds = is_sought(group);
    for (std::size_t under = g + 1; under < groups_.size() && groups_[under].depth > group.depth; ++under)
      holds |= is_sought(groups_[under]);
    if (group.depth > 1 && hidden_under) continue;
    ImGui::SetNextItemOpen(group.open || holds, holds ? ImGuiCond_Always : ImGuiCond_Once);
    ImGui::PushStyleColor(ImGuiCol_Header, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
    const bool open = ImGui::TreeNodeEx(group.title.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth |
                                                                 ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                                                 ImGuiTreeNodeFlags_FramePadding);
    ImGui::PopStyleColor();
    if (group.depth == 1) hidden_under = !open;
    if (!open) continue;
    for (const AttributeRow& row : group.rows) {
      show_row(studio, row);
      if (row.plug.attribute == node->schema->find("rotate")) angles_.show(studio, *node, driven);
    }
    ImGui::Dummy({0.0f, scaled(4)});
  }
  end_pane();
}

void AttributePanel::show_row(Studio& studio, const AttributeRow& row) {
  const graph::Graph& graph = studio.session().graph();
  ImGui::PushID(row.name.c_str());
  const float whole = ImGui::GetContentRegionAvail().x, mark = field_mark_width();
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  const float width = field_label(row.label, row.changed, tooltip(graph, row));
  if (row.name == sought_) find_sought(studio, row);
  ImGui::BeginGroup();
  show_value(studio, row, width);
  ImGui::EndGroup();
  want_typing(false);
  if (row.name == marked_)
    ImGui::GetWindowDrawList()->AddRect(
        {begin.x, begin.y - scaled(1)},
        {begin.x + whole - mark, begin.y + ImGui::GetFrameHeight() + scaled(1)}, colour::accent,
        ImGui::GetStyle().FrameRounding);
  studio.trace.item(row.name, vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                    vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
  if (row.changed) {  // a mark that puts it back
    ImGui::SetCursorScreenPos({begin.x + whole - mark, begin.y});
    if (show_changed_dot(mark, "Not at its default; click to put it back.")) {
      const std::string key = studio.commands.new_merge_key("reset");
      for (const std::string& line : reset_lines(graph, row.plug)) studio.run(line, key);
      studio.commands.end_drag();
    }
    studio.trace.item(row.name + " reset", vec2(begin.x + whole - mark, begin.y),
                      vec2(mark, ImGui::GetFrameHeight()));
  }
  ImGui::PopID();
}

void AttributePanel::show_value(Studio& studio, const AttributeRow& row, float width) {
  const graph::Graph& graph = studio.session().graph();
  const graph::AttributeSpec& spec = graph.attribute(row.plug).spec;
  const bool enabled = row.driver.empty() && !row.locked && !spec.read_only;
  if (spec.type == AttributeType::boolean) {
    bool on = number_now(studio, row, row.plug) != 0.0;
    ImGui::BeginDisabled(!enabled);
    if (ImGui::Checkbox("##value", &on)) send_once(studio, row.plug, on ? "true" : "false");
    ImGui::EndDisabled();
  } else if (spec.type == AttributeType::choice) {
    const int now = int(number_now(studio, row, row.plug));
    const auto shown = [](const graph::Choice& c) { return c.label.empty() ? c.word : c.label; };
    std::string current;
    for (const graph::Choice& choice : spec.choices)
      if (choice.value == now) current = shown(choice);
    ImGui::BeginDisabled(!enabled);
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##value", current.c_str(), ImGuiComboFlags_HeightLarge)) {
      for (const graph::Choice& choice : spec.choices)
        if (ImGui::Selectable(shown(choice).c_str(), choice.value == now))
          send_once(studio, row.plug, choice.word);
      ImGui::EndCombo();
    }
    ImGui::EndDisabled();
  } else if (spec.type == AttributeType::node) {
    const graph::NodeId* id =
        std::get_if<graph::NodeId>(&graph.find(row.plug.node)->value(row.plug.attribute));
    const graph::Node* target = id ? graph.find(*id) : nullptr;
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##value", target ? target->name.c_str() : "none")) {
      if (ImGui::Selectable("none", !target)) send_once(studio, row.plug, "none");
      for (const graph::Node* node : graph.nodes())
        if (node->type->name() == spec.name || spec.name != "camera")
          if (ImGui::Selectable(node->name.c_str(), node == target)) send_once(studio, row.plug, node->name);
      ImGui::EndCombo();
    }
  } else if (!row.parts.empty()) {
    show_numbers(studio, row, width);
  } else if (spec.layout.widget == "look") {
    const std::string now = std::get<std::string>(graph.find(row.plug.node)->value(row.plug.attribute));
    ImGui::BeginDisabled(!enabled);
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##value", now.empty() ? "none" : now.c_str())) {
      for (const std::string& look : scene::look_names())
        if (ImGui::Selectable(look.c_str(), look == now))
          studio.run("preset apply " + graph::quote(look) + " " + graph.find(row.plug.node)->name);
      ImGui::EndCombo();
    }
    ImGui::EndDisabled();
  } else if (const auto grid = grid_widget(spec.layout.widget); grid && spec.type == AttributeType::string) {
    const std::string now = std::get<std::string>(graph.find(row.plug.node)->value(row.plug.attribute));
    const std::string path = file_of(studio, row, grid->file);
    const std::string by_name = grid_by_name(studio.session(), row.plug, *grid);
    if (const auto chosen = grid_field(studio, row.name, now, by_name, *grid, path, width, enabled))
      send_once(studio, row.plug, graph::quote(*chosen));
  } else if (spec.type == AttributeType::path) {
    const std::string now =
        std::get<std::string>(graph.find(row.plug.node)->value(row.plug.attribute, row.plug.element));
    const auto set = [&studio, plug = row.plug](const std::string& path) {
      if (studio.session().graph().find(plug.node)) send_once(studio, plug, graph::quote(path));
    };
    if (const auto typed = path_field(studio,
                                      {.name = row.name,
                                       .typed = now,
                                       .path = whole_path(studio, now),
                                       .extensions = file_widget(spec.layout.widget),
                                       .width = width,
                                       .enabled = enabled},
                                      set))
      set(*typed);
  } else {
    const bool text = spec.type == AttributeType::string;
    const graph::Value& value = graph.find(row.plug.node)->value(row.plug.attribute);
    const std::string* held = text ? std::get_if<std::string>(&value) : nullptr;
    if (const auto typed = text_field("##value", held ? *held : words_at(graph, row.plug), width, enabled))
      send_once(studio, row.plug, text ? graph::quote(*typed) : *typed);
  }
}

void AttributePanel::show_numbers(Studio& studio, const AttributeRow& row, float width) {
  const graph::Graph& graph = studio.session().graph();
  const graph::AttributeSpec& whole = graph.attribute(row.plug).spec;
  const bool is_colour = whole.type == AttributeType::colour;
  const float gap = scaled(3), swatch = is_colour ? ImGui::GetFrameHeight() + gap : 0.0f;
  const float each =
      std::floor((width - swatch - gap * float(row.parts.size() - 1)) / float(row.parts.size()));
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    const Plug& part = row.parts[i];
    const graph::AttributeSpec& spec = graph.attribute(part).spec;
    if (i > 0) ImGui::SameLine(0.0f, gap);
    FieldLook look;
    look.width = each;
    look.changed = row.changed;
    look.driven = !row.driver.empty();
    look.enabled = row.driver.empty() && !row.locked && !whole.read_only;
    // Three numbers beside one another have no room for more than themselves.
    if (row.parts.size() == 1) look.unit = short_unit(spec.unit);
    const double value = number_now(studio, row, part);
    const FieldEdit edit = number_field(("##" + std::to_string(i)).c_str(), value, range_of(spec), look);
    studio.trace.item(graph.name_of(part), vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                      vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
    if (edit.begun) merge_key_ = studio.commands.new_merge_key("drag");
    if (edit.dragged) send(studio, part, graph::write_number(*edit.dragged), merge_key_);
    if (edit.begun || edit.dragged) studio.keep_hand_on();
    if (edit.ended) studio.commands.end_drag();
    if (edit.typed) {
      const std::optional<double> number = typed_number(*edit.typed, value);
      if (!number || *number != value)
        send_once(studio, part, number ? graph::write_number(*number) : *edit.typed);
    }
  }
  if (!merge_key_.empty() && ImGui::IsMouseDown(0) && ImGui::IsAnyItemActive() &&
      !ImGui::GetIO().WantTextInput && studio.is_hand_on())
    studio.keep_hand_on();
  if (is_colour) {
    ImGui::SameLine(0.0f, gap);
    ColourField field{.name = row.name, .plug = row.plug};
    for (std::size_t i = 0; i < 3; ++i) field.linear[int(i)] = float(number_now(studio, row, row.parts[i]));
    field.enabled = row.driver.empty() && !row.locked && !whole.read_only;
    field.help = why_not(row);
    picker_.show(studio, field);
  }
}

}  // namespace plinian::window
