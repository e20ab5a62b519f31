#include "core/media/vdb_reader.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/media/vdb_test_files.h"

namespace plinian {
namespace {

using openvdb::Coord;

dvec3 world_of(const BrickVolume& volume, dvec3 index) {
  return dvec3(volume.medium_from_index * dvec4(index, 1.0));
}

/// 2000 voxels with whole values in [1, 100], all over a box around the origin.
template <class Grid>
std::vector<std::pair<Coord, double>> fill(Grid& grid) {
  std::mt19937 random(7);
  std::map<Coord, double> voxels;
  while (voxels.size() < 2000)
    voxels[Coord(int(random() % 90) - 40, int(random() % 90) - 40, int(random() % 90) - 40)] =
        1.0 + random() % 100;
  if constexpr (std::is_same_v<Grid, openvdb::BoolGrid>)
    for (auto& [at, value] : voxels) value = 1.0;
  for (const auto& [at, value] : voxels)
    grid.tree().setValue(at, static_cast<typename Grid::ValueType>(value));
  return {voxels.begin(), voxels.end()};
}

template <class Grid>
class VdbValueType : public testing::Test {};
using ValueTypes = testing::Types<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid,
                                  openvdb::Int64Grid, openvdb::BoolGrid>;
TYPED_TEST_SUITE(VdbValueType, ValueTypes);

TYPED_TEST(VdbValueType, ReadsEveryVoxelAsItWasWrittenAndNothingElse) {
  Folder folder;
  for (const bool half : {false, true}) {
    auto grid = make_grid<TypeParam>("density");
    const auto voxels = fill(*grid);
    grid->setSaveFloatAsHalf(half);
    save(folder / "types.vdb", {grid});
    const VdbVolume read = read_vdb(folder / "types.vdb");
    const BrickVolume& volume = *read.volume;
    EXPECT_EQ(volume.active_voxels, std::int64_t(voxels.size()));
    EXPECT_EQ(read.facts.density.at(0).active_voxels, std::int64_t(voxels.size()));
    for (const auto& [at, value] :
         voxels)  // whole numbers up to 100 are exact as halves; bricks store 16 bits
      ASSERT_NEAR(volume.voxel_density({at.x(), at.y(), at.z()}), value, 100.0 / 65535.0);
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i) {
      const Coord at(int(random() % 110) - 50, int(random() % 110) - 50, int(random() % 110) - 50);
      if (grid->tree().isValueOn(at)) continue;
      ASSERT_EQ(volume.voxel_density({at.x(), at.y(), at.z()}), 0.0f);
    }
    EXPECT_TRUE(read.facts.warnings.empty());
    EXPECT_TRUE(read.facts.notes.empty());
  }
}

TEST(VdbReader, KeepsEveryAffineTransformToTheLastBit) {
  Folder folder;
  const std::vector<openvdb::Mat4d> matrices = {
      matrix({0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0.1, 0, 3, -2, 7, 1}),  // uniform, moved
      matrix({-0.3, 0, 0, 0, 0, 0.2, 0, 0, 0, 0, 0.7, 0, 1, 2, 3, 1}),  // mirrored and anisotropic
      matrix({0.5, 0.1, -0.2, 0, 0.3, 0.4, 0.05, 0, -0.1, 0.2, 0.9, 0, 5, 6, 7, 1}),  // sheared and rotated
      matrix({0, 1e-3, 0, 0, 0, 0, 1e-3, 0, 1e-3, 0, 0, 0, 0, 0, 0, 1}),              // axes swapped, tiny
  };
  const std::vector<std::string> kinds = {"uniform", "anisotropic", "affine", "affine"};
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    auto grid = dot("density", {3, 4, 5});
    grid->setTransform(openvdb::math::Transform::createLinearTransform(matrices[i]));
    save(folder / "transform.vdb", {grid});
    const VdbVolume read = read_vdb(folder / "transform.vdb");
    // OpenVDB itself rounds a matrix that is only a scale and a translation; from there on every bit is kept.
    const openvdb::Mat4d stored = grid->transform().baseMap()->getAffineMap()->getMat4();
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) {
        EXPECT_EQ(read.volume->medium_from_index[r][c], stored(r, c)) << i;
        EXPECT_NEAR(stored(r, c), matrices[i](r, c), 1e-15);
      }
    const openvdb::Vec3d truth = grid->transform().indexToWorld(openvdb::Vec3d(3, 4, 5));
    EXPECT_LT(glm::length(world_of(*read.volume, {3, 4, 5}) - dvec3(truth[0], truth[1], truth[2])), 1e-12);
    EXPECT_EQ(read.facts.density[0].transform, kinds[i]);
  }
}

