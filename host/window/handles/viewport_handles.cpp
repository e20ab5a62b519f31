// Between the mouse and the commands.
#include "host/window/handles/viewport_handles.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/scene/framing.h"
#include "host/window/handles/drag_ends.h"
#include "host/window/handles/handle_painter.h"
#include "host/window/overlay/ground_grid.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

constexpr float axis_length = 92.0f, reach = 7.0f;  // [points]
constexpr double slowness = 10.0;                   // [-] of the mouse while Shift is held

dvec2 mouse_at() {
  const ImGuiIO& io = ImGui::GetIO();
  return {io.MousePos.x, io.MousePos.y};
}

// A sun is turned where its icon stands.
void settle_sun(Studio& studio, const SceneBounds& bounds, HandleTarget& target) {
  const TargetNode& lead = target.nodes[0];
  const graph::Node* node = studio.session().graph().find(lead.id);
  if (node->type->name() != "directionalLight") return;
  const dvec3 toward(dmat3(lead.world_from_parent) * dvec3(matrix_of(lead.placement)[2]));
  const double length = glm::length(toward);
  if (!(length > 0.0)) return;
  target.place.centre = bounds.centre() + toward * (bounds.radius() * 1.1 / length);
}

// The camera that is looked through stands in the eye, where it cannot be taken hold of.
bool is_looked_through(Studio& studio, const HandleTarget& target, const Projection& projection) {
  const TargetNode& lead = target.nodes[0];
  const dvec3 at(lead.world_from_parent * matrix_of(lead.placement)[3]);
  return studio.session().graph().find(lead.id)->type->name() == "camera" &&
         glm::length(at - projection.eye()) < 1e-6 * (1.0 + glm::length(at));
}

// A tenth of a cell of the ground. [world]
double snap_step(const SceneBounds& bounds, const Projection& projection) {
  const double away = std::max(glm::length(bounds.centre() - projection.eye()), 1e-3);
  return 0.1 * round_length(away * 0.12);
}

}  // namespace

void ViewportHandles::show(Studio& studio, const ViewPicture& picture, vec2 begin, vec2 size, bool free) {
  const ImGuiIO& io = ImGui::GetIO();
  free &= !io.KeyAlt && !studio.light_key_held && !studio.inspector.on && studio.commands.job.what.empty();
  hovered_ = Part::none;
  if (held_) drag(studio);
  plugins_.show(studio, picture, begin, size, free && !held_);
  free &= !plugins_.is_taken();
  studio.tools.is_dragging = held_ || plugins_.is_held();

  std::optional<HandleTarget> target;
  const SceneSnapshot& scene = picture.scene;
  const Projection seen_now(scene.camera, scene.width, scene.height, begin, size);
  if (held_) {
    target = held_->drag.target();
  } else if (studio.overlay.handles && studio.tools.tool != Tool::select) {
    target = handle_target(studio.session(), studio.tools);
    if (!target || is_looked_through(studio, *target, seen_now)) return;
    settle_sun(studio, picture.extent->all(), *target);
  }
  if (!target) return;
  // While it is held, a thing that is moved takes its handles along; what is turned leaves them where they
  // are.
  if (held_ && target->tool == Tool::translate)
    if (const auto now = handle_target(studio.session(), studio.tools);
        now && now->nodes[0].id == target->nodes[0].id)
      target->place.centre = now->place.centre;
  const auto seen = seen_now.point(target->place.centre);
  if (!seen) return;
  target->place.radius = seen_now.length_of_point(seen->depth) * scaled(axis_length);
  if (!std::isfinite(target->place.radius)) return;

  const auto shapes =
      handle_shape(target->tool, target->place, seen_now, scaled(1), held_ ? held_->now.stretch : dvec3(1.0));
  if (free && !held_) hovered_ = part_at(shapes, vec2(mouse_at()), scaled(reach));
  std::vector<bool> grey(std::size_t(Part::view) + 1);
  if (!held_)
    for (const PartShape& shape : shapes)
      grey[std::size_t(shape.part)] =
          !target_problem(studio.session(), *target, target->nodes[0], shape.part).empty();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(to_im(begin), to_im(begin + size), true);
  paint_handles(shapes, held_ ? held_->drag.part() : hovered_, grey, held_.has_value());
  if (held_ && held_->moved) paint_readout(vec2(held_->last), held_->now.text);
  list->PopClipRect();
  if (studio.trace.is_on())
    for (const PartShape& shape : shapes)
      if (const auto grip = grip_of(shapes, shape, scaled(reach)))
        studio.trace.item(std::string("handle ") + name_of(shape.part), *grip - vec2(2.0f), vec2(4.0f));
  if (hovered_ != Part::none && ImGui::IsMouseClicked(0))
    take_hold(studio, std::move(*target), seen_now, snap_step(picture.extent->all(), seen_now));
}

// What cannot follow stays where it is, and says why; where that is what leads, nothing moves.
void ViewportHandles::take_hold(Studio& studio, HandleTarget target, const Projection& projection,
                                double snap) {
  std::vector<TargetNode> able;
  for (std::size_t i = 0; i < target.nodes.size(); ++i) {
    const std::string problem = target_problem(studio.session(), target, target.nodes[i], hovered_);
    if (!problem.empty()) refuse(studio, problem);
    if (!problem.empty() && i == 0) return;
    if (problem.empty()) able.push_back(target.nodes[i]);
  }
  target.nodes = std::move(able);
  const dvec2 mouse = mouse_at();
  Held& held = held_.emplace(HandleDrag(std::move(target), hovered_, projection, mouse, scaled(1), snap));
  held.mouse = held.last = mouse;
  held.merge_key = studio.commands.new_merge_key("handle");
  held.steps = studio.session().history().steps_made();
  studio.tools.is_dragging = true;
  studio.tools.give_up = false;
}

void ViewportHandles::let_go(Studio& studio, bool take_it_back) {
  if (take_it_back) take_back(studio, held_->steps);
  if (held_->moved) studio.commands.end_drag();
  studio.tools.give_up = false;
  held_.reset();
}

void ViewportHandles::drag(Studio& studio) {
  const graph::Graph& graph = studio.session().graph();
  for (const TargetNode& node : held_->drag.target().nodes)
    if (const graph::Node* found = graph.find(node.id); !found || found->name != node.name)
      return let_go(studio, false);
  if (studio.tools.give_up) return let_go(studio, true);
  if (!ImGui::IsMouseDown(0)) return let_go(studio, false);
  if (held_->moved) studio.keep_hand_on();
  const ImGuiIO& io = ImGui::GetIO();
  const dvec2 mouse = mouse_at(), way = mouse - held_->last;
  if (way == dvec2(0.0) && (io.KeyCtrl == held_->snapped || !held_->moved)) return;
  held_->mouse = io.KeyShift || held_->mouse != held_->last
                     ? held_->mouse + (io.KeyShift ? way / slowness : way)
                     : mouse;
  held_->last = mouse;
  held_->snapped = io.KeyCtrl;
  held_->now = held_->drag.to(held_->mouse, io.KeyCtrl);
  for (const std::string& line : held_->now.lines) studio.run(line, held_->merge_key);
  studio.keep_hand_on();
  held_->moved = true;
}

}  // namespace plinian::window
