// The hand that magnifies the picture and pans it, and the badge that tells how far.
#pragma once

#include "host/window/panels/picture_places.h"
#include "host/window/studio.h"

namespace plinian::window {

class ZoomHand {
 public:
  /// Takes what the mouse and the keys ask for in this turn. hovered: the mouse is in the viewport. Returns
  /// whether the zoom has changed.
  bool move(Studio& studio, const PicturePlaces& places, bool hovered);
  /// Whether the mouse is its.
  bool is_taken(const Studio& studio) const { return studio.zoom_key_held || held_; }

 private:
  bool held_ = false;
  vec2 pressed_{0.0f}, centre_{0.5f};  // [points] of the mouse; of the picture then
  float wheel_ = 0.0f;                 // [notches] that make no whole step yet
};

/// In the upper left corner, as long as not all of the picture is seen: how large its pixels are, as a share
/// of the screen's. A click shows all of it.
void show_zoom_badge(Studio& studio, const PicturePlaces& places, const PaneRect& pane);
/// What it takes of that corner's first row. [points]
float zoom_badge_width(const PicturePlaces& places);

}  // namespace plinian::window
