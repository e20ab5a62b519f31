#include "core/media/brick_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace plinian {
namespace {

/// A block of which every voxel is given by f(voxel).
template <class F>
void add_block(BrickVolumeBuilder& builder, ivec3 block, F f) {
  float values[512];
  for (int i = 0; i < 512; ++i) values[i] = f(block * 8 + ivec3(i & 7, (i >> 3) & 7, i >> 6));
  builder.add(block, values);
}

TEST(BrickVolume, ReproducesALinearFieldExactlyBetweenVoxels) {
  BrickVolumeBuilder builder;
  const auto field = [](vec3 p) { return 8.0f + 0.25f * p.x + 0.125f * p.y - 0.0625f * p.z; };
  for (int z = -1; z < 2; ++z)
    for (int y = -1; y < 2; ++y)
      for (int x = -1; x < 2; ++x) add_block(builder, {x, y, z}, [&](ivec3 v) { return field(vec3(v)); });
  const BrickVolume volume = builder.build(dmat4(1.0));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> inside(-8.0f, 15.0f);
  for (int i = 0; i < 1000; ++i) {
    const vec3 p(inside(random), inside(random), inside(random));
    EXPECT_NEAR(volume.sample_density(p), field(p), 2.0f * volume.density_max / 65535.0f);
  }
  EXPECT_EQ(volume.leaf_count, 27);
  EXPECT_EQ(volume.active_voxels, 27 * 512);
}

TEST(BrickVolume, FallsLinearlyToZeroAcrossTheCellBesideTheLastVoxel) {
  BrickVolumeBuilder builder;
  add_block(builder, {0, 0, 0}, [](ivec3 v) { return v == ivec3(0) ? 3.0f : 0.0f; });
  const BrickVolume volume = builder.build(dmat4(1.0));
  EXPECT_FLOAT_EQ(volume.sample_density({0, 0, 0}), 3.0f);
  EXPECT_NEAR(volume.sample_density({-0.25f, 0, 0}), 2.25f, 1e-4f);
  EXPECT_NEAR(volume.sample_density({-0.5f, -0.5f, 0.5f}), 0.375f, 1e-4f);
  EXPECT_EQ(volume.sample_density({-1.0f, 0, 0}), 0.0f);
  EXPECT_EQ(volume.sample_density({1.0f, 0, 0}), 0.0f);
  EXPECT_EQ(volume.bounds_min, ivec3(-1));
  EXPECT_EQ(volume.bounds_max, ivec3(1));
  // The voxel lies on the first layer of its block, so the lower neighbours see it as their apron: 8 bricks.
  EXPECT_EQ(volume.brick_count(), 8u);
}

TEST(BrickVolume, KeepsWeakDensityBesideAStrongOutlier) {
  BrickVolumeBuilder builder;
  add_block(builder, {0, 0, 0}, [](ivec3 v) { return v == ivec3(4) ? 1e6f : 0.0f; });
  add_block(builder, {5, 0, 0}, [](ivec3) { return 0.01f; });
  const BrickVolume volume = builder.build(dmat4(1.0));
  EXPECT_NEAR(volume.voxel_density({44, 4, 4}), 0.01f, 2e-5f);
  EXPECT_FLOAT_EQ(volume.voxel_density({4, 4, 4}), 1e6f);
}

TEST(BrickVolume, CountsAndMendsVoxelsThatAreNoDensity) {
  BrickVolumeBuilder builder;
  add_block(builder, {0, 0, 0}, [](ivec3 v) {
    if (v == ivec3(1)) return std::numeric_limits<float>::quiet_NaN();
    if (v == ivec3(2)) return std::numeric_limits<float>::infinity();
    if (v == ivec3(3)) return -std::numeric_limits<float>::infinity();
    if (v == ivec3(4)) return -1.0f;
    return 0.5f;
  });
  const BrickVolume volume = builder.build(dmat4(1.0));
  EXPECT_EQ(builder.repairs().not_a_number, 1);
  EXPECT_EQ(builder.repairs().infinite, 2);
  EXPECT_EQ(builder.repairs().negative, 1);
  EXPECT_EQ(volume.voxel_density(ivec3(1)), 0.0f);
  EXPECT_FLOAT_EQ(volume.voxel_density(ivec3(2)), 0.5f);
  EXPECT_EQ(volume.voxel_density(ivec3(3)), 0.0f);
  EXPECT_EQ(volume.voxel_density(ivec3(4)), 0.0f);
}

TEST(BrickVolume, MemoryFollowsVoxelsNotTheBoxAroundThem) {
  BrickVolumeBuilder builder;
  for (const ivec3 far : {ivec3(0), ivec3(100000), ivec3(-100000, 50000, 7)})
    add_block(builder, far, [](ivec3) { return 1.0f; });
  const BrickVolume volume = builder.build(dmat4(1.0));
  EXPECT_LT(volume.bytes(), 4u << 20);
  EXPECT_GT(volume.levels, 0);
  EXPECT_FLOAT_EQ(volume.voxel_density(ivec3(800003)), 1.0f);
  EXPECT_FLOAT_EQ(volume.voxel_density(ivec3(-800000 + 3, 400003, 59)), 1.0f);
  EXPECT_EQ(volume.voxel_density(ivec3(400000)), 0.0f);
}

TEST(BrickVolume, EmptyCellsPromiseOnlySpaceThatIsEmpty) {
  BrickVolumeBuilder builder;
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-20, 20);
  for (int i = 0; i < 12; ++i) {
    const ivec3 block(place(random), place(random), place(random));
    try {
      add_block(builder, block, [](ivec3) { return 1.0f; });
    } catch (const std::invalid_argument&) {  // the same place twice
    }
  }
  const BrickVolume volume = builder.build(dmat4(1.0));
  ASSERT_EQ(volume.levels, 0);
  std::uniform_int_distribution<int> voxel(-170, 170);
  int leaps = 0;
  for (int i = 0; i < 20000; ++i) {
    const ivec3 cell(voxel(random), voxel(random), voxel(random));
    const auto found = volume.find(cell);
    if (found.entry.x & BrickVolume::occupied_bit || found.entry.x < 2) continue;
    ++leaps;
    const int reach = int(found.entry.x) - 1;
    for (int corner = 0; corner < 27; ++corner) {
      const ivec3 other =
          found.corner + (ivec3(corner % 3, corner / 3 % 3, corner / 9) - 1) * reach * found.size;
      EXPECT_FALSE(volume.find(other).entry.x & BrickVolume::occupied_bit);
    }
  }
  EXPECT_GT(leaps, 1000);
}

