// Ways, turns and factors as commands.
#include "host/window/handles/handle_drag.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/graph/values/value_text.h"
#include "host/window/handles/handle_math.h"

namespace plinian::window {

namespace {

constexpr double snap_degrees = 15.0, snap_factor = 0.1;
constexpr double fine_degrees = 0.01;
constexpr double least_factor = 0.01;       // nothing is squeezed away, nor turned inside out, by hand
constexpr double points_of_doubling = 120;  // [points] of the mouse that double the size

// Decimals that tell multiples of a step.
int decimals(double step) {
  return std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
}

}  // namespace

HandleDrag::HandleDrag(HandleTarget target, Part part, const Projection& projection, dvec2 pressed,
                       float point, double snap)
    : target_(std::move(target)),
      part_(part),
      projection_(projection),
      pressed_(pressed),
      point_(point),
      snap_(snap) {
  for (const TargetNode& node : target_.nodes) changes_.push_back(components_of(target_, node, part_));
}

HandleDrag::Result HandleDrag::to(dvec2 mouse, bool snaps) {
  return target_.tool == Tool::rotate  ? rotated(mouse, snaps)
         : target_.tool == Tool::scale ? scaled(mouse, snaps)
                                       : translated(mouse, snaps);
}

std::vector<std::string> HandleDrag::back() const {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < target_.nodes.size(); ++i) {
    const Placement& placement = target_.nodes[i].placement;
    const dvec3& before = target_.tool == Tool::rotate  ? placement.rotate
                          : target_.tool == Tool::scale ? placement.scale
                                                        : placement.translate;
    add_lines(lines, i, before, before, dvec3(1.0));
  }
  return lines;
}

// What does not change is not set, so that it may be locked. Changes are rounded so that they read well.
void HandleDrag::add_lines(std::vector<std::string>& lines, std::size_t index, const dvec3& before,
                           dvec3 after, const dvec3& step) const {
  const TargetNode& node = target_.nodes[index];
  const std::array<bool, 3>& changes = changes_[index];
  for (int i = 0; i < 3; ++i) {
    const double change = rounded(after[i] - before[i], step[i]);
    after[i] = change == 0.0 ? before[i] : rounded(before[i] + change, step[i] * 1e-4);
  }
  const std::string set = "setAttr " + node.name + "." + attribute_of(target_.tool);
  if (changes[0] && changes[1] && changes[2]) {
    lines.push_back(set + " " + graph::write_number(after.x) + " " + graph::write_number(after.y) + " " +
                    graph::write_number(after.z));
    return;
  }
  for (int i = 0; i < 3; ++i)
    if (changes[std::size_t(i)]) lines.push_back(set + "." + "xyz"[i] + " " + graph::write_number(after[i]));
}

HandleDrag::Result HandleDrag::translated(dvec2 mouse, bool snaps) {
  const HandlePlace& place = target_.place;
  const int axis = axis_of(part_);
  dvec3 way(0.0);  // along the axes of the handle
  if (axis >= 0 && !is_plane(part_)) {
    const auto along = [&](dvec2 at) {
      return along_line(projection_, place.centre, place.axes[axis], place.radius, at);
    };
    way[axis] = along(mouse) - along(pressed_);
  } else {
    const auto met = [&](dvec2 at) {
      if (axis < 0) return beside_point(projection_, place.centre, at);
      const dvec3 normal = glm::normalize(glm::cross(place.axes[(axis + 1) % 3], place.axes[(axis + 2) % 3]));
      return on_plane(projection_, place.centre, normal, at);
    };
    way = glm::inverse(place.axes) * (met(mouse) - met(pressed_));
    if (axis >= 0) way[axis] = 0.0;
  }
  const auto seen = projection_.point(place.centre);
  const double step = snaps ? snap_ : round_step(0.3 * projection_.length_of_point(seen ? seen->depth : 1.0));
  for (int i = 0; i < 3; ++i) way[i] = rounded(way[i], step);
  Result result;
  for (int i = 0; i < 3; ++i)
    if (axis < 0 || is_plane(part_) != (i == axis))
      result.text +=
          fmt::format("{}{} {:+.{}f}", result.text.empty() ? "" : "  ", "xyz"[i], way[i], decimals(step));
  result.text += " m";
  const dvec3 moved = place.axes * way;
  for (std::size_t n = 0; n < target_.nodes.size(); ++n) {
    const TargetNode& node = target_.nodes[n];
    // As fine under its parent as the step is in the world.
    dvec3 fine(1e-9);
    for (int i = 0; i < 3; ++i)
      if (const double size = glm::length(dvec3(node.world_from_parent[i])); size > 0.0)
        fine[i] = round_step(0.1 * step / size);
    add_lines(result.lines, n, node.placement.translate, node.moved(moved), fine);
  }
  return result;
}

HandleDrag::Result HandleDrag::rotated(dvec2 mouse, bool snaps) {
  const HandlePlace& place = target_.place;
  const int axis = axis_of(part_);
  const dvec3 facing = glm::normalize(projection_.eye() - place.centre);
  turn_ = axis < 0
              ? view_turn(projection_, place.centre, pressed_, mouse, turn_)
              : ring_turn(projection_, place.centre, place.axes[axis], place.radius, pressed_, mouse, turn_);
  const double turn = rounded(turn_, snaps ? snap_degrees : fine_degrees);
  Result result;
  result.text = fmt::format("{:.1f}°", turn);
  for (std::size_t n = 0; n < target_.nodes.size(); ++n) {
    const TargetNode& node = target_.nodes[n];
    const dvec3 about = axis < 0                            ? facing
                        : target_.space == AxisSpace::local ? node.own_axes(true)[axis]
                                                            : place.axes[axis];
    add_lines(result.lines, n, node.placement.rotate, node.turned(about, turn), dvec3(fine_degrees));
  }
  return result;
}

HandleDrag::Result HandleDrag::scaled(dvec2 mouse, bool snaps) {
  const HandlePlace& place = target_.place;
  const int axis = axis_of(part_);
  double factor = 1.0;
  if (axis >= 0) {
    const auto along = [&](dvec2 at) {
      return along_line(projection_, place.centre, place.axes[axis], place.radius, at);
    };
    factor = 1.0 + (along(mouse) - along(pressed_)) / place.radius;
  } else {
    // To the right it grows.
    factor = std::exp2(std::clamp((mouse.x - pressed_.x) / (points_of_doubling * point_), -20.0, 20.0));
  }
  factor = snaps ? std::max(rounded(factor, snap_factor), snap_factor)
                 : std::max(rounded(factor, 0.001), least_factor);
  dvec3 factors(1.0);
  for (int i = 0; i < 3; ++i)
    if (axis < 0 || i == axis) factors[i] = factor;
  Result result;
  result.text = fmt::format("×{:.2f}", factor);
  result.stretch = factors;
  for (std::size_t n = 0; n < target_.nodes.size(); ++n) {
    const dvec3& before = target_.nodes[n].placement.scale;
    dvec3 fine(1e-3);
    for (int i = 0; i < 3; ++i)
      if (before[i] != 0.0) fine[i] = round_step(std::abs(before[i])) * 1e-3;
    add_lines(result.lines, n, before, target_.nodes[n].scaled(factors), fine);
  }
  return result;
}

}  // namespace plinian::window
