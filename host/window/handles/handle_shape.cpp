// Arrows, squares, rings and boxes.
#include "host/window/handles/handle_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/window/handles/handle_math.h"

namespace plinian::window {

namespace {

constexpr double two_pi = 6.283185307179586;
constexpr int ring_sides = 96;
constexpr double gap = 0.12;  // [of the radius] free around the centre

class Drawing {
 public:
  Drawing(const HandlePlace& place, const Projection& projection, float point)
      : place_(place), projection_(projection), point_(point) {}

  std::vector<PartShape> shapes;

  // Sorted by how far away their tips are.
  void add_axes(bool arrows, const dvec3& stretch) {
    struct Axis {
      int axis;
      double away;
    } axes[3];
    for (int i = 0; i < 3; ++i)
      axes[i] = {i, glm::length(place_.centre + place_.axes[i] * place_.radius - projection_.eye())};
    std::sort(std::begin(axes), std::end(axes), [](Axis a, Axis b) { return a.away > b.away; });
    for (const Axis& axis : axes) add_axis(axis.axis, arrows, stretch[axis.axis]);
  }

  void add_plane(Part part) {
    constexpr double inner = 0.30, outer = 0.46;  // [of the radius]
    const int normal = axis_of(part);
    const dvec3 &u = place_.axes[(normal + 1) % 3], &v = place_.axes[(normal + 2) % 3];
    PartShape shape{.part = part};
    for (const auto& [a, b] : {std::pair(inner, inner), std::pair(outer, inner), std::pair(outer, outer),
                               std::pair(inner, outer)}) {
      const auto seen = at(u * a + v * b);
      if (!seen) return;
      shape.area.push_back(*seen);
    }
    const dvec3 upright = glm::cross(u, v);
    const double length = glm::length(upright);
    if (!(length > 0.0)) return;
    fade(shape, openness_of_plane(projection_, place_.centre, upright / length));
    shapes.push_back(std::move(shape));
  }

  void add_centre() {
    if (const auto seen = at(dvec3(0.0))) shapes.push_back({.part = Part::centre, .area = box(*seen, 5.5f)});
  }

  // Where a ring passes behind its centre it is hidden.
  void add_ring(Part part, const dvec3& u, const dvec3& v) {
    PartShape shape{.part = part};
    const dvec3 sight = place_.centre - projection_.eye();
    int side = -1;
    std::optional<vec2> before;
    for (int i = 0; i <= ring_sides; ++i) {
      const double angle = two_pi * i / ring_sides;
      const dvec3 out = u * std::cos(angle) + v * std::sin(angle);
      const auto seen = at(out);
      const int now = part != Part::view && glm::dot(out, sight) > 1e-9 * glm::length(sight) ? 1 : 0;
      if (seen) {
        auto& lines = now ? shape.hidden : shape.strokes;
        if (now != side || !before) {
          lines.emplace_back();
          if (before) lines.back().push_back(*before);
        }
        lines.back().push_back(*seen);
      }
      side = now;
      before = seen;
    }
    shapes.push_back(std::move(shape));
  }

