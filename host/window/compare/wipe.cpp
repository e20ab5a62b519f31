// A half-plane and a rectangle.
#include "host/window/compare/wipe.h"

#include <array>
#include <cmath>

namespace plinian::window {

vec2 Wipe::normal() const {
  return {-std::cos(angle), -std::sin(angle)};
}

vec2 Wipe::along() const {
  return {-std::sin(angle), std::cos(angle)};
}

float Wipe::distance(vec2 point, vec2 begin, vec2 size) const {
  return glm::dot(point - (begin + at * size), normal());
}

std::vector<vec2> Wipe::other_side(vec2 begin, vec2 size) const {
  const std::array<vec2, 4> corners = {begin, begin + vec2(size.x, 0.0f), begin + size,
                                       begin + vec2(0.0f, size.y)};
  std::vector<vec2> polygon;
  for (std::size_t i = 0; i < 4; ++i) {
    const vec2 a = corners[i], b = corners[(i + 1) % 4];
    const float da = distance(a, begin, size), db = distance(b, begin, size);
    if (da >= 0.0f) polygon.push_back(a);
    if ((da > 0.0f && db < 0.0f) || (da < 0.0f && db > 0.0f))
      polygon.push_back(glm::mix(a, b, da / (da - db)));
  }
  if (polygon.size() < 3) polygon.clear();
  return polygon;
}

void Wipe::move_to(vec2 point, vec2 begin, vec2 size) {
  at = glm::clamp((point - begin) / glm::max(size, vec2(1.0f)), vec2(0.0f), vec2(1.0f));
}

void Wipe::keep_within(vec2 part_begin, vec2 part_size, vec2 begin, vec2 size) {
  const vec2 part_end = part_begin + part_size, now = begin + at * size;
  const auto held = [&](vec2 point) { return glm::clamp(point, part_begin, part_end); };
  if (glm::length(held(now) - now) < 0.5f) return;
  const vec2 middle = part_begin + 0.5f * part_size;
  move_to(held(now + along() * glm::dot(middle - now, along())), begin, size);
}

void Wipe::turn_to(vec2 point, vec2 begin, vec2 size, bool forwards) {
  const vec2 toward = (point - (begin + at * size)) * (forwards ? 1.0f : -1.0f);
  if (glm::length(toward) > 1.0f) angle = std::atan2(-toward.x, toward.y);
}

std::vector<vec2> clipped(std::vector<vec2> polygon, vec2 begin, vec2 size) {
  for (int side = 0; side < 4; ++side) {
    const int axis = side / 2;
    const float sign = side % 2 == 0 ? 1.0f : -1.0f;
    const float edge = side % 2 == 0 ? begin[axis] : begin[axis] + size[axis];
    const auto inside = [&](vec2 p) { return sign * (p[axis] - edge); };
    std::vector<vec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const float da = inside(a), db = inside(b);
      if (da >= 0.0f) kept.push_back(a);
      if ((da > 0.0f && db < 0.0f) || (da < 0.0f && db > 0.0f))
        kept.push_back(glm::mix(a, b, da / (da - db)));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

}  // namespace plinian::window
