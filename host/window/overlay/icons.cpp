// Circles, rays and edges.
#include "host/window/overlay/icons.h"

#include <cmath>

namespace plinian::window {

namespace {

constexpr double two_pi = 6.283185307179586;

void add_circle(std::vector<WorldLine>& lines, const dvec3& middle, const dvec3& x, const dvec3& y,
                int sides) {
  const auto at = [&](int i) {
    const double angle = two_pi * i / sides;
    return middle + x * std::cos(angle) + y * std::sin(angle);
  };
  for (int i = 0; i < sides; ++i) lines.push_back({at(i), at(i + 1)});
}

void add_rays(std::vector<WorldLine>& lines, const dvec3& middle, const dvec3& x, const dvec3& y, int count,
              double from, double to) {
  for (int i = 0; i < count; ++i) {
    const double angle = two_pi * i / count;
    const dvec3 out = x * std::cos(angle) + y * std::sin(angle);
    lines.push_back({middle + out * from, middle + out * to});
  }
}

dvec3 beside(const dvec3& direction) {
  const dvec3 other = std::abs(direction.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  return glm::normalize(glm::cross(other, direction));
}

}  // namespace

std::vector<WorldLine> light_icon(const Light& light, const dvec3& at, const dmat3& facing, double size) {
  std::vector<WorldLine> lines;
  const dvec3 x = facing[0] * size, y = facing[1] * size, beam = -dvec3(light.toward);
  if (light.type == LightType::point) {
    add_rays(lines, at, x, y, 8, 0.25, 1.0);
  } else if (light.type == LightType::directional) {
    add_circle(lines, at, x * 0.5, y * 0.5, 20);
    add_rays(lines, at, x, y, 8, 0.7, 1.0);
    const dvec3 tip = at + beam * (size * 3.0), side = beside(beam) * (size * 0.25);
    lines.push_back({at + beam * (size * 1.2), tip});
    for (const double s : {-1.0, 1.0}) lines.push_back({tip, tip - beam * (size * 0.5) + side * s});
  } else {
    // Wider than a right angle it would be a plate: there the cone tells less than its axis.
    const double half = glm::radians(std::min(double(light.cone_angle) * 0.5, 75.0)), length = size * 2.5;
    const dvec3 base = at + beam * (length * std::cos(half));
    const dvec3 u = beside(beam) * (length * std::sin(half)), v = glm::cross(beam, u);
    add_circle(lines, base, u, v, 24);
    for (const dvec3& edge : {u, v, -u, -v}) lines.push_back({at, base + edge});
  }
  return lines;
}

std::vector<WorldLine> camera_icon(const Camera& camera, double size) {
  const dvec3 eye(camera.world_from_camera[3]), up(camera.world_from_camera[1]);
  const CameraRays rays = camera_rays(camera, int(camera.film_back.x * 100), int(camera.film_back.y * 100));
  const dvec3 ahead = dvec3(rays.forward), right = dvec3(rays.right), top = dvec3(rays.up);
  const double scale = 2.0 * size / glm::length(ahead + right + top);
  const dvec3 corners[] = {eye + (ahead - right - top) * scale, eye + (ahead + right - top) * scale,
                           eye + (ahead + right + top) * scale, eye + (ahead - right + top) * scale};
  std::vector<WorldLine> lines;
  for (int i = 0; i < 4; ++i) {
    lines.push_back({eye, corners[i]});
    lines.push_back({corners[i], corners[(i + 1) % 4]});
  }
  const dvec3 peak = (corners[2] + corners[3]) * 0.5 + up * (size * 0.5);
  lines.push_back({corners[2], peak});
  lines.push_back({corners[3], peak});
  return lines;
}

}  // namespace plinian::window
