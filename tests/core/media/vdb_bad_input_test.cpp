#include <gtest/gtest.h>
#include <openvdb/points/PointConversion.h>
#include <sys/wait.h>

#include <cstdlib>

#include "core/media/vdb_process.h"
#include "core/media/vdb_reader.h"
#include "tests/core/media/vdb_test_files.h"

namespace plinian {
namespace {

std::string read_error(const std::string& path, const VdbOptions& options = {}) {
  return error_of([&] { read_vdb(path, options); });
}

TEST(VdbBadInput, FilesThatAreNoneAreNamed) {
  Folder folder;
  expect_line(read_error(folder / "none.vdb"), folder / "none.vdb", {"no such file"});
  std::filesystem::create_directory(folder / "dir.vdb");
  expect_line(read_error(folder / "dir.vdb"), folder / "dir.vdb", {"folder"});
  write_bytes(folder / "empty.vdb", "");
  expect_line(read_error(folder / "empty.vdb"), folder / "empty.vdb", {"empty"});
  write_bytes(folder / "text.vdb", "This is not the file that you are looking for.");
  expect_line(read_error(folder / "text.vdb"), folder / "text.vdb", {"not a .vdb file"});
  expect_line(error_of([&] { inspect_vdb(folder / "text.vdb"); }), folder / "text.vdb", {"not a .vdb file"});
  write_bytes(folder / "short.vdb", " BDV");
  expect_line(read_error(folder / "short.vdb"), folder / "short.vdb", {"not a .vdb file"});
  ASSERT_EQ(::mkfifo((folder / "pipe.vdb").c_str(), 0600), 0);
  expect_line(read_error(folder / "pipe.vdb"), folder / "pipe.vdb", {"not a regular file"});
}

TEST(VdbBadInput, ATruncatedFileIsAnErrorWhereverItIsCut) {
  Folder folder;
  auto grid = make_grid("density");
  for (int i = 0; i < 400; ++i) grid->tree().setValue(openvdb::Coord(i * 3, i, -i), float(i));
  save(folder / "whole.vdb", {grid});
  const std::string bytes = read_bytes(folder / "whole.vdb");
  for (int cut = 0; cut < 24; ++cut) {
    const std::size_t length = 8 + (bytes.size() - 9) * std::size_t(cut) / 23;
    write_bytes(folder / "cut.vdb", bytes.substr(0, length));
    expect_line(read_error(folder / "cut.vdb"), folder / "cut.vdb", {"damaged"});
  }
}

TEST(VdbBadInput, ANewerFormatIsAnError) {
  Folder folder;
  save(folder / "a.vdb", {dot()});
  std::string bytes = read_bytes(folder / "a.vdb");
  bytes[8] = bytes[9] = 0x7f;
  write_bytes(folder / "a.vdb", bytes);
  expect_line(read_error(folder / "a.vdb"), folder / "a.vdb", {"format 32639", "newer"});
}

TEST(VdbBadInput, ChoosingAGridNamesWhatThereIs) {
  Folder folder;
  save(folder / "none.vdb", {});
  expect_line(read_error(folder / "none.vdb"), folder / "none.vdb", {"no grids"});
  EXPECT_TRUE(inspect_vdb(folder / "none.vdb").grids.empty());

  save(folder / "two.vdb", {dot("smoke"), dot("dust"), make_grid<openvdb::Vec3SGrid>("v")});
  const std::string all = "smoke (float), dust (float), v (vec3s)";
  VdbOptions options;
  options.grid = "ash";
  expect_line(read_error(folder / "two.vdb", options), folder / "two.vdb", {"no grid \"ash\"", all});
  expect_line(read_error(folder / "two.vdb"), folder / "two.vdb", {"--grid", all});

  save(folder / "three.vdb", {dot(), dot(), dot()});
  const std::string indices = "density[0], density[1], density[2]";
  expect_line(read_error(folder / "three.vdb"), folder / "three.vdb", {indices, "density[*]"});
  options.grid = "density";
  expect_line(read_error(folder / "three.vdb", options), folder / "three.vdb", {indices});
  options.grid = "density[3]";
  expect_line(read_error(folder / "three.vdb", options), folder / "three.vdb", {"density[3]", indices});
  options.grid = "density[-1]";
  expect_line(read_error(folder / "three.vdb", options), folder / "three.vdb", {"density[-1]", indices});
}

TEST(VdbBadInput, GridsThatAreNoDensityAreRefusedWithTheReason) {
  Folder folder;
  VdbOptions options;
  save(folder / "v.vdb", {make_grid<openvdb::Vec3SGrid>("velocity")});
  expect_line(read_error(folder / "v.vdb"), folder / "v.vdb", {"\"velocity\"", "vec3s"});
  // OpenVDB writes grids of strings no longer, older files have them.
  save(folder / "s.vdb", {make_grid<openvdb::DoubleGrid>("names"), dot("smoke")});
  std::string bytes = read_bytes(folder / "s.vdb");
  bytes.replace(bytes.find("Tree_double"), 11, "Tree_string");
  write_bytes(folder / "s.vdb", bytes);
  options.grid = "names";
  expect_line(read_error(folder / "s.vdb", options), folder / "s.vdb", {"\"names\"", "string"});
  EXPECT_EQ(read_vdb(folder / "s.vdb").facts.density.at(0).name, "smoke");
  const std::vector<openvdb::Vec3s> places = {{0, 0, 0}, {1, 2, 3}};
  const auto transform = openvdb::math::Transform::createLinearTransform(0.5);
  auto points =
      openvdb::points::createPointDataGrid<openvdb::points::NullCodec, openvdb::points::PointDataGrid>(
          places, *transform);
  points->setName("points");
  save(folder / "p.vdb", {points});
  expect_line(read_error(folder / "p.vdb"), folder / "p.vdb", {"\"points\"", "points, which are no density"});
  EXPECT_EQ(inspect_vdb(folder / "p.vdb").grids.at(0).active_voxels,
            std::int64_t(points->activeVoxelCount()));

  auto ball = dot("ball");
  ball->setGridClass(openvdb::GRID_LEVEL_SET);
  save(folder / "l.vdb", {ball});
  expect_line(read_error(folder / "l.vdb"), folder / "l.vdb", {"\"ball\"", "level set", "--level-set fog"});
}

TEST(VdbBadInput, TransformsThatCannotPlaceVoxelsAreRefused) {
  Folder folder;
  auto frustum = dot();
  frustum->setTransform(
      openvdb::math::Transform::createFrustumTransform(openvdb::BBoxd({0, 0, 0}, {10, 10, 10}), 0.5, 1.0));
  save(folder / "f.vdb", {frustum});
  expect_line(read_error(folder / "f.vdb"), folder / "f.vdb",
              {"\"density\"", "frustum", "--frustum resample"});

  // OpenVDB makes no singular transform, so one is patched into the file: all of a row of the matrix, or a
  // scale.
  constexpr double mark = 0.123456789;
  for (const double value : {0.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    auto scaled = dot();
    scaled->setTransform(openvdb::math::Transform::createLinearTransform(mark));
    save(folder / "s.vdb", {scaled});
    ASSERT_GT(patch_double(folder / "s.vdb", mark, value), 0);
    expect_line(read_error(folder / "s.vdb"), folder / "s.vdb", {"\"density\"", "transform"});
    EXPECT_NE(inspect_vdb(folder / "s.vdb").grids.at(0).refusal, "");
    auto sheared = dot();
    sheared->setTransform(openvdb::math::Transform::createLinearTransform(
        matrix({mark, mark, 0.0, 0.0, 0.0, mark, 0.5, 0.0, 0.0, 0.0, mark, 0.0, 1.0, 2.0, 3.0, 1.0})));
    save(folder / "a.vdb", {sheared});
    ASSERT_GT(patch_double(folder / "a.vdb", mark, value), 0);
    expect_line(read_error(folder / "a.vdb"), folder / "a.vdb", {"\"density\"", "transform"});
  }
}

TEST(VdbBadInput, AFewBytesThatStandForATerabyteAreRefusedWithTheOption) {
  Folder folder;
  auto grid = make_grid("density");
  grid->tree().addTile(3, {0, 0, 0}, 1.0f, true);  // 4096^3 voxels
  save(folder / "tile.vdb", {grid});
  ASSERT_LT(std::filesystem::file_size(folder / "tile.vdb"), 4096u);
  expect_line(read_error(folder / "tile.vdb"), folder / "tile.vdb", {"\"density\"", "--vdb-memory-limit"});
  // What the option allows is taken: a tile of 128^3 voxels is 8 MiB.
  auto small = make_grid("density");
  small->tree().addTile(2, {0, 0, 0}, 1.0f, true);
  save(folder / "small.vdb", {small});
  VdbOptions options;
  options.memory_limit_bytes = 8 << 20;
  expect_line(read_error(folder / "small.vdb", options), folder / "small.vdb",
              {"8 MiB", "--vdb-memory-limit"});
  options.memory_limit_bytes = 32 << 20;
  EXPECT_EQ(read_vdb(folder / "small.vdb", options).volume->leaf_count, 4096);
}

TEST(VdbBadInput, AFileThatEatsMemoryEndsAtTheLimitWithTheOption) {
  Folder folder;
  openvdb::MetaMap metadata;
  metadata.insertMeta("note", openvdb::StringMetadata("abcdefghijklmnopqrstuvwxyz"));
  save(folder / "a.vdb", {dot()}, metadata);
  std::string bytes = read_bytes(folder / "a.vdb");
  const std::size_t at = bytes.find("abcdefghij");
  ASSERT_NE(at, std::string::npos);
  bytes[at - 1] = '\x70';  // the highest byte of the string's length: 1.8 GB
  write_bytes(folder / "a.vdb", bytes);
  expect_line(read_error(folder / "a.vdb"), folder / "a.vdb", {"MiB", "--vdb-memory-limit"});
}

/// Lets a shell script stand in for the worker.
class FakeWorker {
 public:
  FakeWorker(const Folder& folder, const std::string& script) {
    const std::string path = folder / "worker";
    write_bytes(path, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    ::setenv("PLINIAN_VDB_WORKER", path.c_str(), 1);
  }
  ~FakeWorker() { ::unsetenv("PLINIAN_VDB_WORKER"); }
};

std::size_t open_descriptors() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

TEST(VdbWorker, HoweverItEndsThereIsOneLineAndNothingIsLeftBehind) {
  Folder folder;
  const std::string path = folder / "a.vdb";
  save(path, {dot()});
  VdbOptions options;
  options.time_limit_s = 1.0;
  const std::size_t descriptors = open_descriptors();
  struct Case {
    std::string script;
    std::vector<std::string> words;
  };
  const std::vector<Case> cases = {
      {"kill -SEGV $$", {"damaged", "crashed", "signal 11"}},
      {"cat >/dev/null; kill -ABRT $$", {"damaged", "crashed", "signal 6"}},
      {"exec sleep 100", {"stopped after 1 s", "--vdb-time-limit"}},
      {"while :; do :; done", {"stopped after 1 s", "--vdb-time-limit"}},
      {"while :; do echo noise >&2; done", {"stopped after 1 s"}},
      {"exec sleep 100 >&- ", {"stopped after 1 s", "--vdb-time-limit"}},
      {"exit 3", {"--vdb-memory-limit"}},
      {"echo 'libsomething.so: cannot open' >&2; exit 127", {"status 127", "libsomething.so: cannot open"}},
      {"exit 0", {"nonsense"}},
      {"exec cat /dev/urandom", {"nonsense"}},
      {"exec cat /dev/zero", {"nonsense"}},
      {"printf '\\005\\0\\0\\0\\002\\0\\0\\0{}'", {"nonsense"}},
      {"printf '\\005\\0\\0\\0\\002\\0\\0\\0[1'", {"nonsense"}},
      {"printf '\\006\\0\\0\\0\\003\\0\\0\\0no\\033'", {"no "}},
      {"printf '\\002\\0\\0\\0\\004\\0\\0\\0abcd'", {"cut short"}},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.script);
    const FakeWorker fake(folder, one.script);
    const auto begin = std::chrono::steady_clock::now();
    expect_line(read_error(path, options), path, one.words);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(8));
    EXPECT_EQ(open_descriptors(), descriptors);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);  // no child, running or dead
    EXPECT_EQ(errno, ECHILD);
  }
  EXPECT_EQ(folder.files(), 2u);
}

TEST(VdbWorker, NoiseOfLibrariesReachesNobody) {
  Folder folder;
  save(folder / "a.vdb", {dot()});
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  read_vdb(folder / "a.vdb");
  write_bytes(folder / "b.vdb", read_bytes(folder / "a.vdb").substr(0, 200));
  EXPECT_THROW(read_vdb(folder / "b.vdb"), VdbError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(VdbWorker, AMissingWorkerIsNamedWithTheVariableThatSetsIt) {
  Folder folder;
  save(folder / "a.vdb", {dot()});
  ::setenv("PLINIAN_VDB_WORKER", "/nowhere/worker", 1);
  expect_line(read_error(folder / "a.vdb"), folder / "a.vdb", {"/nowhere/worker", "No such file"});
  ::unsetenv("PLINIAN_VDB_WORKER");
  EXPECT_TRUE(vdb::worker_path().ends_with("libexec/plinian/plinian-vdb-worker"));
}

TEST(VdbWorker, BlocksOfAHostileWorkerAreDistrusted) {
  // Nine bytes too few, a block twice, a block far out, unknown flags: each ends the reading.
  const auto message = [](std::initializer_list<ivec3> blocks) {
    vdb::BlockWriter writer;
    const std::vector<float> values(vdb::block_voxels, 1.0f);
    for (const ivec3 block : blocks) writer.add(block, values.data(), nullptr);
    const auto bytes = writer.message();
    return std::vector<std::byte>(bytes.begin() + sizeof(vdb::MessageHeader), bytes.end());
  };
  const auto read = [](const std::vector<std::byte>& payload) {
    int count = 0;
    vdb::BlockReader().read(payload,
                            [&](ivec3, const float* density, const float*) { count += int(density[511]); });
    return count;
  };
  EXPECT_EQ(read(message({{0, 0, 0}, {1, 0, 0}, {-5, 1, 0}, {-9, -9, 1}})), 4);
  EXPECT_THROW(read(message({{0, 0, 0}, {0, 0, 0}})), std::runtime_error);
  EXPECT_THROW(read(message({{0, 1, 0}, {5, 0, 0}})), std::runtime_error);
  EXPECT_THROW(read(message({{1 << 26, 0, 0}})), std::runtime_error);
  EXPECT_THROW(read(message({{0, std::numeric_limits<int>::min(), 0}})), std::runtime_error);
  std::vector<std::byte> payload = message({{0, 0, 0}});
  payload.pop_back();
  EXPECT_THROW(read(payload), std::runtime_error);
  payload = message({{0, 0, 0}});
  payload[12] = std::byte{0xff};
  EXPECT_THROW(read(payload), std::runtime_error);
}

}  // namespace
}  // namespace plinian
