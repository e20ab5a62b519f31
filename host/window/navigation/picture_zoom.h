// The picture under a magnifying glass: how much larger it is shown than it fits its place, and what of it is
// in the middle there. The camera stays where it is, and the picture keeps its pixels.
#pragma once

#include "host/window/drawing/pane_rect.h"

namespace plinian::window {

class PictureZoom {
 public:
  static constexpr int most_steps = 10;  // each of the square root of 2

  float factor() const;  // [-] 1 to 32
  bool is_on() const { return steps_ > 0; }
  vec2 centre() const { return centre_; }  // [-] of the picture's sides

  /// Where the picture lies that would lie at `whole`. [points]
  PaneRect magnified(const PaneRect& whole) const;
  /// Goes in, or out where steps < 0. What is seen at `at` [points] stays there; on the way out only as far
  /// as the picture reaches.
  void step(int steps, vec2 at, const PaneRect& whole);
  /// The picture follows a hand that went `way` [points] since `centre` was in the middle.
  void pan(vec2 centre, vec2 way, const PaneRect& whole);

 private:
  void look_at(vec2 centre);

  int steps_ = 0;
  vec2 centre_{0.5f};
};

}  // namespace plinian::window
