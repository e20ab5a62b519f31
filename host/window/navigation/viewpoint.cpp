// Through which camera, and what it shows.
#include "host/window/navigation/viewpoint.h"

#include "host/graph/graph_error.h"

namespace plinian::window {

Camera Viewpoint::camera() const {
  return look.free ? look.free->camera() : feed_.snapshot()->snapshot.camera;
}

FreeCamera Viewpoint::free_camera() const {
  if (look.free) return *look.free;
  const SceneSnapshot& scene = feed_.snapshot()->snapshot;
  return free_camera_at(scene.camera, interest_distance(scene.camera, scene_bounds(scene.media)));
}

void Viewpoint::move(const FreeCamera& camera, bool begins) {
  if (begins) history.note(look);
  look.free = camera;
}

void Viewpoint::look_through_scene_camera() {
  if (!look.free) return;
  history.note(look);
  look.free.reset();
}

void Viewpoint::frame(bool selection_only, ivec2 pane) {
  if (!feed_.snapshot()) return;
  std::vector<Medium> media = feed_.snapshot()->snapshot.media;
  const auto& selection = workspace_.session().graph().selection();
  if (selection_only && !selection.empty()) {
    scene::SceneView view = workspace_.view();
    view.isolated = {selection.begin(), selection.end()};
    try {
      const auto selected = scene::build_snapshot(workspace_.session(), view).snapshot.media;
      if (!selected.empty()) media = selected;
    } catch (const graph::GraphError&) {
      // What cannot be told counts for nothing.
    }
  }
  move(window::frame(free_camera(), scene_bounds(media), pane), true);
}

void Viewpoint::go_back() {
  if (const auto found = history.back(look)) look = *found;
}

void Viewpoint::go_forth() {
  if (const auto found = history.forth(look)) look = *found;
}

}  // namespace plinian::window
