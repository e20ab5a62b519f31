// Rows of labels, fields and marks.
#include "host/window/panels/attribute_panel.h"

#include <imgui.h>

#include <algorithm>

#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/graph/values/file_path.h"
#include "host/scene/looks.h"
#include "host/window/fields/arithmetic.h"
#include "host/window/fields/edit_lines.h"
#include "host/window/panels/grid_field.h"
#include "host/window/panels/path_field.h"
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
  if (!row.driver.empty()) text += "\nDriven by " + row.driver + ".";
  if (row.locked) text += "\nLocked.";
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

void AttributePanel::show(Studio& studio, const PaneRect& pane) {
  refresh(studio);
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
  for (const AttributeGroup& group : groups_) {
    if (group.depth > 1 && hidden_under) continue;
    ImGui::SetNextItemOpen(group.open, ImGuiCond_Once);
    ImGui::PushStyleColor(ImGuiCol_Header, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
    const bool open = ImGui::TreeNodeEx(group.title.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth |
                                                                 ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                                                 ImGuiTreeNodeFlags_FramePadding);
    ImGui::PopStyleColor();
    if (group.depth == 1) hidden_under = !open;
    if (!open) continue;
    for (const AttributeRow& row : group.rows) show_row(studio, row);
    ImGui::Dummy({0.0f, scaled(4)});
  }
  end_pane();
}

void AttributePanel::show_row(Studio& studio, const AttributeRow& row) {
  const graph::Graph& graph = studio.session().graph();
  ImGui::PushID(row.name.c_str());
  const float whole = ImGui::GetContentRegionAvail().x;
  const float mark = scaled(16), label = std::round(whole * 0.41f);
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  ImGui::AlignTextToFramePadding();
  ImGui::PushClipRect(begin, {begin.x + label - scaled(4), begin.y + ImGui::GetFrameHeight()}, true);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + scaled(14));
  if (row.changed)
    ImGui::TextUnformatted(row.label.c_str());
  else
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(0xffb4b0ae), "%s", row.label.c_str());
  ImGui::PopClipRect();
  help(tooltip(graph, row));
  ImGui::SameLine();
  ImGui::SetCursorScreenPos({begin.x + label, begin.y});
  const float width = whole - label - mark;
  ImGui::BeginGroup();
  show_value(studio, row, width);
  ImGui::EndGroup();
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
    show_colour(studio, row);
  }
}

void AttributePanel::show_colour(Studio& studio, const AttributeRow& row) {
  vec3 linear;
  for (int i = 0; i < 3; ++i) linear[i] = float(number_now(studio, row, row.parts[std::size_t(i)]));
  const float brightest = std::max({linear.x, linear.y, linear.z, 1.0f});
  vec3 shown = display_colour(linear / brightest);
  const ImVec4 colour(shown.x, shown.y, shown.z, 1.0f);
  const float side = ImGui::GetFrameHeight();
  if (ImGui::ColorButton("##swatch", colour, ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoAlpha,
                         {side, side}) &&
      row.driver.empty() && !row.locked) {
    ImGui::OpenPopup("picker");
    merge_key_ = studio.commands.new_merge_key("colour");
  }
  if (!ImGui::BeginPopup("picker")) return;
  ImGui::SetNextItemWidth(scaled(220));
  if (ImGui::ColorPicker3("##picker", &shown.x,
                          ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayRGB |
                              ImGuiColorEditFlags_DisplayHSV | ImGuiColorEditFlags_PickerHueBar)) {
    const vec3 picked = linear_colour(shown) * brightest;
    send(studio, row.plug,
         graph::write_number(picked.x) + " " + graph::write_number(picked.y) + " " +
             graph::write_number(picked.z),
         merge_key_);
    studio.keep_hand_on();
  }
  if (ImGui::IsItemDeactivated()) {
    studio.commands.end_drag();
    merge_key_ = studio.commands.new_merge_key("colour");
  }
  ImGui::EndPopup();
}

}  // namespace plinian::window
