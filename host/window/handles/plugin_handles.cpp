// Places, hits and drags are the SDK's; here they meet the mouse.
#include "host/window/handles/plugin_handles.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/shared/view_curve.h"
#include "host/graph/graph_error.h"
#include "host/scene/placed.h"
#include "host/window/handles/drag_ends.h"
#include "host/window/panels/overlay_text.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

unsigned packed(const vec3& linear, float alpha) {
  unsigned colour = unsigned(std::lround(255.0f * alpha)) << 24;
  for (int i = 0; i < 3; ++i)
    colour |= unsigned(std::lround(255.0f * std::clamp(shared::srgb_from_linear(linear[i]), 0.0f, 1.0f)))
              << (8 * i);
  return colour;
}

}  // namespace

sdk::HandleView handle_view(const Camera& camera, int width, int height, vec2 size, double depth) {
  const CameraRays rays = camera_rays(camera, width, height);
  const dmat3 lens_from_world = glm::inverse(dmat3(dvec3(rays.right), dvec3(rays.up), dvec3(rays.forward)));
  const double near = depth * 1e-3, far = depth * 1e3;
  dmat4 clip_from_lens(0.0);  // (x, y, s) to (x, y, z, s), z / s from -1 at near to 1 at far
  clip_from_lens[0][0] = clip_from_lens[1][1] = clip_from_lens[2][3] = 1.0;
  clip_from_lens[2][2] = (far + near) / (far - near);
  clip_from_lens[3][2] = -2.0 * far * near / (far - near);
  dmat4 lens(lens_from_world);
  lens[3] = dvec4(-(lens_from_world * dvec3(camera.world_from_camera[3])), 1.0);
  return {clip_from_lens * lens,
          {0, 0, std::max(1, int(std::lround(size.x))), std::max(1, int(std::lround(size.y)))}};
}

void PluginHandles::show(Studio& studio, const ViewPicture& picture, vec2 begin, vec2 size, bool free) {
  hovered_.reset();
  if (held_) drag(studio);
  graph::Session& session = studio.session();
  const auto& selection = session.graph().selection();
  if (studio.tools.tool == Tool::select || !studio.overlay.handles || selection.empty()) return;
  const graph::Node& node = *session.graph().find(selection.back());
  const std::vector<sdk::HandleSpec>& specs = studio.workspace.plugins().handles(node.type->name());
  if (specs.empty()) return;
  std::vector<sdk::PlacedHandle> handles;
  const SceneSnapshot& scene = picture.scene;
  const Projection projection(scene.camera, scene.width, scene.height, begin, size);
  dmat4 world_from_object(1.0);
  try {
    world_from_object = scene::Placed(session.graph(), session.evaluator()).world_matrix(node.id);
    if (glm::determinant(dmat3(world_from_object)) == 0.0) return;
    handles = sdk::place_handles(session, node.id, specs, world_from_object);
  } catch (const graph::GraphError&) {
    return;  // the outliner says why
  }
  const auto seen = projection.point(dvec3(world_from_object[3]));
  const sdk::HandleView view =
      handle_view(scene.camera, scene.width, scene.height, size, seen ? seen->depth : 1.0);
  const vec2 scale = size / vec2(view.viewport.z, view.viewport.w);
  const auto on_screen = [&](const dvec2& pixel) {
    return begin + vec2(float(pixel.x), float(view.viewport.w - pixel.y)) * scale;
  };
  const ImGuiIO& io = ImGui::GetIO();
  const vec2 share = (vec2(io.MousePos.x, io.MousePos.y) - begin) / scale;
  const dvec2 mouse(share.x, view.viewport.w - share.y);
  if (free && !held_) hovered_ = sdk::hit_handle(handles, view, mouse, scaled(7));
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(to_im(begin), to_im(begin + size), true);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const sdk::PlacedHandle& handle = handles[i];
    const bool lit = hovered_ == i || (held_ && held_->handle.plug == handle.plug);
    const unsigned colour = !handle.is_free ? 0x8c8c8c8cu
                            : lit           ? 0xff40d8ffu
                                            : packed(handle.spec.colour, 0.95f);
    const auto lines = sdk::handle_lines(handle, view);
    for (const sdk::ScreenLine& line : lines)
      list->AddLine(to_im(on_screen(line.begin)), to_im(on_screen(line.end)), 0x60000000u, scaled(3.2f));
    for (const sdk::ScreenLine& line : lines)
      list->AddLine(to_im(on_screen(line.begin)), to_im(on_screen(line.end)), colour,
                    scaled(lit ? 2.2f : 1.6f));
    if (const auto tip = view.pixel(dvec3(handle.world_from_handle * dvec4(handle.tip, 1.0)))) {
      const vec2 at = on_screen(dvec2(*tip));
      studio.trace.item("handle " + handle.spec.name, at - vec2(3.0f), vec2(6.0f));
      if (lit) draw_text(at + vec2(scaled(9), -scaled(18)), colour::text, handle.spec.name);
    }
  }
  list->PopClipRect();
  if (!hovered_ || !ImGui::IsMouseClicked(0)) return;
  const sdk::PlacedHandle& handle = handles[*hovered_];
  if (!handle.is_free) {
    refuse(studio, session.editor().set_problem(handle.plug));
    return;
  }
  studio.tools.give_up = false;
  held_ = Held{.handle = handle,
               .view = view,
               .begin = begin,
               .size = size,
               .pressed = mouse,
               .last = mouse,
               .merge_key = studio.commands.new_merge_key("handle"),
               .line = "",
               .steps = session.history().steps_made()};
}

void PluginHandles::drag(Studio& studio) {
  Held& held = *held_;
  const graph::Graph& graph = studio.session().graph();
  const bool is_there = graph.find(held.handle.plug.node) != nullptr;
  if (!is_there || studio.tools.give_up || !ImGui::IsMouseDown(0)) {
    if (is_there && studio.tools.give_up) take_back(studio, held.steps);
    if (!held.line.empty()) studio.commands.end_drag();
    studio.tools.give_up = false;
    held_.reset();
    return;
  }
  if (!held.line.empty()) studio.keep_hand_on();
  const ImGuiIO& io = ImGui::GetIO();
  const vec2 share = (vec2(io.MousePos.x, io.MousePos.y) - held.begin) / held.size;
  const dvec2 mouse(share.x * float(held.view.viewport.z), (1.0f - share.y) * float(held.view.viewport.w));
  if (mouse == held.last) return;
  held.last = mouse;
  const std::string line = sdk::drag_command(graph, held.handle, held.view, held.pressed, mouse);
  if (line.empty() || line == held.line) return;
  studio.run(held.line = line, held.merge_key);
  studio.keep_hand_on();
}

}  // namespace plinian::window
