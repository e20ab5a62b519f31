// The film as a frustum.
#include "host/window/drawing/view_matrices.h"

#include <algorithm>
#include <cmath>

namespace plinian::window {

namespace {

// A pixel at u, v in [-1, 1] (v up) looks along (offset + (u, v) * half, -1). [view space]
struct Film {
  dvec2 half, offset;
};

Film film_of(const SceneSnapshot& scene) {
  const CameraRays rays = camera_rays(scene.camera, scene.width, scene.height);
  const dmat3 world_from_view(scene.camera.world_from_camera);
  const dvec3 forward = glm::transpose(world_from_view) * dvec3(rays.forward);
  return {{glm::length(dvec3(rays.right)), glm::length(dvec3(rays.up))}, dvec2(forward)};
}

}  // namespace

ViewMatrices view_matrices(const SceneSnapshot& scene, const SceneBounds& bounds) {
  const dvec3 eye(scene.camera.world_from_camera[3]);
  const double away = std::max(glm::length(bounds.centre() - eye), bounds.radius());
  ViewMatrices matrices;
  matrices.near_depth = std::max(double(scene.camera.near_clip), std::max(away, 1e-6) * 1e-3);
  matrices.view_from_world = glm::inverse(scene.camera.world_from_camera);
  const Film film = film_of(scene);
  dmat4& clip = matrices.clip_from_view;
  clip = dmat4(0.0);
  clip[0][0] = 1.0 / film.half.x;
  clip[1][1] = 1.0 / film.half.y;
  clip[2] = dvec4(film.offset / film.half, -1.0, -1.0);
  clip[3][2] = -2.0 * matrices.near_depth;
  return matrices;
}

std::vector<float> depth_buffer_of(const Frame& frame, const SceneSnapshot& scene,
                                   const ViewMatrices& matrices, ivec2 size) {
  const Film film = film_of(scene);
  std::vector<float> depths(std::size_t(size.x) * std::size_t(size.y), 1.0f);
  // Along a row: the pixel of the frame, and the square of how far the ray goes sideways.
  std::vector<int> columns(std::size_t(size.x));
  std::vector<float> sideways(std::size_t(size.x));
  for (int x = 0; x < size.x; ++x) {
    const double share = (x + 0.5) / size.x, way = film.offset.x + (2.0 * share - 1.0) * film.half.x;
    columns[std::size_t(x)] = std::min(int(share * frame.width), frame.width - 1);
    sideways[std::size_t(x)] = float(way * way);
  }
  const auto near_depth = float(matrices.near_depth);
  for (int y = 0; y < size.y; ++y) {
    const double share = (y + 0.5) / size.y, way = film.offset.y + (2.0 * share - 1.0) * film.half.y;
    const int row = std::clamp(int((1.0 - share) * frame.height), 0, frame.height - 1);
    const float* from = frame.depth.data() + std::size_t(row) * std::size_t(frame.width);
    float* to = depths.data() + std::size_t(y) * std::size_t(size.x);
    const auto upright = float(1.0 + way * way);
    for (int x = 0; x < size.x; ++x) {
      // 1 - near / z, where the ray is sqrt(...) times as long as its depth z; infinity gives 1.
      const float distance = from[columns[std::size_t(x)]];
      to[x] = std::max(0.0f, 1.0f - near_depth * std::sqrt(upright + sideways[std::size_t(x)]) / distance);
    }
  }
  return depths;
}

}  // namespace plinian::window
