// Files that are dropped on the window by a file manager.
#include <gtest/gtest.h>

#include "tests/host/cli/program.h"
#include "tests/host/window/steps.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;

class DropSitting : public testing::Test {
 protected:
  static constexpr ivec2 size{1100, 700};
  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
    folder_.write("none/empty.pln", "newScene -force\nsave empty.plinian\n");
    run({"make", "ash", "-o", "a puff, 50%.vdb", "--resolution", "24"});
    run({"render", "sphere", "-o", "seen.exr", "--size", "64x64", "--passes", "1", "--renderer", "cpu",
         "--save-scene", "shot.plinian"});
    run({"run", "none/empty.pln"});
  }
  void run(const std::vector<std::string>& arguments) {
    const Ended ended = plinian_program(arguments, {.folder = folder_.path().string()});
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  // Pixels of the picture that are brighter than its background could be.
  static int bright_pixels(Sitting& sitting) {
    const Pixels seen = sitting.pixels(sitting.item("picture"));
    int count = 0;
    for (std::size_t i = 0; i < seen.rgb.size(); i += 3) count += seen.rgb[i] > 160;
    return count;
  }
  TemporaryFolder folder_;
};

TEST_F(DropSitting, VolumesAndPicturesAreTakenAlsoSeveralAtOnceAndWhatNothingKnowsIsSurvived) {
  Sitting sitting({folder_ / "empty.plinian"}, size);
  sitting.wait_for(" still");
  std::size_t before = sitting.now();
  sitting.drop({folder_.path() / "a puff, 50%.vdb"}, sitting.middle("picture"));
  wait_for_rest(sitting, before);
  sitting.keep("drop-volume.png");
  const ivec4 picture = sitting.item("picture");
  EXPECT_GT(bright_pixels(sitting), picture.z * picture.w / 100) << "lit, and large in the picture";

  // A picture that is dropped is the reference.
  before = sitting.now();
  sitting.drop({folder_.path() / "seen.exr"}, sitting.middle("picture"));
  sitting.wait_for("loadReference", before);
  sitting.wait_for(" still", before);
  sitting.keep("drop-reference.png");

  // Two at once: both are taken, the volume is added to the scene.
  before = sitting.now();
  sitting.drop({folder_.path() / "a puff, 50%.vdb", folder_.path() / "seen.exr"}, sitting.middle("picture"));
  sitting.wait_for("import ", before);
  sitting.wait_for("loadReference", before);

  // What nothing knows is told, and changes nothing.
  folder_.write("notes.txt", "no volume\n");
  before = sitting.now();
  sitting.drop({folder_.path() / "notes.txt"}, sitting.middle("picture"));
  sitting.wait_for("notes.txt", before);
  sitting.wait_for(" still", before);
  sitting.keep("drop-unknown.png");
  EXPECT_TRUE(sitting.is_running());
}

TEST_F(DropSitting, ASceneIsOpened) {
  Sitting sitting({folder_ / "empty.plinian"}, size);
  sitting.wait_for(" still");
  const std::size_t before = sitting.now();
  sitting.drop({folder_.path() / "shot.plinian"}, sitting.middle("picture"));
  sitting.wait_for("open -force", before);
  wait_for_rest(sitting, before);
  sitting.keep("drop-scene.png");
  EXPECT_GT(bright_pixels(sitting), 100);
}

}  // namespace
}  // namespace plinian