TEST(VdbReader, TakesDensityElseTheOnlyGridThatCanBeItAndSaysSo) {
  Folder folder;
  save(folder / "a.vdb", {dot("smoke", {1, 1, 1}, 5.0f), dot("density", {1, 1, 1}, 2.0f)});
  const VdbVolume density = read_vdb(folder / "a.vdb");
  EXPECT_FLOAT_EQ(density.volume->density_max, 2.0f);
  EXPECT_TRUE(density.facts.notes.empty());
  EXPECT_EQ(density.facts.density.at(0).name, "density");

  auto level_set = dot("surface");
  level_set->setGridClass(openvdb::GRID_LEVEL_SET);
  save(folder / "b.vdb",
       {level_set, dot("smoke", {1, 1, 1}, 5.0f), dot("heat"), make_grid<openvdb::Vec3SGrid>("v")});
  const VdbVolume only = read_vdb(folder / "b.vdb");
  EXPECT_FLOAT_EQ(only.volume->density_max, 5.0f);
  EXPECT_TRUE(says(only.facts, "\"smoke\", the only grid"));

  VdbOptions options;
  options.grid = "smoke";
  EXPECT_FLOAT_EQ(read_vdb(folder / "a.vdb", options).volume->density_max, 5.0f);
}

TEST(VdbReader, OpensGridsOfOneNameOneByOne) {
  Folder folder;
  save(folder / "three.vdb", {dot("density", {0, 0, 0}, 1.0f), dot("density", {0, 0, 0}, 2.0f),
                              dot("density", {0, 0, 0}, 3.0f), dot("literal[1]", {0, 0, 0}, 9.0f)});
  VdbOptions options;
  for (int i = 0; i < 3; ++i) {
    options.grid = "density[" + std::to_string(i) + "]";
    const VdbVolume read = read_vdb(folder / "three.vdb", options);
    EXPECT_FLOAT_EQ(read.volume->density_max, 1.0f + i);
    EXPECT_EQ(read.facts.density.at(0).name, options.grid);
  }
  options.grid = "literal[1]";  // a name that only looks like an index
  EXPECT_FLOAT_EQ(read_vdb(folder / "three.vdb", options).volume->density_max, 9.0f);
}

TEST(VdbReader, SumsGridsVoxelByVoxelWhereTheirLatticesMeet) {
  Folder folder;
  const auto block = [](float value, int from, double offset) {
    auto grid = make_grid("density");
    for (int z = from; z < from + 12; ++z)
      for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) grid->tree().setValue({x, y, z}, value);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(
        matrix({0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, offset, 1})));
    return grid;
  };
  // The third lattice lies 20 voxels further along z, so its voxel -20 is voxel 0 of the others.
  save(folder / "sum.vdb", {block(1.0f, 0, 0.0), block(2.0f, 6, 0.0), block(4.0f, -20, 2.0)});
  VdbOptions options;
  options.grid = "density[*]";
  const VdbVolume read = read_vdb(folder / "sum.vdb", options);
  for (int z = -3; z < 21; ++z) {
    const float expected = (z >= 0 && z < 12 ? 5.0f : 0.0f) + (z >= 6 && z < 18 ? 2.0f : 0.0f);
    EXPECT_NEAR(read.volume->voxel_density({5, 5, z}), expected, 7.0f / 65535.0f) << z;
  }
  EXPECT_EQ(read.volume->active_voxels, 12 * 12 * 18);
  EXPECT_TRUE(says(read.facts, "the 3 grids \"density\" are summed"));
  EXPECT_TRUE(says(read.facts, "1 of them on other lattices"));
  EXPECT_EQ(read.facts.density.size(), 3u);
}

