// What the handles of a tool look like on the screen, and which part of them is under the mouse.
#pragma once

#include <vector>

#include "host/window/handles/tool_choice.h"
#include "host/window/overlay/projection.h"

namespace plinian::window {

/// What can be taken hold of: an axis (its arrow, ring or box), a plane, the centre, the ring that faces the
/// viewer.
enum class Part { none, x, y, z, yz, zx, xy, centre, view };

/// "x", "yz", "centre".
const char* name_of(Part part);
/// 0 to 2 of an axis, or of the axis that stands upright on a plane; -1 of others.
int axis_of(Part part);
bool is_plane(Part part);

struct PartShape {
  Part part = Part::none;
  std::vector<std::vector<vec2>> strokes;  // [points]
  std::vector<std::vector<vec2>> hidden;   // ... of what is behind, which cannot be taken hold of
  std::vector<vec2> area;                  // [points] a convex outline
  float strength = 1.0f;                   // [-] [0, 1], less where it points at the viewer
  bool can_be_taken = true;
};

struct HandlePlace {
  dvec3 centre{0.0};    // [world]
  dmat3 axes{1.0};      // [world] unit columns
  double radius = 1.0;  // [world] length of an axis
};

/// From back to front; empty where the centre is behind the viewer. point: [points] of the screen at the
/// interface's scale. stretch: [-] of the axes, while they are scaled.
std::vector<PartShape> handle_shape(Tool tool, const HandlePlace& place, const Projection& projection,
                                    float point, const dvec3& stretch = dvec3(1.0));

/// The part under the mouse, not further than `reach` [points]. Centre and planes come before axes.
Part part_at(const std::vector<PartShape>& shapes, vec2 mouse, float reach);

/// A point of a part that belongs to it alone; none where there is no such.
std::optional<vec2> grip_of(const std::vector<PartShape>& shapes, const PartShape& shape, float reach);

}  // namespace plinian::window
