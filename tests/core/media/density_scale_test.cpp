#include "core/media/density_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/media/vdb_reader.h"
#include "tests/core/media/vdb_test_files.h"

namespace plinian {
namespace {

/// density [unit] at the voxels of [0, dims), under a transform.
BrickVolume box(ivec3 dims, float density, const dmat4& medium_from_index = dmat4(1.0)) {
  BrickVolumeBuilder builder;
  for (int bz = 0; bz * 8 < dims.z; ++bz)
    for (int by = 0; by * 8 < dims.y; ++by)
      for (int bx = 0; bx * 8 < dims.x; ++bx) {
        float values[512];
        for (int i = 0; i < 512; ++i) {
          const ivec3 v(bx * 8 + (i & 7), by * 8 + ((i >> 3) & 7), bz * 8 + (i >> 6));
          values[i] = v.x < dims.x && v.y < dims.y && v.z < dims.z ? density : 0.0f;
        }
        builder.add({bx, by, bz}, values);
      }
  return builder.build(medium_from_index);
}

TEST(DensityScale, OfACubeIsTwelveOverItsColumn) {
  // 64 voxels of density 3 and size 0.5, falling off linearly over one more voxel at either end: a column
  // of 96.
  const BrickVolume cube = box(ivec3(64), 3.0f, glm::scale(dmat4(1.0), dvec3(0.5)));
  const DensityFacts facts = measure_density(cube, dmat4(1.0));
  EXPECT_NEAR(facts.median_column, 96.0f, 0.5f);
  // Along each axis the square of a profile of 63 full cells and two ramps over the profile: (63 + 2/3) / 64.
  EXPECT_NEAR(facts.typical_density, 3.0 * std::pow((63.0 + 2.0 / 3.0) / 64.0, 3), 0.03);
  EXPECT_NEAR(automatic_density_scale(cube, dmat4(1.0)), 12.0f / 96.0f, 1e-3f);
  EXPECT_NEAR(automatic_density_scale(cube, dmat4(1.0), 5.0f), 5.0f / 96.0f, 1e-3f);
  // In a world of centimetres the same cube is a hundredth as long.
  EXPECT_NEAR(automatic_density_scale(cube, glm::scale(dmat4(1.0), dvec3(0.01))), 1200.0f / 96.0f, 0.1f);
}

TEST(DensityScale, OfAPlateIsThatOfItsBroadSide) {
  // 64 x 64 x 8: the faces weigh 64 : 8 : 8, so the median ray crosses the thin way, 8 voxels.
  EXPECT_NEAR(measure_density(box({64, 64, 8}, 1.0f), dmat4(1.0)).median_column, 8.0f, 0.1f);
}

TEST(DensityScale, DoesNotDependOnHowTheVolumeLiesInIndexSpace) {
  const BrickVolume plain = box({40, 64, 24}, 2.0f);
  dmat4 turned = glm::rotate(dmat4(1.0), 1.5707963267948966, dvec3(0, 0, 1));
  turned = glm::translate(dmat4(1.0), dvec3(7, -3, 11)) * glm::scale(turned, dvec3(-1, 1, 1));
  const BrickVolume mirrored = box({40, 64, 24}, 2.0f, turned);
  EXPECT_NEAR(automatic_density_scale(plain, dmat4(1.0)) / automatic_density_scale(mirrored, dmat4(1.0)),
              1.0f, 0.02f);
}

TEST(DensityScale, OfVolumesThatRaysHardlyMeetIsStillSane) {
  BrickVolumeBuilder builder;
  float values[512] = {};
  values[0] = 4.0f;
  builder.add({0, 0, 0}, values);
  builder.add({100000, 100000, 100000}, values);
  const BrickVolume sparse = builder.build(dmat4(1.0));
  // Through the voxel itself: a triangle of height 4 and base 2.
  EXPECT_NEAR(measure_density(sparse, dmat4(1.0)).median_column, 4.0f, 0.6f);
  EXPECT_EQ(automatic_density_scale(BrickVolume{}, dmat4(1.0)), 1.0f);
  EXPECT_EQ(measure_density(BrickVolume{}, dmat4(1.0)).rays, 0);
}

TEST(DensityScale, IsQuickAndRepeatableOnARealVolume) {
  PLINIAN_NEEDS_REAL_FILES();
  const VdbVolume smoke = read_vdb(real_file("smoke.vdb"));
  const float first = automatic_density_scale(*smoke.volume, dmat4(1.0));
  EXPECT_EQ(first, automatic_density_scale(*smoke.volume, dmat4(1.0)));
  EXPECT_GT(measure_density(*smoke.volume, dmat4(1.0)).rays, 5000);
}

TEST(MeanFreePath, IsOneOverTheExtinction) {
  Medium medium;
  medium.density_scale = 2.0f;
  medium.sigma_s = vec3(0.5f, 1.0f, 0.0f);
  medium.sigma_a = vec3(0.5f, 0.0f, 0.0f);
  const vec3 path = mean_free_path(medium, 3.0f);
  EXPECT_FLOAT_EQ(path.x, 1.0f / 6.0f);
  EXPECT_FLOAT_EQ(path.y, 1.0f / 6.0f);
  EXPECT_TRUE(std::isinf(path.z));
}

TEST(RescaleVolume, KeepsExtinctionOrOpticalDepthByChoice) {
  Medium medium;
  medium.density_scale = 2.0f;
  medium.world_from_medium = glm::translate(dmat4(1.0), dvec3(5, 0, 0));
  Medium other = medium;
  rescale_volume(medium, 4.0, Keep::extinction);
  rescale_volume(other, 4.0, Keep::optical_depth);
  EXPECT_EQ(medium.density_scale, 2.0f);
  EXPECT_EQ(other.density_scale, 0.5f);
  for (const Medium& m : {medium, other}) {
    EXPECT_EQ(dvec3(m.world_from_medium * dvec4(0, 0, 0, 1)), dvec3(5, 0, 0));  // the origin stays
    EXPECT_EQ(dvec3(m.world_from_medium * dvec4(1, 0, 0, 0)), dvec3(4, 0, 0));
  }
  EXPECT_THROW(rescale_volume(medium, 0.0, Keep::extinction), std::invalid_argument);
  EXPECT_THROW(rescale_volume(medium, std::numeric_limits<double>::infinity(), Keep::extinction),
               std::invalid_argument);
}

}  // namespace
}  // namespace plinian
