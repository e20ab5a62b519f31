// The program on files that other programs wrote: what cannot be density says so, and what to do about it.
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;

class RealFiles : public Program {
 protected:
  void SetUp() override {
    if (!fs::exists(data_)) GTEST_SKIP() << data_ << " is not there";
  }
  std::string file(const std::string& name) const { return (data_ / name).string(); }
  // What rendering says; checks that it is one line, that it fails and that nothing is written.
  std::string error_for(const std::string& name, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"render", file(name), "-o", "out.png", "--quiet"});
    const Ended ended = run(more);
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.error_lines(), 1) << ended.err;
    EXPECT_TRUE(fs::is_empty(folder_.path()));
    EXPECT_NE(ended.err.find(name), std::string::npos) << ended.err;
    return ended.err;
  }

  const fs::path data_ = fs::path(PLINIAN_SOURCE_DIR) / ".." / "shared" / "data";
};

#define EXPECT_SAYS(text, part)                                                     \
  do {                                                                              \
    const std::string text_said = (text);                                           \
    EXPECT_NE(text_said.find(part), std::string::npos) << "it says: " << text_said; \
  } while (false)

TEST_F(RealFiles, AGridThatIsNotThereListsThoseThatAre) {
  const std::string said = error_for("densityAndHeat.vdb", {"--grid", "smoke"});
  EXPECT_SAYS(said, "density");
  EXPECT_SAYS(said, "heat");
}

TEST_F(RealFiles, AnAmbiguousNameListsTheIndicesAndCanBeSettled) {
  EXPECT_SAYS(error_for("grids.vdb", {"--grid", "density"}), "density[2]");
  for (const char* grid : {"density[1]", "density[*]"})
    EXPECT_EQ(run({"render", file("grids.vdb"), "-o", "a.png", "--grid", grid, "--renderer", "reference",
                   "--size", "16x16", "--tolerance", "0.1"})
                  .code,
              0);
}

TEST_F(RealFiles, PointsVectorsAndLevelSetsAreNoDensity) {
  EXPECT_SAYS(error_for("points.vdb"), "point");
  EXPECT_SAYS(error_for("sphereCd.vdb"), "vec3");
  EXPECT_SAYS(error_for("sphere.vdb"), "--level-set fog");
}

TEST_F(RealFiles, ALevelSetIsConvertedWhenAskedFor) {
  EXPECT_EQ(run({"render", file("sphere.vdb"), "-o", "a.png", "--level-set", "fog", "--renderer", "reference",
                 "--size", "16x16", "--tolerance", "0.1"})
                .code,
            0);
}

TEST_F(RealFiles, ATruncatedFileIsOneLineAndALimitNamesItsOption) {
  std::ifstream whole(file("smoke.vdb"), std::ios::binary);
  std::string bytes(100000, '\0');
  whole.read(bytes.data(), std::streamsize(bytes.size()));
  TemporaryFolder elsewhere;
  const std::string half = elsewhere.write("half.vdb", bytes);
  const Ended ended = run({"render", half, "-o", "out.png", "--quiet"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.error_lines(), 1) << ended.err;
  EXPECT_TRUE(fs::is_empty(folder_.path()));
  EXPECT_SAYS(error_for("smoke.vdb", {"--vdb-memory-limit", "1M"}), "--vdb-memory-limit");
  EXPECT_SAYS(error_for("smoke.vdb", {"--vdb-time-limit", "0.001"}), "--vdb-time-limit");
}

TEST_F(RealFiles, ADamagedGridIsAnErrorBesideTheListOfThoseThatAreWhole) {
  std::ifstream whole(file("densityAndHeat.vdb"), std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(whole)), {});
  bytes.replace(20000, 400, 400, '\xff');
  const std::string damaged = folder_.write("damaged.vdb", bytes);
  const Ended ended = run({"info", damaged});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.error_lines(), 1) << ended.err;
  EXPECT_SAYS(ended.err, "damaged.vdb: the file is damaged: grid \"density\"");
  EXPECT_SAYS(ended.out, "heat");
}

TEST_F(RealFiles, AnEmptyGridIsASanePictureAndAWarning) {
  const Ended ended =
      run({"render", file("smoke_000001.vdb"), "-o", "a.exr", "--renderer", "reference", "--size", "16x16"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.err.find("warning: "), std::string::npos) << ended.err;
  for (const Channel& channel : picture("a.exr").channels) {
    if (channel.name == "Z") continue;  // infinite where there is nothing
    for (const float value : channel.values) ASSERT_TRUE(std::isfinite(value)) << channel.name;
  }
}

TEST_F(RealFiles, ANeutralSceneOfThePeersIsRenderedAsItStands) {
  const fs::path scene = data_ / ".." / "peers" / "scenes" / "smoke-dense.json";
  const Ended ended = run({"render", scene.string(), "-o", "a.exr", "--renderer", "cpu", "--samples", "1"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Image image = picture("a.exr");
  EXPECT_EQ(image.width, 256);
  EXPECT_EQ(image.height, 256);
  EXPECT_NE(image.find("light0.R"), nullptr);
  EXPECT_EQ(mean_of(image, "background.R"), 0.0);
  EXPECT_GT(mean_of(image, "light0.R"), 0.02);
}

TEST_F(RealFiles, AFileWithHeatGlows) {
  const Ended ended = run({"render", file("densityAndHeat.vdb"), "-o", "a.exr", "--renderer", "reference",
                           "--size", "16x16", "--tolerance", "0.1"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_GT(mean_of(picture("a.exr"), "emission.R"), 0.0);
  EXPECT_NE(ended.err.find("1800 K"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace plinian
