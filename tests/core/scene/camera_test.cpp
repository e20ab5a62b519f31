#include "core/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace plinian {
namespace {

TEST(Camera, LooksAtItsTargetThroughThePictureCentreWithTheAskedFieldOfView) {
  const Camera camera = look_at({1, 2, 3}, {4, 6, 3}, {0, 0, 1}, 40.0);
  const CameraRays rays = camera_rays(camera, 320, 200);
  EXPECT_NEAR(glm::dot(rays.forward, glm::normalize(vec3(3, 4, 0))), 1.0f, 1e-6f);
  EXPECT_NEAR(glm::length(rays.up), std::tan(glm::radians(20.0)), 1e-6);
  EXPECT_NEAR(glm::length(rays.right) / glm::length(rays.up), 1.6, 1e-5);
  EXPECT_NEAR(rays.up.z, glm::length(rays.up), 1e-6f);
}

TEST(Camera, FillCropsTheFilmAndOverscanShowsMoreThanIt) {
  Camera camera;
  camera.focal_length = 36.0f;
  camera.film_back = {36.0f, 24.0f};
  const auto half = [&](int w, int h) {
    const CameraRays rays = camera_rays(camera, w, h);
    return vec2(glm::length(rays.right), glm::length(rays.up));
  };
  camera.fit = FilmFit::fill;  // square picture inside the 3:2 film: its height fills the film's
  EXPECT_NEAR(half(100, 100).y, 12.0f / 36.0f, 1e-6f);
  EXPECT_NEAR(half(400, 100).x, 18.0f / 36.0f, 1e-6f);
  camera.fit = FilmFit::overscan;
  EXPECT_NEAR(half(100, 100).x, 18.0f / 36.0f, 1e-6f);
  EXPECT_NEAR(half(400, 100).y, 12.0f / 36.0f, 1e-6f);
  camera.fit = FilmFit::horizontal;
  EXPECT_NEAR(half(100, 300).x, 0.5f, 1e-6f);
  camera.fit = FilmFit::vertical;
  EXPECT_NEAR(half(300, 100).y, 12.0f / 36.0f, 1e-6f);
  camera.pixel_aspect = 2.0f;
  EXPECT_NEAR(half(300, 100).x, 6.0f * 12.0f / 36.0f, 1e-5f);
}

TEST(Camera, FilmOffsetShiftsTheViewTowardsTheOffset) {
  Camera camera;
  camera.focal_length = 36.0f;
  camera.film_offset = {3.6f, 0.0f};
  EXPECT_NEAR(camera_rays(camera, 100, 100).forward.x, 0.1f, 1e-6f);
}

TEST(Camera, RefusesToLookAtItself) {
  EXPECT_THROW(look_at({1, 1, 1}, {1, 1, 1}, {0, 1, 0}, 40), std::invalid_argument);
}

}  // namespace
}  // namespace plinian