TEST(VdbReader, SumsOntoTheFinestLatticeWithLinearFieldsExact) {
  Folder folder;
  // Both sample the same field f = 10 + x + 2y - z of world space, one coarsely under a turned and mirrored
  // lattice.
  const auto field = [](openvdb::Vec3d p) { return 10.0 + p[0] + 2.0 * p[1] - p[2]; };
  const auto sampled = [&](const openvdb::Mat4d& m, int from, int to) {
    auto grid = make_grid("density");
    grid->setTransform(openvdb::math::Transform::createLinearTransform(m));
    for (int z = from; z <= to; ++z)
      for (int y = from; y <= to; ++y)
        for (int x = from; x <= to; ++x)
          grid->tree().setValue({x, y, z}, float(field(grid->transform().indexToWorld(Coord(x, y, z)))));
    return grid;
  };
  const auto coarse =
      sampled(matrix({0, 0.31, 0, 0, -0.27, 0, 0, 0, 0, 0, -0.25, 0, 0.1, 0.2, 0.3, 1}), -8, 8);
  const auto fine = sampled(matrix({0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 1}), -4, 4);
  save(folder / "sum.vdb", {coarse, fine});
  VdbOptions options;
  options.grid = "density[*]";
  const VdbVolume read = read_vdb(folder / "sum.vdb", options);
  EXPECT_DOUBLE_EQ(read.volume->medium_from_index[0][0], 0.1);
  for (int i = -4; i <= 4; ++i) {
    const double once = field(openvdb::Vec3d(0.1 * i, -0.1 * i, 0.1 * i));
    EXPECT_NEAR(read.volume->voxel_density({i, -i, i}), 2.0 * once, 1e-3) << i;
  }
  // Where the fine grid ends the coarse one goes on alone.
  EXPECT_NEAR(read.volume->voxel_density({9, 0, 0}), field(openvdb::Vec3d(0.9, 0, 0)), 1e-3);
}

TEST(VdbReader, TurnsActiveTilesIntoVoxels) {
  Folder folder;
  auto grid = make_grid("density");
  grid->tree().fill(openvdb::CoordBBox({0, 0, 0}, {31, 15, 7}), 2.5f);        // tiles of 8^3
  grid->tree().fill(openvdb::CoordBBox({128, 0, 0}, {255, 127, 127}), 0.5f);  // one tile of 128^3
  grid->tree().fill(openvdb::CoordBBox({1000, 0, 0}, {1007, 7, 7}), 0.0f);    // active, and nothing
  ASSERT_GT(grid->tree().activeTileCount(), 0u);
  ASSERT_EQ(grid->tree().leafCount(), 0u);
  save(folder / "tiles.vdb", {grid});
  const BrickVolume volume = *read_vdb(folder / "tiles.vdb").volume;
  EXPECT_EQ(volume.active_voxels, 32 * 16 * 8 + 128 * 128 * 128);
  EXPECT_EQ(volume.leaf_count, 4 * 2 * 1 + 16 * 16 * 16);
  EXPECT_NEAR(volume.voxel_density({31, 15, 7}), 2.5f, 1e-3f);
  EXPECT_NEAR(volume.voxel_density({200, 127, 64}), 0.5f, 1e-3f);
  EXPECT_EQ(volume.voxel_density({256, 0, 0}), 0.0f);
}

TEST(VdbReader, CountsAndMendsValuesThatAreNoDensity) {
  Folder folder;
  auto grid = make_grid("density");
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 3; ++i) grid->tree().setValue({i, 0, 0}, nan);
  for (int i = 0; i < 2; ++i) grid->tree().setValue({i, 1, 0}, inf);
  for (int i = 0; i < 4; ++i) grid->tree().setValue({i, 2, 0}, -1.0f);
  grid->tree().setValue({0, 3, 0}, -inf);
  grid->tree().setValue({0, 4, 0}, 6.0f);
  grid->tree().addTile(1, {64, 0, 0}, nan, true);  // 8^3 voxels
  grid->tree().addTile(1, {64, 64, 0}, -3.0f, true);
  save(folder / "bad.vdb", {grid});
  const VdbVolume read = read_vdb(folder / "bad.vdb");
  EXPECT_EQ(count_of(read.facts, "not_a_number"), 3 + 512);
  EXPECT_EQ(count_of(read.facts, "infinite"), 3);
  EXPECT_EQ(count_of(read.facts, "negative"), 4 + 512);
  EXPECT_FLOAT_EQ(read.volume->density_max, 6.0f);
  EXPECT_EQ(read.volume->active_voxels, 3);  // the 6 and the two infinities
  EXPECT_FLOAT_EQ(read.volume->voxel_density({1, 1, 0}), 6.0f);
  EXPECT_EQ(read.volume->voxel_density({1, 0, 0}), 0.0f);
}

