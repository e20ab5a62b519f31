// Choosing files and grids by hand.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/host/cli/program.h"
#include "tests/host/window/steps.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;

class FilesSitting : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
    fs::create_directories(shots_ / "old takes");
    for (const char* name : {"explosion", "ash"}) {
      const Ended ended = plinian_program(
          {"make", name, "-o", (shots_ / (std::string(name) + ".vdb")).string(), "--resolution", "24"}, {});
      ASSERT_EQ(ended.code, 0) << ended.err;
    }
    for (const char* frame : {"0001", "0002", "0003", "0007"})
      fs::copy_file(shots_ / "ash.vdb", shots_ / ("plume." + std::string(frame) + ".vdb"));
    folder_.write("shots/notes.txt", "no volume\n");
  }
  // Opens the dialog; the keys are its name's.
  static void open(Sitting& sitting, const char* keys = "Control_L+o") {
    const std::size_t before = sitting.now();
    sitting.stroke(keys);
    sitting.wait_for("folder ", before);
    sitting.wait_for_keys("keys to a field");
  }

  TemporaryFolder folder_;
  fs::path shots_ = folder_.path() / "shots";
};

TEST_F(FilesSitting, ABookmarkLeadsToAVolumeWhoseGridsAreChosenFromAList) {
  Sitting sitting({"sphere"}, {1280, 700});
  wait_for_rest(sitting, 0);

  // A path as a terminal gives it is gone to; the folder is remembered.
  open(sitting);
  std::size_t before = sitting.now();
  sitting.type(std::string("'").append(shots_.string()).append("'"));
  sitting.stroke("Return");
  sitting.wait_for("folder " + shots_.string() + " lists 4", before);
  sitting.click(sitting.middle("bookmark this folder"));
  sitting.item("place shots");
  sitting.stroke("Escape");
  sitting.wait_for_keys("keys to the window");
  std::ifstream kept(sitting.folder() / "config" / "plinian" / "bookmarks");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), shots_.string() + "\n");

  open(sitting);
  before = sitting.now();
  sitting.click(sitting.middle("place Home"));
  sitting.wait_for(" still", sitting.wait_for("folder ", before));
  sitting.keep("files-home.png");
  before = sitting.now();
  sitting.click(sitting.middle("place shots"));
  sitting.wait_for("folder " + shots_.string() + " lists 4", before);
  before = sitting.now();
  sitting.click(sitting.middle("file column Size"));
  sitting.wait_for("item \"file plume.####.vdb\"", before);  // elsewhere
  sitting.click(sitting.middle("file plume.####.vdb"));
  sitting.wait_for_keys("keys to a field");
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-list.png");
  sitting.type("EXPL");
  sitting.move({640, 690});
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-letters.png");
  before = sitting.now();
  sitting.stroke("Return");
  wait_for_rest(sitting, before);
  sitting.keep("files-opened.png");

  // Its grids are listed with what they are.
  sitting.click(sitting.middle("node explosion_file"));
  before = sitting.now();
  sitting.click(sitting.middle("explosion_file.grid list"));
  sitting.item("grid density");
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-grids-by-name.png");
  const ivec2 other = sitting.middle("grid temperature");
  sitting.move(other);
  sitting.wait_for_mouse(other, 0);
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-grids.png");
  sitting.click(other);
  const std::size_t chosen = sitting.wait_for("ran setAttr explosion_file.grid \"temperature\"", before);
  sitting.wait_for(" picture ", chosen);
  sitting.keep("files-grid-chosen.png");
  // A name can still be typed.
  sitting.click(sitting.middle("explosion_file.grid") - ivec2(20, 0));
  sitting.wait_for_keys("keys to a field");
  before = sitting.now();
  sitting.stroke("Control_L+a");
  sitting.type("density");
  sitting.stroke("Return");
  sitting.wait_for("ran setAttr explosion_file.grid \"density\"", before);
}

TEST_F(FilesSitting, AnAttributeThatNamesAFileIsChosenInTheBrowser) {
  std::ofstream(folder_.path() / "shot.plinian");  // a scene is none of what is looked for
  Sitting sitting({(shots_ / "ash.vdb").string()}, {1280, 700});
  std::size_t before = sitting.now();
  wait_for_rest(sitting, 0);
  sitting.click(sitting.middle("node ash_file"));
  sitting.wait_for(" still", sitting.wait_for("item \"ash_file.file browse\"", before));
  sitting.click(sitting.middle("ash_file.file browse"));
  sitting.wait_for("folder " + shots_.string() + " lists 4", before);
  sitting.wait_for_keys("keys to a field");
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-of-an-attribute.png");
  // The one that is read is chosen: the next is an arrow away.
  before = sitting.now();
  sitting.stroke("Down");
  sitting.stroke("Return");
  const std::string set = "ran setAttr ash_file.file ";
  sitting.wait_for(set + "\"" + (shots_ / "explosion.vdb").string() + "\"", before);
  wait_for_rest(sitting, before);
  sitting.wait_for_keys("keys to the window");
  sitting.keep("files-attribute-set.png");
  before = sitting.now();
  sitting.stroke("Control_L+z");
  wait_for_rest(sitting, before);
  command(sitting, "save undone.plinian");
  EXPECT_NE(text_of(sitting.folder() / "undone.plinian").find("ash.vdb\""), std::string::npos);
}

