// What the panels do for a hand that is quick, changes its mind or has little room.
#include <gtest/gtest.h>

#include "tests/host/window/steps.h"

namespace plinian {
namespace {

class PanelsSitting : public testing::Test {
 protected:
  static constexpr ivec2 size{1280, 720};
  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  }
};

TEST_F(PanelsSitting, TheStripIsOneRowWhereItCanBeAndNothingOfItIsLostWhereItCannot) {
  Sitting sitting({"sphere"}, size);
  wait_for_rest(sitting, 0);
  const ivec4 tools = sitting.item("tool select"), compare = sitting.item("compare"),
              whole = sitting.item("timeline");
  EXPECT_EQ(tools.y, compare.y);
  EXPECT_LE(compare.x + compare.z, whole.x + whole.z);
  sitting.keep("panels-1280.png");
  const std::size_t before = sitting.now();
  sitting.resize({1024, 640});
  sitting.wait_for(" still", sitting.wait_for("item \"compare\"", before));
  const ivec4 beneath = sitting.item("compare"), across = sitting.item("timeline");
  EXPECT_GT(beneath.y, sitting.item("tool select").y);
  EXPECT_LE(beneath.x + beneath.z, across.x + across.z);
  EXPECT_LE(beneath.y + beneath.w, sitting.item("picture").y) << "in the second row";
  sitting.keep("panels-1024.png");
}

TEST_F(PanelsSitting, EscapeLeavesTheCommandLineAsItIsAndDeletingAPlaceTakesWhatServedIt) {
  Sitting sitting({"sphere"}, size);
  wait_for_rest(sitting, 0);
  sitting.click(sitting.middle("command line"));
  sitting.wait_for_keys("keys to a field");
  sitting.type("nonsense");
  sitting.stroke("Escape");
  sitting.wait_for_keys("keys to the window");
  sitting.click(sitting.middle("command line"));
  sitting.wait_for_keys("keys to a field");
  sitting.stroke("Control_L+a");
  sitting.stroke("BackSpace");
  sitting.stroke("Escape");
  sitting.wait_for_keys("keys to the window");
  command(sitting, "select medium_place");
  sitting.keep("panels-escape.png");
  leave_fields(sitting, {600, 714});

  std::size_t before = sitting.now();
  sitting.stroke("Delete");
  sitting.wait_for("says delete: medium too", sitting.wait_for("ran delete -inputs", before));
  sitting.keep("panels-deleted.png");
  before = sitting.now();
  sitting.stroke("Control_L+z");
  wait_for_rest(sitting, sitting.wait_for("ran undo", before));
  command(sitting, "save back.plinian");
  const std::string scene = text_of(sitting.folder() / "back.plinian");
  for (const char* node : {"medium", "medium_place", "medium_shape"})
    EXPECT_NE(scene.find(std::string(" ") + node + (node == std::string("medium_shape") ? " " : "\n")),
              std::string::npos)
        << node;
}

TEST_F(PanelsSitting, ASnapshotThatIsAskedForTooEarlyIsTakenWhenThereIsAPicture) {
  Sitting sitting({"ash"}, size);
  wait_for_rest(sitting, 0);
  const ivec2 middle = sitting.middle("picture");
  sitting.move(middle);
  sitting.stroke("2");  // whose passes take their time
  const std::size_t before = sitting.wait_for("ran quality high");
  sitting.key_down("Alt_L");
  sitting.press();
  for (int i = 1; i <= 10; ++i) sitting.move(middle + ivec2(4 * i, 0));
  sitting.wait_for(" quick ", before);  // a quick picture is what there is now
  sitting.release();
  sitting.key_up("Alt_L");
  sitting.stroke("p");
  sitting.wait_for("says the snapshot is taken when", before);
  sitting.wait_for("took snapshot 1", before);
  sitting.item("snapshot 1");
  sitting.keep("panels-snapshot.png");
}

}  // namespace
}  // namespace plinian