TEST(VdbReader, CountsMendedValuesOnceWhereGridsAreSummed) {
  Folder folder;
  auto bad = dot("density", {1, 0, 0}, std::numeric_limits<float>::quiet_NaN());
  bad->tree().setValue({0, 0, 0}, -5.0f);
  auto good = dot("density", {0, 0, 0}, 2.0f);
  good->tree().setValue({1, 0, 0}, 3.0f);
  save(folder / "sum.vdb", {bad, good});
  VdbOptions options;
  options.grid = "density[*]";
  const VdbVolume read = read_vdb(folder / "sum.vdb", options);
  EXPECT_EQ(count_of(read.facts, "not_a_number"), 1);
  EXPECT_EQ(count_of(read.facts, "negative"), 1);
  EXPECT_NEAR(read.volume->voxel_density({1, 0, 0}), 3.0f, 1e-4f);
  EXPECT_NEAR(read.volume->voxel_density({0, 0, 0}), 2.0f, 1e-4f);
}

TEST(VdbReader, TreatsANonZeroBackgroundAsNothingAndSaysSo) {
  Folder folder;
  auto grid = make_grid("density", 0.75f);
  grid->tree().setValue({4, 4, 4}, 1.0f);
  save(folder / "background.vdb", {grid});
  const VdbVolume read = read_vdb(folder / "background.vdb");
  EXPECT_EQ(read.volume->active_voxels, 1);
  EXPECT_EQ(read.volume->voxel_density({3, 4, 4}), 0.0f);
  EXPECT_EQ(count_of(read.facts, "background"), 1);
}

TEST(VdbReader, ReadsAnEmptyGridAsNothingWithAWarning) {
  Folder folder;
  auto zeros = make_grid("density");
  zeros->tree().setValue({1, 2, 3}, 0.0f);
  for (const auto& grid : {make_grid("density"), zeros}) {
    save(folder / "empty.vdb", {grid});
    const VdbVolume read = read_vdb(folder / "empty.vdb");
    EXPECT_TRUE(read.volume->empty());
    EXPECT_EQ(count_of(read.facts, "empty"), 1);
  }
}

TEST(VdbReader, HoldsTwoVoxelsAMillionApartInLittleMemory) {
  Folder folder;
  auto grid = dot("density", {0, 0, 0}, 1.0f);
  grid->tree().setValue({1000000, 1000000, 1000000}, 2.0f);
  save(folder / "sparse.vdb", {grid});
  const VdbVolume read = read_vdb(folder / "sparse.vdb");
  EXPECT_EQ(read.volume->active_voxels, 2);
  EXPECT_LT(read.volume->bytes(), 4u << 20);
  EXPECT_EQ(count_of(read.facts, "sparse_box"), 2);
  // Index space was moved towards the voxels; where they are in the file's space was not.
  const ivec3 last = read.volume->bounds_max - 1;
  EXPECT_FLOAT_EQ(read.volume->voxel_density(last), 2.0f);
  EXPECT_LT(glm::length(world_of(*read.volume, dvec3(last)) - dvec3(1e6)), 1e-6);
}

TEST(VdbReader, MovesFarIndexSpacesCloseSoThatSinglePrecisionResolvesThem) {
  Folder folder;
  auto grid = dot("density", {40000003, -8, 12}, 3.0f);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(0.25));
  save(folder / "far.vdb", {grid});
  const VdbVolume read = read_vdb(folder / "far.vdb");
  const BrickVolume& volume = *read.volume;
  const ivec3 voxel = volume.bounds_min + 1;
  EXPECT_LT(std::abs(voxel.x), 64);
  EXPECT_FLOAT_EQ(volume.sample_density(vec3(voxel) + vec3(0.5f, 0, 0)), 1.5f);
  EXPECT_LT(glm::length(world_of(volume, dvec3(voxel)) - dvec3(40000003, -8, 12) * 0.25), 1e-6);
  EXPECT_TRUE(says(read.facts, "index space is moved"));
}

