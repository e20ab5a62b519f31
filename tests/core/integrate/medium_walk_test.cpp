#include "core/integrate/medium_walk.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "tests/core/integrate/one_pixel.h"

namespace plinian {
namespace {

constexpr double far = std::numeric_limits<double>::infinity();

/// Two rough blobs with a wide gap between them, in a skewed, mirrored, anisotropic frame.
Medium blobs() {
  const auto value = [](ivec3 v) {
    if (v.x > 12 && v.x < 95) return 0.0f;
    const std::uint32_t h = std::uint32_t(v.x + 7 * v.y + 131 * v.z) * 2654435761u;
    return (h >> 28) < 5 ? 0.0f : float(h >> 8) / float(1 << 24);
  };
  Medium medium;
  dmat4 skewed = glm::rotate(dmat4(1.0), 0.7, glm::normalize(dvec3(1, 2, 3))) *
                 glm::scale(dmat4(1.0), {-0.5, 0.25, 1.5});
  skewed[1].x += 0.1;
  skewed[3] = dvec4(3, -2, 1, 1);
  medium.volume = voxels({-5, -3, -20}, {110, 17, 9}, value, skewed);
  medium.world_from_medium = glm::scale(dmat4(1.0), {1.0, 2.0, 0.75});
  return medium;
}

/// The midpoint rule over the volume's own lookups, which know nothing of cells.
double brute_force(const Medium& medium, const Ray& ray, double begin, double end, int samples) {
  const dmat4 index_from_world = glm::inverse(medium.world_from_medium * medium.volume->medium_from_index);
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double t = begin + (end - begin) * (i + 0.5) / samples;
    sum += medium.volume->sample_density(vec3(index_from_world * dvec4(ray.origin + t * ray.direction, 1.0)));
  }
  return sum * (end - begin) / samples;
}

TEST(MediumWalk, IntegralsAgreeWithBruteForceInAnyFrame) {
  const Medium medium = blobs();
  const MediumWalk walk(medium);
  const dmat4 world_from_index = medium.world_from_medium * medium.volume->medium_from_index;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int hits = 0;
  for (int i = 0; i < 60; ++i) {
    const auto inside = [&] {
      return dvec3(world_from_index * dvec4(glm::mix(dvec3(-8, -6, -24), dvec3(114, 20, 12),
                                                     dvec3(unit(random), unit(random), unit(random))),
                                            1.0));
    };
    const dvec3 from = inside(), to = inside();
    const Ray ray{from, glm::normalize(to - from)};
    const double end = glm::distance(from, to);
    const double truth = brute_force(medium, ray, 0.0, end, 200000);
    EXPECT_NEAR(walk.integral(ray, 0.0, end, far), truth, 2e-5 * end);
    hits += truth > 0.1;
  }
  // Enough of them met the blobs to say something.
  EXPECT_GT(hits, 20);
}

TEST(MediumWalk, PiecesAreInOrderAndAddUpToTheIntegral) {
  const Medium medium = blobs();
  const MediumWalk walk(medium);
  const dmat4 index_from_world = glm::inverse(medium.world_from_medium * medium.volume->medium_from_index);
  const dvec3 from(glm::inverse(index_from_world) * dvec4(-30, 1, -11, 1)),
      to(glm::inverse(index_from_world) * dvec4(140, 9, -2, 1));
  const Ray ray{from, glm::normalize(to - from)};
  std::vector<DensityPiece> pieces;
  walk.pieces(ray, 0.0, far, far, pieces);
  ASSERT_GT(pieces.size(), 30u);
  double sum = 0.0, last = 0.0;
  for (const DensityPiece& piece : pieces) {
    EXPECT_GE(piece.begin, last);
    EXPECT_GT(piece.end, piece.begin);
    last = piece.end;
    sum += piece.integral(piece.end);
    for (const double s : {0.1, 0.5, 0.9}) {
      const double t = piece.begin + s * (piece.end - piece.begin);
      EXPECT_NEAR(
          piece.density(t),
          medium.volume->sample_density(vec3(index_from_world * dvec4(ray.origin + t * ray.direction, 1.0))),
          2e-5);
    }
  }
  EXPECT_NEAR(sum, walk.integral(ray, 0.0, far, far), 1e-12 * sum);
  // Parts of a ray add up to the whole, wherever it is cut.
  const double cut = 0.41 * last;
  EXPECT_NEAR(walk.integral(ray, 0.0, cut, far) + walk.integral(ray, cut, far, far), sum, 1e-10 * sum);
}

TEST(MediumWalk, AxisParallelRaysOnVoxelPlanesSeeWhatIsThere) {
  // Constant in a slab: on faces, edges and corners of cells the answer is the same as between them.
  Medium medium;
  medium.volume = voxels({-16, -16, -16}, {15, 15, 15}, [](ivec3) { return 0.5f; });
  const MediumWalk walk(medium);
  for (const double offset : {0.0, 0.5, 8.0, -8.0, 7.999999, 15.0, -16.0})
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        Ray ray{dvec3(offset), dvec3(0.0)};
        ray.origin[axis] = -sign * 100.0;
        ray.direction[axis] = sign;
        EXPECT_NEAR(walk.integral(ray, 0.0, far, far), 16.0, 1e-4) << offset << ", axis " << axis;
      }
}

