// The line between two pictures: where it is, how it is turned, and what lies on its one side.
#pragma once

#include <vector>

#include "core/shared/glue.h"

namespace plinian::window {

struct Wipe {
  vec2 at{0.5f};       // [-] of the picture's sides: a point of the line
  float angle = 0.0f;  // [radians] 0: upright, the other picture on its left; rising turns it clockwise

  /// Of unit length, on the screen (y down), towards the side of the other picture.
  vec2 normal() const;
  /// Along the line, downwards where it is upright.
  vec2 along() const;
  /// How far a point lies on the other's side. begin, size: [points] of the picture; < 0: on this one's.
  float distance(vec2 point, vec2 begin, vec2 size) const;
  /// The part of the picture on the other's side: a convex polygon [points], empty or of three to five
  /// corners.
  std::vector<vec2> other_side(vec2 begin, vec2 size) const;
  /// Goes to where the mouse is, held within the picture.
  void move_to(vec2 point, vec2 begin, vec2 size);
  /// Where its point is not in that part of the picture, the nearest one of the line is taken there or, where
  /// none is near, the line goes there: it can always be taken hold of.
  void keep_within(vec2 part_begin, vec2 part_size, vec2 begin, vec2 size);
  /// Turns so that the line goes through the point. forwards: the point lies along(), else against it.
  void turn_to(vec2 point, vec2 begin, vec2 size, bool forwards);
};

/// The part of a convex polygon within a rectangle [Sutherland and Hodgman 1974]. All in [points].
std::vector<vec2> clipped(std::vector<vec2> polygon, vec2 begin, vec2 size);

}  // namespace plinian::window
