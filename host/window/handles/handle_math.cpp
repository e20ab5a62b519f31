// Lines, planes and circles as they are seen.
#include "host/window/handles/handle_math.h"

#include <algorithm>
#include <cmath>

namespace plinian::window {

namespace {

constexpr double farthest = 20.0;  // [-] depth over that of the handle, that a drag reaches

double nearest_turn(double turn, double near) {
  return turn + 360.0 * std::round((near - turn) / 360.0);
}

dvec3 sight(const Projection& projection, const dvec3& at) {
  return glm::normalize(at - projection.eye());
}

}  // namespace

// A point t along the line is seen at s0 + way * t z0 / (z0 + t slope), z being its depth.
double along_line(const Projection& projection, const dvec3& through, const dvec3& along, double reach,
                  dvec2 mouse) {
  const auto begin = projection.point(through);
  auto end = projection.point(through + along * reach);
  if (begin && !end) {  // it comes out behind the eye
    reach = -reach;
    end = projection.point(through + along * reach);
  }
  if (!begin || !end) return 0.0;
  const double depth = begin->depth, slope = (end->depth - depth) / reach;
  const dvec2 way = (dvec2(end->at) - dvec2(begin->at)) * (end->depth / (reach * depth));
  const double length2 = glm::dot(way, way);
  if (!(length2 * reach * reach > 1.0)) return 0.0;  // not a point of the screen long
  const double share = glm::dot(mouse - dvec2(begin->at), way) / length2;
  // Beyond the vanishing point the denominator turns round.
  const double left = depth - share * slope, held = std::clamp(left, depth / farthest, depth * farthest);
  return left == held ? share * depth / left : (depth / slope) * (depth / held - 1.0);
}

double openness_of_plane(const Projection& projection, const dvec3& through, const dvec3& normal) {
  return std::abs(glm::dot(sight(projection, through), normal));
}

double openness_of_line(const Projection& projection, const dvec3& through, const dvec3& along) {
  return glm::length(glm::cross(sight(projection, through), along));
}

dvec3 on_plane(const Projection& projection, const dvec3& through, const dvec3& normal, dvec2 mouse) {
  const dvec3 direction = projection.direction(vec2(mouse)), offset = through - projection.eye();
  const double height = glm::dot(offset, normal), fall = glm::dot(direction, normal);
  const auto seen = projection.point(through);
  if (height == 0.0 || !seen) return through;
  // 1 / depth of the meeting, which grows less and less towards the horizon and is negative beyond it.
  const double nearness = std::max(fall / height, 1.0 / (farthest * seen->depth));
  const dvec3 met = projection.eye() + direction / nearness;
  return met - normal * glm::dot(met - through, normal);
}

dvec3 beside_point(const Projection& projection, const dvec3& through, dvec2 mouse) {
  const auto seen = projection.point(through);
  return seen ? projection.eye() + projection.direction(vec2(mouse)) * seen->depth : through;
}

double ring_turn(const Projection& projection, const dvec3& centre, const dvec3& axis, double radius,
                 dvec2 from, dvec2 to, double near) {
  const auto middle = projection.point(centre);
  if (!middle) return 0.0;
  constexpr double open_enough = 0.25;  // flatter ellipses tell nothing of where on them the mouse is
  if (openness_of_plane(projection, centre, axis) >= open_enough) {
    const dvec3 a = on_plane(projection, centre, axis, from) - centre,
                b = on_plane(projection, centre, axis, to) - centre;
    const double sine = glm::dot(glm::cross(a, b), axis), cosine = glm::dot(a, b);
    if (sine == 0.0 && cosine == 0.0) return near;
    return nearest_turn(glm::degrees(std::atan2(sine, cosine)), near);
  }
  // From the side a ring is nearly a line, whose front is dragged along as a belt is.
  const dvec3 along = glm::cross(axis, -sight(projection, centre));
  const double length = glm::length(along);
  if (!(length > 0.0)) return 0.0;
  const auto end = projection.point(centre + along * (radius / length));
  if (!end) return 0.0;
  const dvec2 way = dvec2(end->at) - dvec2(middle->at);
  const double length2 = glm::dot(way, way);
  return length2 > 0.0 ? glm::degrees(glm::dot(to - from, way) / length2) : 0.0;
}

double view_turn(const Projection& projection, const dvec3& centre, dvec2 from, dvec2 to, double near) {
  const auto middle = projection.point(centre);
  if (!middle) return 0.0;
  const dvec2 a = from - dvec2(middle->at), b = to - dvec2(middle->at);
  const double sine = a.y * b.x - a.x * b.y, cosine = glm::dot(a, b);  // y runs down
  if (sine == 0.0 && cosine == 0.0) return near;
  return nearest_turn(glm::degrees(std::atan2(sine, cosine)), near);
}

double round_step(double size) {
  return std::pow(10.0, std::floor(std::log10(size) + 1e-9));
}

// Steps under one are divided by their whole inverse where they have one: 3 * 0.1 is not 0.3, 3 / 10 is.
double rounded(double value, double step) {
  const double inverse = std::round(1.0 / step);
  const double result = inverse > 1.0 && std::abs(inverse * step - 1.0) < 1e-9
                            ? std::round(value * inverse) / inverse
                            : std::round(value / step) * step;
  return result + 0.0;  // no -0
}

}  // namespace plinian::window
