// What hands do while a scene is still being read.
#include <gtest/gtest.h>

#include "tests/host/cli/program.h"
#include "tests/host/window/steps.h"

namespace plinian {
namespace {

TEST(MeanwhileSitting, ALineThatIsTypedWaitsForTheSceneAndLettersOverPanelsDoNothing) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  TemporaryFolder folder;
  const std::string file = (folder.path() / "ash.vdb").string();
  const Ended made = plinian_program({"make", "ash", "-o", file, "--resolution", "400"}, {});
  ASSERT_EQ(made.code, 0) << made.err;
  Sitting sitting({file}, {1100, 640});

  // Letters over a panel that is grey are no hotkeys; nor are those of the command line, which takes them.
  const ivec2 grey(1000, 300);
  sitting.move(grey);
  sitting.wait_for_mouse(grey, 0);
  sitting.type("n");
  sitting.click(sitting.middle("command line"));
  sitting.wait_for_keys("keys to a field");
  sitting.type("ls");
  sitting.stroke("Return");
  const std::size_t waits = sitting.wait_for("waits ls");
  sitting.type("rename ash nhood");
  sitting.keep("meanwhile-typed.png");
  sitting.stroke("Return");
  const std::size_t listed = sitting.wait_for("ran ls"), ran = sitting.wait_for("ran rename ash nhood");
  EXPECT_GT(listed, waits);
  EXPECT_GT(ran, listed) << "in the order in which they were typed";
  wait_for_rest(sitting, ran);
  sitting.keep("meanwhile-read.png");
  sitting.item("node nhood");
  for (const std::string& line : sitting.lines())
    EXPECT_EQ(line.find("item \"nodes canvas\""), std::string::npos) << "N opened the node editor";
}

}  // namespace
}  // namespace plinian
