// What is asked for is done between two drawings, and a long command can be called off.
#include "host/window/commands/command_queue.h"

#include <gtest/gtest.h>

#include "host/graph/files/scene_writer.h"
#include "host/scene/workspace.h"

namespace plinian::window {
namespace {

class Commands : public testing::Test {
 protected:
  std::string scene() { return graph::write_scene(workspace.session().graph()); }
  const ConsoleLine& last_line() { return console.lines().back(); }

  scene::Workspace workspace;
  ConsoleLog console;
  Trace trace{""};
  CommandQueue commands{workspace.session(), console, trace};
};

TEST_F(Commands, OneThatIsCalledOffLeavesNothingAndTheNextOneRuns) {
  const std::string before = scene();
  int drawn = 0;
  std::string told;
  commands.draw_meanwhile = [&] {
    ++drawn;
    if (!commands.job.what.empty()) {
      told = commands.job.what;
      commands.job.cancelled = true;
    }
  };
  EXPECT_FALSE(commands.run_now("import ash"));
  EXPECT_EQ(told, "import ash") << "what takes its time says what it is";
  EXPECT_EQ(scene(), before);
  EXPECT_EQ(last_line().text, "import ash: cancelled");
  EXPECT_EQ(last_line().kind, LineKind::note);
  EXPECT_TRUE(commands.job.what.empty());

  commands.draw_meanwhile = nullptr;
  EXPECT_TRUE(commands.run_now("import sphere")) << last_line().text;
  EXPECT_NE(scene(), before);
}

TEST_F(Commands, WhatOneHasToSayStandsBehindItAndWithTheValueThatHolds) {
  commands.run_now("createNode camera -name cam");
  commands.run_now("setAttr cam.focal_length -5", "", true);
  const auto& lines = console.lines();
  ASSERT_GE(lines.size(), 2u);
  EXPECT_EQ(lines[lines.size() - 2].text, "setAttr cam.focal_length 0.1");
  EXPECT_EQ(last_line().kind, LineKind::warning);
  EXPECT_EQ(last_line().text, "cam.focal_length is out of its range (a number >= 0.1) and was set to 0.1");
}

TEST_F(Commands, CallingOffWhenNothingRunsMeansNothingToWhatComes) {
  commands.job.cancelled = true;  // as Escape does
  EXPECT_TRUE(commands.run_now("import -setup sphere")) << last_line().text;
}

TEST_F(Commands, OneThatIsPartOfAJobIsCalledOffWithIt) {
  commands.job = {"reading ash"};
  commands.job.cancelled = true;
  EXPECT_FALSE(commands.run_now("import ash"));
  EXPECT_EQ(commands.job.what, "reading ash") << "the job is its owner's to end";
}

}  // namespace
}  // namespace plinian::window