TEST_F(FilesSitting, KeysAndThePasteAloneDoItAndNothingIsWrittenOverUnasked) {
  folder_.write("shots/shot.plinian", "somebody's work\n");
  Sitting sitting({"sphere"}, {1280, 700});
  wait_for_rest(sitting, 0);

  // Down into a folder and back up by keys; a path that is pasted is shown where it is.
  open(sitting);
  std::size_t before = sitting.now();
  sitting.type(shots_.string() + "/");
  sitting.stroke("Return");
  sitting.wait_for("folder " + shots_.string() + " lists", before);
  sitting.wait_for_keys("keys to a field");
  before = sitting.now();
  sitting.stroke("Down");
  sitting.stroke("Return");
  sitting.wait_for("folder " + (shots_ / "old takes").string() + " lists 0", before);
  sitting.wait_for_keys("keys to a field");
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-nothing.png");
  before = sitting.now();
  sitting.stroke("BackSpace");
  sitting.wait_for("folder " + shots_.string() + " lists", before);
  sitting.stroke("BackSpace");
  sitting.wait_for("folder " + folder_.path().string() + " lists", before);
  before = sitting.now();
  sitting.type((shots_ / "ash.vdb").string());
  sitting.stroke("Control_L+a");
  sitting.stroke("Control_L+x");
  sitting.stroke("Control_L+v");
  sitting.wait_for(" still", sitting.wait_for("folder " + shots_.string() + " lists", before));
  sitting.keep("files-pasted.png");
  before = sitting.now();
  sitting.stroke("Return");
  wait_for_rest(sitting, before);

  // The name of a file that is there.
  sitting.wait_for_keys("keys to the window");
  open(sitting, "Control_L+Shift_L+s");
  sitting.stroke("Control_L+a");
  sitting.type((shots_ / "shot").string());
  sitting.stroke("Return");
  sitting.item("file overwrite");
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-overwrite.png");
  sitting.stroke("Escape");
  sitting.wait_for_keys("keys to a field");
  std::ifstream file(shots_ / "shot.plinian");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "somebody's work\n");
  before = sitting.now();
  sitting.stroke("Return");
  sitting.stroke("Return");
  sitting.wait_for("ran save", before);
  EXPECT_GT(fs::file_size(shots_ / "shot.plinian"), 100u);
}

TEST_F(FilesSitting, HasRoomWhereTheDesktopIsTwiceAsLarge) {
  Sitting sitting({"sphere"}, {1440, 1000}, 2);
  wait_for_rest(sitting, 0);
  open(sitting);
  const std::size_t before = sitting.now();
  sitting.type(shots_.string());
  sitting.stroke("Return");
  sitting.wait_for("folder " + shots_.string() + " lists 4", before);
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-twice.png");
  for (const char* name : {"place Home", "file name", "file take", "file cancel", "file plume.####.vdb"}) {
    const ivec4 place = sitting.item(name);
    EXPECT_GE(place.x, 0) << name;
    EXPECT_GE(place.y, 0) << name;
    EXPECT_LE(place.x + place.z, 1440) << name;
    EXPECT_LE(place.y + place.w, 1000) << name;
    EXPECT_GE(place.w, 36) << name << " is twice as high";
  }

  // A bookmark is forgotten by its cross.
  const auto kept = [&] {
    std::ifstream file(sitting.folder() / "config" / "plinian" / "bookmarks");
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  sitting.click(sitting.middle("bookmark this folder"));
  const ivec2 cross = sitting.middle("forget shots");
  EXPECT_EQ(kept(), shots_.string() + "\n");
  sitting.move(cross);
  sitting.wait_for_mouse(cross, 0);
  sitting.wait_for(" still", sitting.now());
  sitting.keep("files-forget.png");
  sitting.click(cross);
  sitting.move({5, 5});
  sitting.wait_for(" still", sitting.now());
  EXPECT_EQ(kept(), "");
}

}  // namespace
}  // namespace plinian
