// A row for each light.
#include "host/window/panels/light_panel.h"

#include <imgui.h>

#include <algorithm>

#include "core/media/blackbody.h"
#include "host/graph/model/conversion.h"
#include "host/graph/model/hierarchy.h"
#include "host/window/fields/arithmetic.h"
#include "host/window/fields/edit_lines.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

bool is_light(const graph::Node& node) {
  const std::string& type = node.type->name();
  return node.schema->find("exposure") != graph::no_attribute && type.find("Light") != type.npos;
}

}  // namespace

// Where a temperature says the colour, it is shown and stays.
void LightPanel::show_colour(Studio& studio, const graph::Node& node, DrivenValues& driven) {
  const graph::AttributeIndex colour = node.schema->find("colour");
  if (colour == graph::no_attribute) return ImGui::Dummy({ImGui::GetFrameHeight(), 0.0f});
  const auto number = [&](const graph::Plug& plug) {
    return node.inputs_of(plug.attribute).empty() ? number_at(studio.session().graph(), plug)
                                                  : driven.number(studio.session(), plug);
  };
  const graph::Plug plug{node.id, colour};
  ColourField field{.name = node.name + ".colour", .plug = plug};
  const graph::AttributeIndex by_kelvin = node.schema->find("use_kelvin");
  if (by_kelvin != graph::no_attribute && number({node.id, by_kelvin}) != 0.0) {
    const double kelvin = number({node.id, node.schema->find("kelvin")});
    field.linear = planck_colour(std::max(kelvin, 1.0));
    field.enabled = false;
    field.help = "The colour of a black body of " + shown_number(kelvin) + " K: use_kelvin is on.";
  } else {
    for (int c = 0; c < 3; ++c) field.linear[c] = float(number({node.id, colour, -1, c}));
    const std::string problem = studio.session().editor().set_problem(plug);
    field.enabled = problem.empty();
    field.help = problem;
  }
  picker_.show(studio, field);
}

void LightPanel::show_light(Studio& studio, const graph::Node& node, DrivenValues& driven) {
  const graph::Graph& graph = studio.session().graph();
  ImGui::PushID(int(node.id.value));
  const graph::AttributeIndex seen = graph::visibility_of(*node.schema);
  bool on = seen == graph::no_attribute || graph::number_of(node.value(seen)) != 0.0;
  const auto trace = [&](const char* what) {
    studio.trace.item("light " + node.name + " " + what,
                      vec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y),
                      vec2(ImGui::GetItemRectSize().x, ImGui::GetItemRectSize().y));
  };
  if (ImGui::Checkbox("##on", &on))
    studio.run("setAttr " + node.name + ".visibility " + (on ? "true" : "false"));
  help("Whether it shines.");
  trace("on");
  ImGui::SameLine(0.0f, scaled(4));
  std::set<std::string>& solo = studio.development.solo;
  const bool sky = node.type->name() == "ambientLight";
  bool& ambient = studio.development.solo_ambient;
  if (toggle("S", sky ? ambient : solo.contains(node.name),
             "See only what this one lights, and others with a lit S.")) {
    if (sky)
      ambient = !ambient;
    else if (!solo.erase(node.name))
      solo.insert(node.name);
  }
  trace("solo");
  ImGui::SameLine(0.0f, scaled(6));
  const float field = scaled(80), swatch = ImGui::GetFrameHeight() + scaled(4), left = ImGui::GetCursorPosX();
  const bool selected = std::count(graph.selection().begin(), graph.selection().end(), node.id) > 0;
  ImGui::AlignTextToFramePadding();
  const float room = ImGui::GetContentRegionAvail().x - field - swatch - scaled(6);
  if (ImGui::Selectable(node.name.c_str(), selected, 0, {room, 0.0f})) studio.run("select " + node.name);
  ImGui::SameLine();
  ImGui::SetCursorPosX(left + room + scaled(6));
  show_colour(studio, node, driven);
  ImGui::SameLine();
  ImGui::SetCursorPosX(left + room + swatch + scaled(6));
  const graph::AttributeIndex exposure = node.schema->find("exposure");
  const graph::Plug plug{node.id, exposure};
  FieldLook look;
  look.width = field;
  look.unit = "stops";
  look.changed = node.stored(exposure) != nullptr;
  look.driven = node.input(exposure) != nullptr;
  look.enabled = !look.driven && !node.is_locked(exposure);
  const double value = look.driven ? driven.number(studio.session(), plug) : number_at(graph, plug);
  const FieldEdit edit = number_field("##exposure", value, range_of(graph.attribute(plug).spec), look);
  trace("exposure");
  if (edit.begun) merge_key_ = studio.commands.new_merge_key("drag");
  if (edit.dragged)
    studio.run("setAttr " + node.name + ".exposure " + graph::write_number(*edit.dragged), merge_key_);
  if (edit.begun || edit.dragged) studio.keep_hand_on();
  if (edit.ended) studio.commands.end_drag();
  if (edit.typed)
    if (const auto number = typed_number(*edit.typed, value))
      studio.run("setAttr " + node.name + ".exposure " + graph::write_number(*number));
  ImGui::PopID();
}

void LightPanel::show(Studio& studio, const PaneRect& pane, DrivenValues& driven) {
  begin_pane("##lights", pane);
  heading("Lights");
  const graph::Graph& graph = studio.session().graph();
  bool any = false;
  for (const graph::Node* node : graph.nodes())
    if (is_light(*node)) {
      show_light(studio, *node, driven);
      any = true;
    }
  // A light that is gone is not seen alone any more.
  std::erase_if(studio.development.solo, [&](const std::string& name) { return !graph.find(name); });
  if (!any) ImGui::TextDisabled("The scene has none.");
  end_pane();
}

}  // namespace plinian::window