  void add_rings() {
    const dvec3 sight = glm::normalize(place_.centre - projection_.eye());
    const dvec3 u =
        glm::normalize(glm::cross(sight, std::abs(sight.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    constexpr double outside = 1.18;
    add_ring(Part::view, u * outside, glm::cross(u, sight) * outside);
    for (int i = 0; i < 3; ++i) {
      const dvec3& axis = place_.axes[i];
      const dvec3 across = glm::normalize(
          glm::cross(axis, std::abs(glm::dot(axis, sight)) < 0.999 ? sight : place_.axes[(i + 1) % 3]));
      add_ring(Part(int(Part::x) + i), across, glm::cross(axis, across));
    }
  }

 private:
  std::optional<vec2> at(const dvec3& offset) const {
    const auto seen = projection_.point(place_.centre + offset * place_.radius);
    return seen ? std::optional(seen->at) : std::nullopt;
  }

  std::vector<vec2> box(vec2 middle, float half) const {
    const float h = half * point_;
    return {middle + vec2(-h, -h), middle + vec2(h, -h), middle + vec2(h, h), middle + vec2(-h, h)};
  }

  // What is seen from its end or its side fades out, and cannot be taken hold of.
  void fade(PartShape& shape, double openness) const {
    const double share = std::clamp((openness - 0.1) / 0.15, 0.0, 1.0);
    shape.strength = float(share * share * (3.0 - 2.0 * share));
    shape.can_be_taken = shape.strength > 0.3f;
  }

  void add_axis(int axis, bool arrow, double stretch) {
    const dvec3& along = place_.axes[axis];
    PartShape shape{.part = Part(int(Part::x) + axis)};
    const auto begin = at(along * gap), end = at(along * stretch);
    if (!begin || !end) return;
    fade(shape, openness_of_line(projection_, place_.centre, along));
    if (shape.strength <= 0.0f) return;
    const vec2 way = *end - *begin;
    const float length = std::max(glm::length(way), 1e-3f);
    const vec2 forward = way / length, side = vec2(-forward.y, forward.x) * (4.5f * point_);
    const vec2 base = *end - forward * std::min(13.0f * point_, length);
    shape.strokes = {{*begin, arrow ? base : *end}};
    shape.area = arrow ? std::vector<vec2>{*end, base + side, base - side} : box(*end, 4.5f);
    shapes.push_back(std::move(shape));
  }

  const HandlePlace& place_;
  const Projection& projection_;
  float point_;
};

float distance_to(vec2 a, vec2 b, vec2 from) {
  const vec2 way = b - a;
  const float length2 = glm::dot(way, way);
  const float t = length2 > 0.0f ? std::clamp(glm::dot(from - a, way) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::length(a + way * t - from);
}

// 0 within.
float distance_to(const std::vector<vec2>& area, vec2 from) {
  if (area.empty()) return std::numeric_limits<float>::infinity();
  float nearest = std::numeric_limits<float>::infinity();
  bool left = false, right = false;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const vec2 a = area[i], b = area[(i + 1) % area.size()];
    nearest = std::min(nearest, distance_to(a, b, from));
    const float turn = (b.x - a.x) * (from.y - a.y) - (b.y - a.y) * (from.x - a.x);
    left |= turn > 0.0f;
    right |= turn < 0.0f;
  }
  return left && right ? nearest : 0.0f;
}

float distance_to(const PartShape& shape, vec2 from) {
  float nearest = distance_to(shape.area, from);
  for (const auto& stroke : shape.strokes)
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
      nearest = std::min(nearest, distance_to(stroke[i], stroke[i + 1], from));
  return nearest;
}

}  // namespace

const char* name_of(Part part) {
  static const char* const names[] = {"none", "x", "y", "z", "yz", "zx", "xy", "centre", "view"};
  return names[int(part)];
}

int axis_of(Part part) {
  if (part >= Part::x && part <= Part::z) return int(part) - int(Part::x);
  return is_plane(part) ? int(part) - int(Part::yz) : -1;
}

bool is_plane(Part part) {
  return part >= Part::yz && part <= Part::xy;
}

std::vector<PartShape> handle_shape(Tool tool, const HandlePlace& place, const Projection& projection,
                                    float point, const dvec3& stretch) {
  if (tool == Tool::select || !projection.point(place.centre)) return {};
  Drawing drawing(place, projection, point);
  if (tool == Tool::rotate) {
    drawing.add_rings();
    return std::move(drawing.shapes);
  }
  if (tool == Tool::translate)
    for (const Part part : {Part::yz, Part::zx, Part::xy}) drawing.add_plane(part);
  drawing.add_axes(tool == Tool::translate, stretch);
  drawing.add_centre();
  return std::move(drawing.shapes);
}

Part part_at(const std::vector<PartShape>& shapes, vec2 mouse, float reach) {
  Part found = Part::none;
  float nearest = reach;
  for (const PartShape& shape : shapes) {
    if (!shape.can_be_taken) continue;
    const float away = distance_to(shape, mouse);
    if (shape.part == Part::centre && away <= 0.3f * reach) return Part::centre;
    // On a plane's square is nearer than beside an axis; of two as near, the one in front.
    const float counted = is_plane(shape.part) && away == 0.0f ? -1.0f : away;
    if (counted > nearest) continue;
    nearest = counted;
    found = shape.part;
  }
  return found;
}

std::optional<vec2> grip_of(const std::vector<PartShape>& shapes, const PartShape& shape, float reach) {
  std::vector<vec2> candidates;
  for (const auto& stroke : shape.strokes)
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
      for (const float share : {0.5f, 0.7f, 0.85f})
        candidates.push_back(glm::mix(stroke[i], stroke[i + 1], share));
  if (!shape.area.empty()) {
    vec2 middle(0.0f);
    for (const vec2& corner : shape.area) middle += corner / float(shape.area.size());
    candidates.push_back(middle);
  }
  std::optional<vec2> best;
  float clearest = -1.0f;
  for (const vec2& candidate : candidates) {
    if (part_at(shapes, candidate, reach) != shape.part) continue;
    float clear = 1e6f;
    for (const PartShape& other : shapes)
      if (other.part != shape.part && other.can_be_taken)
        clear = std::min(clear, distance_to(other, candidate));
    if (clear <= clearest) continue;
    clearest = clear;
    best = candidate;
  }
  return best;
}

}  // namespace plinian::window
