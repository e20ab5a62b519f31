// The program on .vdb files that are wrong or awkward in every way there is, made on the spot: one line and
// nothing written, or a sane picture and a warning that counts.
#include <sys/resource.h>

#include <limits>

#include "tests/core/media/vdb_test_files.h"
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;

class MadeFiles : public Program {
 protected:
  std::string file(const std::string& name) const { return (made_.path() / name).string(); }
  std::string made(const std::string& name, const openvdb::GridPtrVec& grids) {
    save(file(name), grids);
    return name;
  }
  // Rendering fails with one line that begins with the file and holds the words, beside an old picture that
  // stays as it was; info on the same file ends as well.
  void expect_error(const std::string& name, const std::vector<std::string>& words,
                    const std::vector<std::string>& more = {}, const RunOptions& options = {}) {
    SCOPED_TRACE(name);
    folder_.write("out.png", "precious");
    std::vector<std::string> arguments = {"render", file(name), "-o", "out.png", "-o", "out.exr", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = run(arguments, options);
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(ended.error_lines(), 1) << ended.err;
    for (const std::string& word : words) EXPECT_NE(ended.err.find(word), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find(name), std::string::npos) << ended.err;
    EXPECT_EQ(read_bytes(folder_ / "out.png"), "precious");
    EXPECT_FALSE(fs::exists(folder_.path() / "out.exr"));
  }
  // Renders and returns what was said; checks that the picture is sane: finite, transmittance in [0, 1],
  // nothing negative.
  std::string sane_picture(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"render",   file(name), "-o",       "a.exr",
                                          "--size",   "32x32",    "--passes", "2",
                                          "--pixels", "float",    "--set",    "map.resolution=64"};
    if (std::find(more.begin(), more.end(), "--renderer") == more.end())
      arguments.insert(arguments.end(), {"--renderer", "cpu"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    if (ended.code != 0) return ended.err;
    for (const Channel& channel : picture("a.exr").channels) {
      if (channel.name == "Z") continue;  // infinite where there is nothing
      for (const float value : channel.values) {
        EXPECT_TRUE(std::isfinite(value) && value >= 0.0f) << channel.name << " " << value;
        if (channel.name == "A" || channel.name.starts_with("transmittance")) {
          EXPECT_LE(value, 1.00001f) << channel.name;
        }
        if (HasFailure()) return ended.err;
      }
    }
    return ended.err;
  }
  TemporaryFolder made_;
};

openvdb::FloatGrid::Ptr ball(float value = 1.0f) {
  auto grid = make_grid("density");
  for (int z = -6; z <= 6; ++z)
    for (int y = -6; y <= 6; ++y)
      for (int x = -6; x <= 6; ++x)
        if (x * x + y * y + z * z <= 36) grid->tree().setValue({x, y, z}, value);
  return grid;
}

TEST_F(MadeFiles, WithoutAGridThatCouldBeDensity) {
  expect_error(made("none.vdb", {}), {"no grids"});
  expect_error(made("v.vdb", {make_grid<openvdb::Vec3SGrid>("velocity")}), {"velocity", "vec3s"});
  expect_error(made("s.vdb", {make_grid<openvdb::Vec3SGrid>("v"), dot("smoke"), dot("dust")}),
               {"smoke (float), dust (float)", "--grid"});
  expect_error(made("d.vdb", {dot(), dot()}), {"density[0], density[1]", "density[*]"},
               {"--grid", "density"});
  expect_error("d.vdb", {"no grid \"smoke\"", "density"}, {"--grid", "smoke"});
  expect_error(made("strings.vdb", {make_grid<openvdb::DoubleGrid>("names"), dot("smoke")}), {"names"},
               {"--grid", "nams"});
  std::string bytes = read_bytes(file("strings.vdb"));
  bytes.replace(bytes.find("Tree_double"), 11, "Tree_string");
  write_bytes(file("strings.vdb"), bytes);
  expect_error("strings.vdb", {"names", "string"}, {"--grid", "names"});
  auto surface = dot("surface");
  surface->setGridClass(openvdb::GRID_LEVEL_SET);
  expect_error(made("level.vdb", {surface}), {"surface", "--level-set fog"});
}

TEST_F(MadeFiles, WithATransformThatPlacesNothing) {
  auto frustum = dot();
  frustum->setTransform(
      openvdb::math::Transform::createFrustumTransform(openvdb::BBoxd({0, 0, 0}, {10, 10, 10}), 0.5, 1.0));
  expect_error(made("frustum.vdb", {frustum}), {"frustum", "--frustum resample"});
  constexpr double mark = 0.123456789;
  auto singular = dot();
  singular->setTransform(openvdb::math::Transform::createLinearTransform(mark));
  made("singular.vdb", {singular});
  ASSERT_GT(patch_double(file("singular.vdb"), mark, 0.0), 0);
  expect_error("singular.vdb", {"density", "transform"});
}

TEST_F(MadeFiles, ThatAreCutFlippedHangOrEatMemory) {
  made("whole.vdb", {ball()});
  const std::string bytes = read_bytes(file("whole.vdb"));
  write_bytes(file("cut.vdb"), bytes.substr(0, bytes.size() * 2 / 3));
  expect_error("cut.vdb", {"damaged"});
  std::string flipped = bytes;
  for (std::size_t i = 30; i < 300; i += 7) flipped[i] ^= 0x55;
  write_bytes(file("flipped.vdb"), flipped);
  expect_error("flipped.vdb", {});

  const std::string worker = made_.write("worker", "#!/bin/sh\nexec sleep 100\n");
  fs::permissions(worker, fs::perms::owner_all);
  RunOptions hanging;
  hanging.environment = {{"PLINIAN_VDB_WORKER", worker}};
  const auto start = std::chrono::steady_clock::now();
  expect_error("whole.vdb", {"--vdb-time-limit"}, {"--vdb-time-limit", "1"}, hanging);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15));

