// The light's own placement and what it is under, read; its rotation, set.
#include "host/window/panels/angle_rows.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "host/window/fields/arithmetic.h"
#include "host/window/fields/edit_lines.h"
#include "host/window/navigation/light_angles.h"
#include "host/window/navigation/light_stand.h"
#include "host/window/panels/field_row.h"
#include "host/window/panels/widgets.h"

namespace plinian::window {

namespace {

// As it is now, also where it is driven.
LightStand stand_of(Studio& studio, const graph::Node& light, DrivenValues& driven) {
  const graph::Graph& graph = studio.session().graph();
  return light_stand(graph, light, [&](const graph::Plug& plug) {
    return graph.find(plug.node)->inputs_of(plug.attribute).empty() ? number_at(graph, plug)
                                                                    : driven.number(studio.session(), plug);
  });
}

NumberRange range_of_angle(bool is_azimuth) {
  NumberRange range;
  range.soft_maximum = is_azimuth ? 180.0 : 90.0;
  range.soft_minimum = -*range.soft_maximum;
  range.wraps = is_azimuth;
  if (!is_azimuth) {
    range.minimum = range.soft_minimum;
    range.maximum = range.soft_maximum;
  }
  return range;
}

dvec3 turned_to(const LightStand& light, SkyAngles angles, bool is_azimuth, double value) {
  (is_azimuth ? angles.azimuth : angles.elevation) = value;
  return rotation_toward(angles, light.placement, light.world_from_parent);
}

// Why the light cannot be turned that way; empty where it can.
std::string problem_of(Studio& studio, const graph::Node& node, const LightStand& light,
                       const SkyAngles& angles, bool is_azimuth) {
  const double now = is_azimuth ? angles.azimuth : angles.elevation;
  const dvec3 turned = turned_to(light, angles, is_azimuth, now > 0.0 ? now - 20.0 : now + 20.0);
  const glm::bvec3 stays = glm::lessThan(glm::abs(turned - light.placement.rotate), dvec3(1e-7));
  const bool sets_all = int(stays.x) + int(stays.y) + int(stays.z) < 2;  // see rotate_line()
  for (int i = 0; i < 3; ++i) {
    if (stays[i] && !sets_all) continue;
    const graph::Plug plug{node.id, node.schema->find(std::string("rotate.") + "xyz"[i])};
    if (const std::string problem = studio.session().editor().set_problem(plug); !problem.empty())
      return problem;
  }
  return "";
}

std::string limit_line(const std::string& light, double elevation, double holds) {
  return light + ": an elevation of " + shown_number(elevation) +
         " is out of its range (a number from -90 to 90) and was set to " + shown_number(holds);
}

// The light itself, then the others that are selected.
std::vector<const graph::Node*> lights_of(const graph::Graph& graph, const graph::Node& node) {
  std::vector<const graph::Node*> lights = {&node};
  const auto& selection = graph.selection();
  if (std::find(selection.begin(), selection.end(), node.id) == selection.end()) return lights;
  for (const graph::NodeId id : selection)
    if (const graph::Node& other = *graph.find(id); id != node.id && has_direction(other.type->name()))
      lights.push_back(&other);
  return lights;
}

}  // namespace

void AngleRows::show(Studio& studio, const graph::Node& node, DrivenValues& driven) {
  if (!has_direction(node.type->name())) return;
  show_angle(studio, node, driven, true);
  show_angle(studio, node, driven, false);
}

void AngleRows::show_angle(Studio& studio, const graph::Node& node, DrivenValues& driven, bool is_azimuth) {
  const LightStand light = stand_of(studio, node, driven);
  const std::optional<SkyAngles> angles = sky_angles(light.placement, light.world_from_parent);
  const std::string problem = angles ? problem_of(studio, node, light, *angles, is_azimuth)
                                     : "what " + node.name + " is under is scaled to nothing";
  const graph::AttributeIndex rotate = node.schema->find("rotate");
  const graph::SchemaAttribute& whole = (*node.schema)[rotate];
  const auto any_of = [&](const auto& holds) {
    return std::any_of(whole.children.begin(), whole.children.end(), holds);
  };
  FieldLook look;
  look.unit = "°";
  look.changed = any_of([&](graph::AttributeIndex i) { return node.stored(i) != nullptr; });
  look.driven = any_of([&](graph::AttributeIndex i) { return node.input(i) != nullptr; });
  look.enabled = problem.empty();
  std::string text = is_azimuth
                         ? "Where the light comes from, around +y: 0 from +z, 90 from +x.\nUnit: degrees.  "
                           "Range: -180 to 180, and round again."
                         : "How high the light stands: 0 at the horizon, 90 straight above.\nUnit: degrees.  "
                           "Range: -90 to 90.";
  text += "\nIt sets rotate. L and the mouse in the picture turn both at once.";
  if (!problem.empty()) text += "\n" + problem + ".";

  ImGui::PushID(is_azimuth ? "azimuth" : "elevation");
  look.width = field_label(is_azimuth ? "Azimuth" : "Elevation", look.changed, text);
  const double value = !angles ? 0.0 : is_azimuth ? angles->azimuth : angles->elevation;
  const double shown = std::round(value * 1e4) / 1e4;
  const FieldEdit edit = number_field("##angle", shown, range_of_angle(is_azimuth), look);
  note_item(studio.trace, node.name + (is_azimuth ? " azimuth" : " elevation"));
  help(problem);
  ImGui::PopID();

  const auto turn = [&](double to, const std::string& merge_key) {
    to = is_azimuth ? wrapped(range_of_angle(true), to) : std::clamp(to, -90.0, 90.0);
    for (const graph::Node* other : lights_of(studio.session().graph(), node)) {
      const LightStand stands = stand_of(studio, *other, driven);
      const auto its = sky_angles(stands.placement, stands.world_from_parent);
      if (!its) continue;
      const dvec3 after = turned_to(stands, *its, is_azimuth, to);
      if (const auto line = rotate_line(other->name, stands.placement.rotate, after))
        studio.run(*line, merge_key);
    }
  };
  if (edit.begun) merge_key_ = studio.commands.new_merge_key("drag");
  if (edit.dragged) turn(*edit.dragged, merge_key_);
  if (edit.begun || edit.dragged) studio.keep_hand_on();
  if (edit.ended) studio.commands.end_drag();
  if (!edit.typed) return;
  if (const auto number = typed_number(*edit.typed, shown)) {
    turn(*number, studio.commands.new_merge_key("set"));
    studio.commands.end_drag();
    if (const double holds = is_azimuth ? *number : std::clamp(*number, -90.0, 90.0); holds != *number)
      studio.commands.later([&studio, line = limit_line(node.name, *number, holds)] {
        studio.console.add(LineKind::warning, line);  // behind what it did
      });
  } else {
    studio.console.add(LineKind::error, "'" + *edit.typed + "' is no number of degrees");
  }
}

}  // namespace plinian::window
