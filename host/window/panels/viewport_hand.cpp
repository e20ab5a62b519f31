// From the mouse to the camera and the light.
#include "host/window/panels/viewport_hand.h"

#include <imgui.h>

#include <algorithm>

#include "host/window/fields/edit_lines.h"
#include "host/window/navigation/key_light.h"
#include "host/window/navigation/light_angles.h"

namespace plinian::window {

namespace {

LightStand stand_of(const graph::Graph& graph, graph::NodeId light) {
  return light_stand(graph, *graph.find(light),
                     [&](const graph::Plug& plug) { return number_at(graph, plug); });
}

}  // namespace

void ViewportHand::move(Studio& studio, const PaneRect& picture, bool hovered) {
  if (!studio.feed.snapshot()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const dvec2 mouse(io.MousePos.x, io.MousePos.y);
  const ivec2 pane(std::max(1.0f, picture.size.x), std::max(1.0f, picture.size.y));
  // Alt, and Ctrl+Alt where the desktop keeps Alt to itself.
  if (hovered && hold_ == Hold::nothing && io.KeyAlt) {
    if (ImGui::IsMouseClicked(0)) hold_ = Hold::tumble;
    if (ImGui::IsMouseClicked(2)) hold_ = Hold::track;
    if (ImGui::IsMouseClicked(1)) hold_ = Hold::dolly;
    moved_ = false;
    last_ = mouse;
  }
  if (hovered && hold_ == Hold::nothing && studio.light_key_held && studio.commands.job.what.empty() &&
      ImGui::IsMouseClicked(0)) {
    light_ = light_to_turn(studio.session().graph());
    if (light_) {
      hold_ = Hold::light;
      moved_ = false;
      last_ = pressed_ = mouse;
      light_start_ = stand_of(studio.session().graph(), light_);
      merge_key_ = studio.commands.new_merge_key("light");
    }
  }
  if (hold_ == Hold::light) {
    turn_light(studio, mouse);
  } else if (hold_ != Hold::nothing) {
    const int button = hold_ == Hold::tumble ? 0 : hold_ == Hold::track ? 2 : 1;
    const dvec2 delta = mouse - last_;
    if (delta != dvec2(0.0)) {
      const FreeCamera camera = studio.viewpoint.free_camera();
      studio.viewpoint.move(hold_ == Hold::tumble  ? tumble(camera, delta)
                            : hold_ == Hold::track ? track(camera, delta, pane)
                                                   : dolly(camera, delta.x - delta.y),
                            !moved_);
      moved_ = true;
      last_ = mouse;
    }
    if (moved_) studio.keep_hand_on();
    if (!ImGui::IsMouseDown(button)) hold_ = Hold::nothing;
  } else if (hovered && io.MouseWheel != 0.0f) {
    constexpr double points_per_notch = 100.0 / 7.0;
    studio.viewpoint.move(dolly(studio.viewpoint.free_camera(), io.MouseWheel * points_per_notch),
                          !studio.is_hand_on());
    studio.keep_hand_on();
  }
}

// The whole drag is one edit: from where the light stood to where the mouse is.
void ViewportHand::turn_light(Studio& studio, dvec2 mouse) {
  const graph::Node* node = studio.session().graph().find(light_);
  if (!node || !ImGui::IsMouseDown(0)) {
    if (moved_) studio.commands.end_drag();
    hold_ = Hold::nothing;
    return;
  }
  if (moved_) studio.keep_hand_on();
  if (mouse == last_) return;
  if (const auto rotation = turned_light(light_start_, mouse - pressed_))
    studio.run(rotate_line(node->name, *rotation), merge_key_);
  studio.keep_hand_on();
  moved_ = true;
  last_ = mouse;
}

}  // namespace plinian::window
