// Where the scene is looked at from: through a camera of the scene, or through the artist's own. No part of
// the scene, nor of its undo.
#pragma once

#include <optional>

#include "host/scene/workspace.h"
#include "host/window/navigation/camera_history.h"
#include "host/window/navigation/picture_zoom.h"
#include "host/window/view/scene_feed.h"

namespace plinian::window {

class Viewpoint {
 public:
  Viewpoint(scene::Workspace& workspace, const SceneFeed& feed) : workspace_(workspace), feed_(feed) {}

  Look look;
  CameraHistory history;
  PictureZoom zoom;

  /// The camera that is looked through; needs a snapshot.
  Camera camera() const;
  /// The free camera, made of what is looked through where there is none yet; needs a snapshot.
  FreeCamera free_camera() const;
  /// Looks through `camera` from now on. begins: notes for `[` how it was.
  void move(const FreeCamera& camera, bool begins);
  void look_through_scene_camera();
  /// As what is another scene is looked at first: through its camera, all of the picture.
  void begin_anew();
  /// Shows everything, or what is selected, as soon as it is known how large that is, in a picture of which
  /// all is seen. pane: [pixels] of the picture.
  void frame(bool selection_only, ivec2 pane);
  /// Frames what was waited for. To be called once a turn.
  void update();
  bool is_waiting() const { return waiting_.has_value(); }
  void stop_waiting() { waiting_.reset(); }
  /// The view before or after in the history, where there is one.
  void go_back();
  void go_forth();

 private:
  bool knows_bounds(const scene::SceneView& view);

  scene::Workspace& workspace_;
  const SceneFeed& feed_;
  std::optional<ivec2> waiting_;  // pane of a selection that is to be framed
  graph::Evaluator::RequestId request_ = 0;
};

}  // namespace plinian::window
