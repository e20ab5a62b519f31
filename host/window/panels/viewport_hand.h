// The hand in the picture: moves the camera, and turns the key light.
#pragma once

#include "host/window/drawing/pane_rect.h"
#include "host/window/navigation/light_stand.h"
#include "host/window/studio.h"

namespace plinian::window {

class ViewportHand {
 public:
  /// Takes what the mouse does in this turn. picture: [points] where it is. hovered: the mouse is in the
  /// viewport, and nobody else's.
  void move(Studio& studio, const PaneRect& picture, bool hovered);

 private:
  enum class Hold { nothing, tumble, track, dolly, light };
  void turn_light(Studio& studio, dvec2 mouse);

  Hold hold_ = Hold::nothing;
  bool moved_ = false;
  dvec2 last_{0.0}, pressed_{0.0};  // [points] of the mouse
  graph::NodeId light_;             // that is turned
  LightStand light_start_;          // when the mouse was pressed
  std::string merge_key_;
};

}  // namespace plinian::window