  auto terabyte = make_grid("density");
  terabyte->tree().addTile(3, {0, 0, 0}, 1.0f, true);  // 4096^3 voxels
  expect_error(made("terabyte.vdb", {terabyte}), {"--vdb-memory-limit"});
}

TEST_F(MadeFiles, WithVoxelsThatAreNoDensityGiveASanePictureAndAreCounted) {
  auto grid = ball();
  const float infinity = std::numeric_limits<float>::infinity();
  for (int i = -3; i < 0; ++i) grid->tree().setValue({i, 0, 6}, std::numeric_limits<float>::quiet_NaN());
  for (int i = 0; i < 2; ++i) grid->tree().setValue({i, 1, 6}, infinity);
  for (int i = 0; i < 4; ++i) grid->tree().setValue({i, 2, 5}, -1.0f);
  made("bad.vdb", {grid});
  for (const char* renderer : {"cpu", "reference"}) {
    const std::string said = sane_picture("bad.vdb", {"--renderer", renderer});
    for (const char* count : {"warning: bad.vdb: 3 ", "warning: bad.vdb: 2 ", "warning: bad.vdb: 4 "})
      EXPECT_NE(said.find(count), std::string::npos) << count << "in: " << said;
    EXPECT_GT(mean_of(picture("a.exr"), "A"), 0.1);
  }
}

TEST_F(MadeFiles, WithNothingInThemGiveTheBackgroundAndAWarning) {
  made("empty.vdb", {make_grid("density")});
  const std::string said = sane_picture("empty.vdb", {"--set", "background=0.25"});
  EXPECT_NE(said.find("warning: empty.vdb: "), std::string::npos) << said;
  EXPECT_NEAR(mean_of(picture("a.exr"), "G"), 0.25, 1e-6);
  EXPECT_EQ(mean_of(picture("a.exr"), "A"), 0.0);
}

TEST_F(MadeFiles, OfAHugeBoxWithTwoVoxelsTakeTheMemoryOfTwoVoxels) {
  auto grid = dot("density", {0, 0, 0}, 1.0f);
  grid->tree().setValue({1000000, 1000000, 1000000}, 2.0f);
  made("sparse.vdb", {grid});
  const std::string said = sane_picture("sparse.vdb");
  EXPECT_NE(said.find("warning: sparse.vdb: 2 "), std::string::npos) << said;
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);  // the largest program that this process ran, in KiB
  EXPECT_LT(usage.ru_maxrss, 600 * 1024);
}

TEST_F(MadeFiles, OfAnyDensitySeenFromInsideByLightsInsideGiveSanePictures) {
  made("ball.vdb", {ball()});
  for (const char* density : {"1e-4", "1", "1e4"})
    sane_picture("ball.vdb",
                 {"--density-scale", density, "--set", "camera.eye=0,0,0", "--set", "camera.target=0,0,1"});
  folder_.write("scene.json", R"({"volume": ")" + file("ball.vdb") + R"(",
    "camera": {"eye": [0, 0, 60], "target": [0, 0, 0]},
    "lights": [{"type": "point", "position": [0, 0, 0]}, {"toward": [0, 1, 0]}, {"toward": [0, 0, 1], "irradiance": 0},
               {"type": "spot", "position": [0, 0, 3], "toward": [0, 0, 1], "radius": 0, "intensity": 5}]})");
  fs::copy_file(folder_.path() / "scene.json", made_.path() / "scene.json");
  sane_picture("scene.json");
}

}  // namespace
}  // namespace plinian