TEST(VdbReader, TakesANormalisedTemperatureToAPeakOf1800KelvinAloud) {
  Folder folder;
  for (const std::string name : {"temperature", "heat", "flame"}) {
    auto heat = dot(name, {0, 0, 0}, 0.5f);
    heat->tree().setValue({1, 0, 0}, 0.25f);
    auto density = dot("density", {0, 0, 0}, 1.0f);
    density->tree().setValue({1, 0, 0}, 1.0f);
    density->tree().setValue({2, 0, 0}, 1.0f);
    save(folder / "heat.vdb", {density, heat});
    const VdbVolume read = read_vdb(folder / "heat.vdb");
    EXPECT_NEAR(read.volume->sample_temperature({0, 0, 0}), 1800.0f, 0.1f);
    EXPECT_NEAR(read.volume->sample_temperature({1, 0, 0}), 900.0f, 0.1f);
    EXPECT_EQ(read.volume->sample_temperature({2, 0, 0}), 0.0f);
    EXPECT_DOUBLE_EQ(read.facts.temperature_gain, 3600.0);
    EXPECT_DOUBLE_EQ(read.facts.temperature_peak, 0.5);
    EXPECT_TRUE(says(read.facts, "scaled to a peak of 1800 K"));
    EXPECT_EQ(read.facts.temperature.at(0).name, name);
  }
}

TEST(VdbReader, KeepsKelvinsAndPicksOrLeavesOutTheTemperatureThatIsAskedFor) {
  Folder folder;
  save(folder / "heat.vdb",
       {dot("density"), dot("temperature", {0, 0, 0}, 1200.0f), dot("heat", {0, 0, 0}, 2400.0f)});
  VdbOptions options;
  const VdbVolume read = read_vdb(folder / "heat.vdb");
  EXPECT_NEAR(read.volume->sample_temperature({0, 0, 0}), 1200.0f, 0.1f);
  EXPECT_EQ(read.facts.temperature_gain, 1.0);
  EXPECT_TRUE(read.facts.notes.empty());
  options.temperature_grid = "heat";
  EXPECT_NEAR(read_vdb(folder / "heat.vdb", options).volume->sample_temperature({0, 0, 0}), 2400.0f, 0.1f);
  options.temperature_grid = "none";
  EXPECT_TRUE(read_vdb(folder / "heat.vdb", options).volume->temperature.empty());
  EXPECT_TRUE(read_vdb(folder / "heat.vdb", options).facts.temperature.empty());
  options.temperature_grid = "embers";
  expect_line(error_of([&] { read_vdb(folder / "heat.vdb", options); }), folder / "heat.vdb",
              {"\"embers\"", "density (float), temperature (float), heat (float)"});
}

TEST(VdbReader, ResamplesTemperatureOntoTheVoxelsOfTheDensity) {
  Folder folder;
  auto density = make_grid("density");
  density->setTransform(openvdb::math::Transform::createLinearTransform(0.5));
  for (int i = 0; i < 16; ++i) density->tree().setValue({i, 3, 3}, 1.0f);
  auto heat = make_grid("temperature");
  heat->setTransform(openvdb::math::Transform::createLinearTransform(2.0));
  for (int z = -2; z < 8; ++z)
    for (int y = -2; y < 8; ++y)
      for (int x = -2; x < 8; ++x) heat->tree().setValue({x, y, z}, 1000.0f + 100.0f * x);
  save(folder / "heat.vdb", {density, heat});
  const VdbVolume read = read_vdb(folder / "heat.vdb");
  for (int i = 0; i < 16; ++i)  // voxel i lies at 0.5 i, which is 0.25 i in the temperature's voxels
    EXPECT_NEAR(read.volume->sample_temperature({float(i), 3, 3}), 1000.0 + 25.0 * i, 0.1) << i;
  EXPECT_TRUE(says(read.facts, "resampled onto the voxels of the density"));
}