TEST(BrickVolume, OctantsTellWhatIsInThemAndRangesHoldAllValues) {
  BrickVolumeBuilder builder;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> rare(0, 300), value(1, 9);
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x)
        add_block(builder, {x, y, z}, [&](ivec3) { return rare(random) == 0 ? float(value(random)) : 0.0f; });
  add_block(builder, {6, 0, 0}, [&](ivec3) { return float(value(random)); });  // nowhere empty
  const BrickVolume volume = builder.build(dmat4(1.0));
  ASSERT_EQ(volume.levels, 0);
  int empty = 0, filled = 0;
  for (int z = -1; z < 3; ++z)
    for (int y = -1; y < 3; ++y)
      for (int x = -1; x < 8; ++x) {
        const auto found = volume.find(ivec3(x, y, z) * 8);
        if (!(found.entry.x & BrickVolume::occupied_bit)) continue;
        const float maximum = glm::unpackHalf2x16(found.entry.y).y * volume.density_max;
        const float minimum = maximum * float(found.entry.y >> 8 & 255u) / 255.0f;
        for (int octant = 0; octant < 8; ++octant) {
          const ivec3 corner = found.corner + ivec3(octant & 1, octant >> 1 & 1, octant >> 2) * 4;
          bool holds = false;
          // Its cells reach to the first voxels of what is beside it.
          for (int i = 0; i < 125; ++i) {
            const ivec3 inside(i % 5, i / 5 % 5, i / 25);
            const float density = volume.voxel_density(corner + inside);
            holds = holds || density > 0.0f;
            EXPECT_LE(density, maximum * 1.0001f);
            EXPECT_GE(density, minimum * 0.9999f - 1e-6f);
          }
          EXPECT_EQ(bool(found.entry.y >> octant & 1u), holds);
          ++(holds ? filled : empty);
        }
      }
  EXPECT_GT(empty, 50);
  EXPECT_GT(filled, 50);
}

TEST(BrickVolume, StoresTemperatureForHotBricksAlone) {
  BrickVolumeBuilder builder;
  float density[512], temperature[512];
  for (int i = 0; i < 512; ++i) density[i] = 1.0f, temperature[i] = i < 256 ? 900.0f : 0.0f;
  for (int x = 0; x < 10; ++x) builder.add({x, 0, 0}, density, x == 7 ? temperature : nullptr);
  const BrickVolume volume = builder.build(dmat4(1.0));
  // The hot block, and its seven lower neighbours, which see its hot first layer as their apron.
  EXPECT_EQ(volume.hot_brick_count(), 8u);
  EXPECT_GT(volume.brick_count(), 10u);
  EXPECT_FLOAT_EQ(volume.sample_temperature({60, 4, 2}), 900.0f);
  EXPECT_FLOAT_EQ(volume.sample_temperature({60, 4, 3.5f}), 450.0f);
  EXPECT_FLOAT_EQ(volume.sample_temperature({55.5f, 4, 2}), 450.0f);
  EXPECT_EQ(volume.sample_temperature({20, 4, 2}), 0.0f);
  EXPECT_EQ(volume.sample_temperature({60, 4, 6}), 0.0f);
}

TEST(BrickVolume, IsEmptyAndSamplesToZeroWithoutBlocks) {
  BrickVolumeBuilder builder;
  const BrickVolume volume = builder.build(dmat4(1.0));
  EXPECT_TRUE(volume.empty());
  EXPECT_EQ(volume.sample_density({0, 0, 0}), 0.0f);
}

}  // namespace
}  // namespace plinian
