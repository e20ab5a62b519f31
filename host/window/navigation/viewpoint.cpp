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
  waiting_.reset();
  if (begins) history.note(look);
  look.free = camera;
}

void Viewpoint::look_through_scene_camera() {
  if (!look.free) return;
  history.note(look);
  look.free.reset();
}

void Viewpoint::begin_anew() {
  look = {};
  zoom = {};
}

void Viewpoint::frame(bool selection_only, ivec2 pane) {
  if (!feed_.snapshot()) return;
  std::vector<Medium> media = feed_.snapshot()->snapshot.media;
  const auto& selection = workspace_.session().graph().selection();
  if (selection_only && !selection.empty()) {
    scene::SceneView view = workspace_.view();
    view.isolated = {selection.begin(), selection.end()};
    try {
      if (!knows_bounds(view)) {
        waiting_ = pane;
        return;
      }
      const auto selected = scene::build_snapshot(workspace_.session(), view).snapshot.media;
      if (!selected.empty()) media = selected;
    } catch (const graph::GraphError&) {
      // What cannot be told counts for nothing.
    }
  }
  zoom = {};
  move(window::frame(free_camera(), scene_bounds(media), pane), true);
}

void Viewpoint::update() {
  if (waiting_) frame(true, *waiting_);
}

// Else workers are asked, who may be at it for the picture already.
bool Viewpoint::knows_bounds(const scene::SceneView& view) {
  if (feed_.is_computing() || request_ != 0) return false;
  graph::Evaluator& evaluator = workspace_.session().evaluator();
  std::vector<graph::Plug> missing = scene::contributing_plugs(workspace_.session(), view);
  std::erase_if(missing, [&](const graph::Plug& plug) { return !evaluator.is_dirty(plug); });
  if (missing.empty()) return true;
  request_ = evaluator.request(std::move(missing), [this](const graph::Evaluator::Outcome& outcome) {
    request_ = 0;
    if (outcome.cancelled) waiting_.reset();
  });
  return false;
}

void Viewpoint::go_back() {
  if (const auto found = history.back(look)) look = *found;
}

void Viewpoint::go_forth() {
  if (const auto found = history.forth(look)) look = *found;
}

}  // namespace plinian::window
