// Azimuth and elevation of lights, and the rotations that make them.
#include "host/window/navigation/light_angles.h"

#include <gtest/gtest.h>

#include <array>

#include "core/scene/framing.h"

namespace plinian::window {
namespace {

// Where the light of a node that is rotated so comes from. [world] unit
dvec3 toward(Placement placement, const dvec3& rotate, const dmat4& parent) {
  placement.rotate = rotate;
  return glm::normalize(dmat3(parent) * dvec3(matrix_of(placement)[2]));
}

void expect_near(const dvec3& a, const dvec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

constexpr std::array orders = {RotateOrder::xyz, RotateOrder::yzx, RotateOrder::zxy,
                               RotateOrder::xzy, RotateOrder::yxz, RotateOrder::zyx};

TEST(SkyAngles, AreCountedFromZOverX) {
  const auto angles = [](const dvec3& rotate) { return sky_angles({.rotate = rotate}, dmat4(1.0)).value(); };
  EXPECT_EQ(angles({0, 0, 0}).azimuth, 0.0);
  EXPECT_EQ(angles({0, 0, 0}).elevation, 0.0);
  EXPECT_NEAR(angles({0, 90, 0}).azimuth, 90.0, 1e-9);
  EXPECT_NEAR(angles({0, -90, 0}).azimuth, -90.0, 1e-9);
  EXPECT_NEAR(angles({-35, 20, 0}).elevation, 35.0, 1e-9);
  EXPECT_NEAR(angles({-35, 20, 0}).azimuth, 20.0, 1e-9);
  EXPECT_NEAR(angles({0, 90, 90}).elevation, 90.0, 1e-9) << "z comes last: it turns what came from +x";
  EXPECT_NEAR(angles({0, 45, 90}).elevation, 45.0, 1e-9) << "up";
}

TEST(SkyAngles, StandThereInEveryOrderAndUnderEveryParent) {
  const dmat4 turned = matrix_of({.translate = {3, 4, 5}, .rotate = {20, 130, -40}, .scale = {1, 3, 0.5}});
  const dmat4 mirrored = matrix_of({.scale = {1, -1, 1}});
  for (const dmat4& parent : {dmat4(1.0), turned, mirrored})
    for (const RotateOrder order : orders)
      for (const double z : {1.0, -2.0})
        for (const double azimuth : {-170.0, -90.0, -3.0, 0.0, 45.0, 90.0, 179.0})
          for (const double elevation : {-80.0, 0.0, 12.5, 89.0}) {
            const Placement placement{.rotate = {10, 400, 30}, .order = order, .scale = {1, 1, z}};
            const dvec3 rotation = rotation_toward({azimuth, elevation}, placement, parent);
            expect_near(toward(placement, rotation, parent), direction_from(azimuth, elevation), 2e-5);
            Placement after = placement;
            after.rotate = rotation;
            const SkyAngles again = sky_angles(after, parent).value();
            EXPECT_NEAR(again.elevation, elevation, 1e-3);
            if (elevation < 85.0) {
              EXPECT_NEAR(again.azimuth, azimuth, 1e-3);
            }
          }
}

TEST(SkyAngles, StraightAboveKeepTheAzimuth) {
  Placement placement{.rotate = {-30, 65, 0}};
  placement.rotate = rotation_toward({65.0, 90.0}, placement, dmat4(1.0));
  EXPECT_EQ(placement.rotate, dvec3(-90, 65, 0));
  const SkyAngles above = sky_angles(placement, dmat4(1.0)).value();
  EXPECT_NEAR(above.azimuth, 65.0, 1e-9);
  EXPECT_NEAR(above.elevation, 90.0, 1e-9);
  EXPECT_NEAR(sky_angles({.rotate = {90, -20, 0}}, dmat4(1.0))->azimuth, -20.0, 1e-9) << "and below";
}

TEST(SkyAngles, ReadWellAndGoOnTurningWhereALightHasBeenTurnedRound) {
  EXPECT_EQ(rotation_toward({30.0, 40.0}, {}, dmat4(1.0)), dvec3(-40, 30, 0));
  EXPECT_EQ(rotation_toward({-175.0, 40.0}, {.rotate = {-40, 170, 0}}, dmat4(1.0)), dvec3(-40, 185, 0));
  EXPECT_EQ(rotation_toward({10.0, 0.0}, {.rotate = {0, 725, 0}}, dmat4(1.0)), dvec3(0, 730, 0));
}

TEST(SkyAngles, OfWhatIsUnderAFlatParentAreNone) {
  EXPECT_FALSE(sky_angles({}, matrix_of({.scale = {1, 0, 1}})));
}

TEST(RotateLine, SetsWhatChanges) {
  EXPECT_EQ(rotate_line("key", {-40, 30, 0}, {-40, 35, 0}), "setAttr key.rotate.y 35");
  EXPECT_EQ(rotate_line("key", {-40, 30, 0}, {-41, 35, 0}), "setAttr key.rotate -41 35 0");
  EXPECT_EQ(rotate_line("key", {-40, 30, 5}, {-40, 30, 5}), std::nullopt);
}

}  // namespace
}  // namespace plinian::window