TEST(MediumWalk, EndsSoonAfterEnough) {
  Medium medium;
  medium.volume = voxels({0, 0, 0}, {63, 15, 15}, [](ivec3) { return 1.0f; });
  const MediumWalk walk(medium);
  const Ray ray{{-10, 7, 7}, {1, 0, 0}};
  EXPECT_NEAR(walk.integral(ray, 0.0, far, far), 64.0, 1e-6);
  const double some = walk.integral(ray, 0.0, far, 5.25);
  EXPECT_GT(some, 5.25);
  EXPECT_LE(some, 6.5);
}

TEST(MediumWalk, ShapesAreExactChords) {
  const MediumWalk box(
      analytic_medium(MediumShape::box, vec3(1), vec3(0), glm::scale(dmat4(1.0), {2.0, 1.0, 1.0})));
  const MediumWalk ball(
      analytic_medium(MediumShape::sphere, vec3(1), vec3(0), glm::translate(dmat4(1.0), dvec3(0, 3, 0))));
  EXPECT_DOUBLE_EQ(box.integral({{-9, 0, 0}, {1, 0, 0}}, 0.0, far, far), 4.0);
  EXPECT_DOUBLE_EQ(box.integral({{-9, 0, 0}, {1, 0, 0}}, 0.0, 8.5, far), 1.5);
  EXPECT_EQ(box.integral({{-9, 1.5, 0}, {1, 0, 0}}, 0.0, far, far), 0.0);
  EXPECT_EQ(box.integral({{9, 0, 0}, {1, 0, 0}}, 0.0, far, far), 0.0);  // behind
  EXPECT_NEAR(ball.integral({{1e5, 3.6, 0}, {-1, 0, 0}}, 0.0, far, far), 1.6, 1e-9);
  EXPECT_EQ(ball.integral({{0, 0, 0}, {1, 0, 0}}, 0.0, far, far), 0.0);
}

TEST(MediumWalk, RefusesWhatCannotBeWalked) {
  Medium flat = analytic_medium(MediumShape::box, vec3(1), vec3(0), glm::scale(dmat4(1.0), {1.0, 0.0, 1.0}));
  flat.name = "pancake";
  try {
    MediumWalk walk(flat);
    FAIL() << "a singular transform was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("pancake"), std::string::npos);
  }
  EXPECT_THROW(MediumWalk{Medium{}}, std::invalid_argument);
}

TEST(MediumWalk, AnEmptyVolumeHasNoDensity) {
  Medium medium;
  medium.volume = std::make_shared<const BrickVolume>();
  EXPECT_EQ(MediumWalk(medium).integral({{0, 0, 0}, {1, 0, 0}}, 0.0, far, far), 0.0);
}

}  // namespace
}  // namespace plinian
