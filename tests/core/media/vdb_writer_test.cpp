#include "core/media/vdb_writer.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <cmath>

#include "tests/core/media/vdb_test_files.h"

namespace plinian {
namespace {

/// A ball of density around (20, -3, 5), hot in its lower half.
BrickVolume ball(const dmat4& medium_from_index) {
  BrickVolumeBuilder builder;
  for (int bz = -2; bz <= 3; ++bz)
    for (int by = -3; by <= 2; ++by)
      for (int bx = 0; bx <= 5; ++bx) {
        float density[512], temperature[512];
        for (int i = 0; i < 512; ++i) {
          const vec3 p = vec3(bx * 8 + (i & 7), by * 8 + ((i >> 3) & 7), bz * 8 + (i >> 6)) - vec3(20, -3, 5);
          density[i] = std::max(0.0f, 1.0f - glm::length(p) / 12.0f);
          temperature[i] = density[i] > 0.0f && p.y < 0.0f ? 1500.0f - 10.0f * p.y : 0.0f;
        }
        builder.add({bx, by, bz}, density, temperature);
      }
  return builder.build(medium_from_index);
}

TEST(VdbWriter, WritesWhatOpenVdbItselfReadsBack) {
  Folder folder;
  openvdb::initialize();
  dmat4 matrix(1.0);
  matrix[0] = dvec4(0.0, 0.25, 0.0, 0.0);
  matrix[1] = dvec4(-0.5, 0.0, 0.0, 0.0);
  matrix[2] = dvec4(0.0, 0.1, 0.3, 0.0);
  matrix[3] = dvec4(1.0, 2.0, 3.0, 1.0);
  const BrickVolume volume = ball(matrix);
  for (const bool half : {false, true}) {
    VdbWriteOptions options;
    options.half = half;
    options.up_axis = 'z';
    options.file_unit = 0.01;
    options.metadata = {{"seed", "42"}};
    write_vdb(folder / "out.vdb", volume, options);
    openvdb::io::File file(folder / "out.vdb");
    file.open();
    const auto density = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("density"));
    const auto heat = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("temperature"));
    EXPECT_EQ(density->getGridClass(), openvdb::GRID_FOG_VOLUME);
    EXPECT_EQ(density->saveFloatAsHalf(), half);
    EXPECT_EQ(density->activeVoxelCount(), openvdb::Index64(volume.active_voxels));
    EXPECT_EQ(density->background(), 0.0f);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        EXPECT_EQ(density->transform().baseMap()->getAffineMap()->getMat4()(i, j), matrix[i][j]);
    for (int z = -8; z < 18; ++z)
      for (int y = -16; y < 10; ++y)
        for (int x = 7; x < 33; ++x) {
          const openvdb::Coord at(x, y, z);
          ASSERT_NEAR(density->tree().getValue(at), volume.voxel_density({x, y, z}), half ? 3e-4f : 1e-6f);
          ASSERT_NEAR(heat->tree().getValue(at), volume.sample_temperature({x, y, z}), half ? 0.6f : 1e-3f);
        }
    EXPECT_EQ(file.getMetadata()->metaValue<std::string>("seed"), "42");
    const VdbFacts facts = read_vdb(folder / "out.vdb").facts;
    EXPECT_EQ(facts.orientation.up_axis, 'z');
    EXPECT_EQ(facts.orientation.file_unit, 0.01);
    EXPECT_FALSE(facts.orientation.up_assumed || facts.orientation.unit_assumed);
  }
  EXPECT_EQ(folder.files(), 1u);
}

TEST(VdbWriter, WritesAnEmptyVolumeAsAnEmptyGrid) {
  Folder folder;
  write_vdb(folder / "empty.vdb", BrickVolume{});
  const VdbVolume read = read_vdb(folder / "empty.vdb");
  EXPECT_TRUE(read.volume->empty());
  EXPECT_EQ(read.facts.density.at(0).name, "density");
  EXPECT_TRUE(read.facts.temperature.empty());
}

TEST(VdbWriter, AnOutputThatCannotBeWrittenIsOneLineAndHarmsNothing) {
  Folder folder;
  const BrickVolume volume = ball(dmat4(1.0));
  expect_line(error_of([&] { write_vdb(folder / "no/such/folder.vdb", volume); }),
              folder / "no/such/folder.vdb", {"cannot be written", "does not exist"});
  std::filesystem::create_directory(folder / "dir.vdb");
  expect_line(error_of([&] { write_vdb(folder / "dir.vdb", volume); }), folder / "dir.vdb", {"folder"});
  std::filesystem::remove(folder / "dir.vdb");

  // A disk that fills up: what was there stays, and nothing lies beside it. The worker inherits the limit.
  write_bytes(folder / "old.vdb", "precious");
  rlimit before;
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{2000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &full);
  const std::string line = error_of([&] { write_vdb(folder / "old.vdb", volume); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  expect_line(line, folder / "old.vdb", {});
  EXPECT_EQ(read_bytes(folder / "old.vdb"), "precious");
  EXPECT_EQ(folder.files(), 1u);
}

}  // namespace
}  // namespace plinian
