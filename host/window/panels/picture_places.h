// Where in the pane the picture lies, and the one that it is compared with.
#pragma once

#include "host/window/drawing/pane_rect.h"
#include "host/window/navigation/picture_zoom.h"

namespace plinian::window {

/// All of it [points]. The other's are the picture's own but side by side.
struct PicturePlaces {
  PaneRect whole;             // of the picture, where nothing is magnified
  PaneRect picture, other;    // where they lie; magnified, partly beyond their rooms
  PaneRect room, other_room;  // the parts of the pane where they can be seen
  bool is_magnified = false;
  float pixel_side = 1.0f;     // [pixels of the screen] of one of the picture at rest
  bool shows_squares = false;  // it is so large that pixels are told apart

  /// Whether a point is in the half of the other, side by side.
  bool is_over_other(vec2 at) const { return !holds(room, at) && holds(other_room, at); }
  /// From a point over the other picture to the one that shows the same of this; 0 elsewhere.
  vec2 way_to_picture(vec2 at) const { return is_over_other(at) ? picture.begin - other.begin : vec2(0.0f); }
};

/// size: of the picture as it fits into the pane. pixels: that it has along x, at rest. gap: between the two,
/// side by side. Magnified it begins at a pixel of the screen, so that all of its pixels come out alike.
/// pixel_ratio: pixels per point.
PicturePlaces picture_places(const PaneRect& pane, vec2 size, int pixels, bool side_by_side, float gap,
                             const PictureZoom& zoom, float pixel_ratio);

}  // namespace plinian::window