TEST(VdbReader, ConvertsALevelSetToFogWhereAsked) {
  Folder folder;
  auto ball = make_grid("ball", 3.0f);  // a sphere of radius 20, narrow band of 3
  ball->setGridClass(openvdb::GRID_LEVEL_SET);
  for (int z = -24; z <= 24; ++z)
    for (int y = -24; y <= 24; ++y)
      for (int x = -24; x <= 24; ++x) {
        const float distance = std::sqrt(float(x * x + y * y + z * z)) - 20.0f;
        if (std::abs(distance) < 3.0f)
          ball->tree().setValue({x, y, z}, distance);
        else if (distance < 0.0f)
          ball->tree().setValueOff({x, y, z}, -3.0f);
      }
  save(folder / "ball.vdb", {ball});
  VdbOptions options;
  options.level_set = LevelSetMode::fog;
  const VdbVolume read = read_vdb(folder / "ball.vdb", options);
  EXPECT_NEAR(read.volume->voxel_density({0, 0, 0}), 1.0f, 1e-4f);
  EXPECT_NEAR(read.volume->voxel_density({18, 0, 0}), 2.0f / 3.0f, 1e-4f);
  EXPECT_EQ(read.volume->voxel_density({21, 0, 0}), 0.0f);
  EXPECT_TRUE(says(read.facts, "converted to a fog volume"));
}

TEST(VdbReader, ResamplesAFrustumOntoEqualVoxelsWhereAsked) {
  Folder folder;
  auto grid = make_grid("density");
  grid->tree().fill(openvdb::CoordBBox({8, 8, 8}, {31, 31, 31}), 2.0f);
  // 40 x 40 x 40 voxels from a near plane of side 20 at z = 0 to a far one twice as wide at z = 40.
  const auto scale = std::make_shared<openvdb::math::UniformScaleMap>(20.0);
  grid->setTransform(
      std::make_shared<openvdb::math::Transform>(std::make_shared<openvdb::math::NonlinearFrustumMap>(
          openvdb::BBoxd({0, 0, 0}, {40, 40, 40}), 0.5, 2.0, scale)));
  save(folder / "frustum.vdb", {grid});
  VdbOptions options;
  options.frustum = FrustumMode::resample;
  const VdbVolume read = read_vdb(folder / "frustum.vdb", options);
  EXPECT_TRUE(says(read.facts, "resampled onto equal voxels"));
  // Wherever the frustum has density, so has the lattice, and nowhere else.
  const dmat4 index_from_medium = glm::inverse(read.volume->medium_from_index);
  int inside = 0, outside = 0;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-4.0, 44.0);
  for (int i = 0; i < 4000; ++i) {
    const openvdb::Vec3d index(anywhere(random), anywhere(random), anywhere(random));
    const openvdb::Vec3d world = grid->transform().indexToWorld(index);
    const float density = read.volume->sample_density(
        vec3(dvec3(index_from_medium * dvec4(world[0], world[1], world[2], 1.0))));
    double low = 1e9, high = -1e9;
    for (int axis = 0; axis < 3; ++axis) {
      low = std::min({low, index[axis] - 8.0, 31.0 - index[axis]});
      high = std::max({high, 8.0 - index[axis], index[axis] - 31.0});
    }
    if (low > 2.0) {
      EXPECT_NEAR(density, 2.0f, 1e-3f);
      ++inside;
    } else if (high > 3.0) {
      EXPECT_EQ(density, 0.0f);
      ++outside;
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 1000);
}

TEST(VdbReader, ReadsFilesWithoutATableAndGridsThatShareATree) {
  Folder folder;
  openvdb::initialize();
  {  // written as a stream, a file has no offsets to seek by
    std::ofstream out(folder / "stream.vdb", std::ios::binary);
    openvdb::io::Stream(out).write(
        openvdb::GridPtrVec{dot("other", {0, 0, 0}, 4.0f), dot("density", {0, 0, 0}, 7.0f)});
  }
  EXPECT_FLOAT_EQ(read_vdb(folder / "stream.vdb").volume->density_max, 7.0f);
  const auto first = dot("density", {2, 2, 2}, 5.0f);
  const openvdb::FloatGrid::Ptr second = first->copy();
  second->setName("twin");
  second->setTransform(openvdb::math::Transform::createLinearTransform(3.0));
  save(folder / "shared.vdb", {first, second});
  VdbOptions options;
  options.grid = "twin";
  const VdbVolume twin = read_vdb(folder / "shared.vdb", options);
  EXPECT_NEAR(twin.volume->voxel_density({2, 2, 2}), 5.0f, 1e-4f);
  EXPECT_DOUBLE_EQ(twin.volume->medium_from_index[0][0], 3.0);
}

TEST(VdbReader, OpensPathsOfAnyBytes) {
  Folder folder;
  const std::string path = folder / "a b\"\n\xff'.vdb";
  save(path, {dot()});
  EXPECT_EQ(read_vdb(path).volume->active_voxels, 1);
}

TEST(VdbReader, GuessesUnitAndUpAxisFromWhoWroteTheFileAndSaysWhenItCannot) {
  Folder folder;
  const auto orientation = [&](const std::string& key, const std::string& value) {
    openvdb::MetaMap metadata;
    metadata.insertMeta(key, openvdb::StringMetadata(value));
    save(folder / "a.vdb", {dot()}, metadata);
    return read_vdb(folder / "a.vdb").facts.orientation;
  };
  const VdbOrientation blender = orientation("creator", "Blender/Smoke");
  EXPECT_EQ(blender.up_axis, 'z');
  EXPECT_FALSE(blender.up_assumed);
  EXPECT_NE(blender.reason.find("Blender/Smoke"), std::string::npos);
  // What was up stays up: the file's z becomes the scene's y, without mirroring.
  EXPECT_EQ(dvec3(blender.world_from_medium() * dvec4(0, 0, 1, 0)), dvec3(0, 1, 0));
  EXPECT_DOUBLE_EQ(glm::determinant(blender.world_from_medium()), 1.0);
  EXPECT_EQ(orientation("blender/smoke/dt", "0.1").up_axis, 'z');
  EXPECT_EQ(orientation("creator", "Houdini 20/GEO_VDBTranslator").up_axis, 'y');
  EXPECT_FALSE(orientation("creator", "Houdini 20/GEO_VDBTranslator").up_assumed);
  const VdbOrientation unknown = orientation("creator", "Somebody");
  EXPECT_EQ(unknown.up_axis, 'y');
  EXPECT_TRUE(unknown.up_assumed && unknown.unit_assumed);
  EXPECT_NE(unknown.reason.find("assumed"), std::string::npos);
}

TEST(VdbReader, CanBeCancelledAndTellsHowFarItIs) {
  Folder folder;
  auto grid = make_grid("density");
  std::mt19937 random(1);
  for (int i = 0; i < 200000; ++i)
    grid->tree().setValue(Coord(random() % 256, random() % 256, random() % 256),
                          float(random() % 1000) / 7.0f);
  save(folder / "large.vdb", {grid});
  VdbOptions options;
  double last = -1.0;
  options.progress = [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
    return true;
  };
  read_vdb(folder / "large.vdb", options);
  EXPECT_GT(last, 0.5);
  options.progress = [](double share) { return share < 0.3; };
  EXPECT_THROW(read_vdb(folder / "large.vdb", options), VdbCancelled);
}

TEST(VdbInspect, ListsEveryGridWithWhatItCanBeUsedFor) {
  Folder folder;
  auto ball = dot("ball");
  ball->setGridClass(openvdb::GRID_LEVEL_SET);
  auto density = dot("density", {-3, 2, 10}, 0.25f);
  density->tree().setValue({4, 2, 10}, 8.0f);
  density->setGridClass(openvdb::GRID_FOG_VOLUME);
  density->insertMeta("note", openvdb::StringMetadata("hello"));
  auto speed = make_grid<openvdb::Vec3SGrid>("v");
  speed->tree().setValue({0, 0, 0}, {1, 2, 3});
  save(folder / "a.vdb", {density, ball, speed, dot("twice"), dot("twice")});
  const VdbInfo info = inspect_vdb(folder / "a.vdb");
  ASSERT_EQ(info.grids.size(), 5u);
  const VdbGridInfo& first = info.grids[0];
  EXPECT_EQ(first.name, "density");
  EXPECT_EQ(first.value_type, "float");
  EXPECT_EQ(first.grid_class, "fog volume");
  EXPECT_EQ(first.active_voxels, 2);
  EXPECT_EQ(first.index_min, (std::array<std::int64_t, 3>{-3, 2, 10}));
  EXPECT_EQ(first.dims, (std::array<std::int64_t, 3>{8, 1, 1}));
  EXPECT_EQ(first.minimum, 0.25);
  EXPECT_EQ(first.maximum, 8.0);
  EXPECT_EQ(first.metadata.at("note"), "hello");
  EXPECT_TRUE(first.refusal.empty());
  EXPECT_NE(info.grids[1].refusal.find("--level-set fog"), std::string::npos);
  EXPECT_EQ(info.grids[2].value_type, "vec3s");
  EXPECT_EQ(info.grids[2].active_voxels, 1);
  EXPECT_FALSE(info.grids[2].refusal.empty());
  EXPECT_EQ(info.grids[4].name, "twice[1]");

  // The same by what stands before the voxels, without any of them.
  const std::size_t file_bytes = read_bytes(folder / "a.vdb").size();
  const VdbInfo listed = list_vdb(folder / "a.vdb");
  ASSERT_EQ(listed.grids.size(), 5u);
  for (std::size_t i = 0; i < listed.grids.size(); ++i) {
    EXPECT_EQ(listed.grids[i].name, info.grids[i].name);
    EXPECT_EQ(listed.grids[i].value_type, info.grids[i].value_type);
    EXPECT_EQ(listed.grids[i].grid_class, info.grids[i].grid_class);
    EXPECT_EQ(listed.grids[i].refusal, info.grids[i].refusal);
    EXPECT_EQ(listed.grids[i].dims, info.grids[i].dims);
    EXPECT_EQ(listed.grids[i].active_voxels, info.grids[i].active_voxels);
    EXPECT_GT(listed.grids[i].stored_bytes, 0u);
    EXPECT_LT(listed.grids[i].stored_bytes, file_bytes);
    EXPECT_EQ(listed.grids[i].leaves, 0u);
    EXPECT_FALSE(listed.grids[i].maximum.has_value());
  }
}

TEST(VdbRealFiles, AreReadAsTheirReadmeDescribesThem) {
  PLINIAN_NEEDS_REAL_FILES();
  const VdbVolume smoke = read_vdb(real_file("smoke.vdb"));
  EXPECT_EQ(smoke.volume->active_voxels, 1049275);
  EXPECT_NEAR(smoke.volume->density_max, 5.71484, 1e-5);
  EXPECT_EQ(smoke.facts.density[0].value_type, "half");
  EXPECT_EQ(smoke.facts.density[0].dims, (std::array<std::int64_t, 3>{111, 222, 112}));
  const VdbVolume hot = read_vdb(real_file("densityAndHeat.vdb"));
  EXPECT_NEAR(hot.volume->temperature_max, 1800.0f, 0.01f);
  EXPECT_EQ(hot.facts.density[0].transform, "anisotropic");
  EXPECT_EQ(count_of(read_vdb(real_file("smoke_000001.vdb")).facts, "empty"), 1);
  EXPECT_EQ(read_vdb(real_file("smoke_000001.vdb")).facts.orientation.up_axis, 'z');
  EXPECT_TRUE(says(read_vdb(real_file("torus01.vdb")).facts, "voxel_fog_density"));
  VdbOptions options;
  options.grid = "density[2]";
  EXPECT_EQ(read_vdb(real_file("grids.vdb"), options).volume->active_voxels, 803);
  options.grid = "density[*]";  // they lie 2 apart; two of them touch nothing of each other
  const VdbVolume sum = read_vdb(real_file("grids.vdb"), options);
  EXPECT_GT(sum.volume->active_voxels, 2222);
  EXPECT_LE(sum.volume->active_voxels, 491 + 2222 + 803);
  options = {};
  options.level_set = LevelSetMode::fog;
  EXPECT_NEAR(read_vdb(real_file("sphere.vdb"), options).volume->voxel_density({0, 0, 0}), 1.0f, 1e-4f);
}

}  // namespace
}  // namespace plinian
