// The node editor by hand: connects, takes back, takes off.
#include <gtest/gtest.h>

#include "tests/host/window/steps.h"

namespace plinian {
namespace {

class NodesSitting : public testing::Test {
 protected:
  static constexpr ivec2 size{1280, 800};

  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
    sitting_ = std::make_unique<Sitting>(std::vector<std::string>{"sphere"}, size);
    sitting_->wait_for(" still", sitting_->wait_for(" rest "));
  }
  void type(const std::string& line) {
    sitting_->click(sitting_->middle("command line"));
    sitting_->wait_for_keys("keys to a field");
    const std::size_t before = sitting_->now();
    sitting_->type(line);
    sitting_->stroke("Return");
    sitting_->wait_for("ran " + line, before);
  }
  /// Does it, and waits until the command ran.
  void expect_command(const std::string& command, const std::function<void()>& does) {
    const std::size_t before = sitting_->now();
    does();
    sitting_->wait_for("ran " + command, before);
  }
  std::string saved(const std::string& name) {
    expect_command("save " + name, [&] { type("save " + name); });
    return text_of(sitting_->folder() / name);
  }
  void keep(const std::string& name) {
    sitting_->wait_for(" still", sitting_->now() - 1);
    sitting_->keep(name);
  }

  std::unique_ptr<Sitting> sitting_;
};

TEST_F(NodesSitting, AWireConnectsIsTakenBackAndIsTakenOff) {
  type("createNode medium -name other");
  const std::string original = saved("original.plinian");
  EXPECT_NE(original.find(".medium <- medium.out"), std::string::npos);
  sitting_->click(sitting_->middle("tab nodes"));
  sitting_->wait_for(" still", sitting_->wait_for("item \"out other.out\""));
  keep("nodes.png");

  // A plug that cannot take the wire says why.
  std::size_t before = sitting_->now();
  sitting_->move(sitting_->middle("out other.out"));
  sitting_->wait_for_mouse(sitting_->middle("out other.out"), 0);
  sitting_->press();
  sitting_->wait_for_mouse(sitting_->middle("out other.out"), 1);
  sitting_->move(sitting_->middle("in medium_shape.volume"));
  sitting_->wait_for("refused cannot connect other.out to medium_shape.volume", before);
  keep("nodes-refused.png");
  expect_command("connectAttr other.out medium_shape.medium -force", [&] {
    const ivec2 end = sitting_->middle("in medium_shape.medium");
    sitting_->move(end);
    sitting_->wait_for_mouse(end, 1);
    sitting_->release();
    sitting_->wait_for_mouse(end, 0);
  });
  keep("nodes-connected.png");
  expect_command("undo", [&] { sitting_->stroke("Control_L+z"); });
  expect_command("redo", [&] { sitting_->stroke("Control_L+Shift_L+z"); });

  // Selected in step with the outliner, by a click on either.
  expect_command("select key", [&] { sitting_->click(sitting_->middle("box key")); });
  expect_command("select medium_shape", [&] { sitting_->click(sitting_->middle("node medium_shape")); });
  keep("nodes-selected.png");

  // Dragged off, the wire breaks; the pane of the console is where it was.
  const ivec4 canvas = sitting_->item("nodes canvas");
  expect_command("disconnectAttr medium_shape.medium", [&] {
    sitting_->drag(sitting_->middle("in medium_shape.medium"),
                   ivec2(canvas.x + canvas.z - 6, canvas.y + canvas.w - 6));
  });
  keep("nodes-disconnected.png");
  sitting_->click(sitting_->middle("tab console"));
  const std::string off = saved("off.plinian");
  EXPECT_EQ(off.find(".medium <-"), std::string::npos);
  for (int i = 0; i < 4; ++i) {  // the wire off, two selections, the wire on
    sitting_->move({5, 5});
    sitting_->click({canvas.x + canvas.z / 2, 3});  // out of the command line
    sitting_->wait_for_keys("keys to the window");
    expect_command("undo", [&] { sitting_->stroke("Control_L+z"); });
  }
  EXPECT_EQ(saved("again.plinian"), original);
}

// What is compared stays compared.
TEST_F(NodesSitting, TakeThePlaceOfTheConsoleAndLeaveThePictureAsItIs) {
  wait_for_rest(*sitting_, 0);
  const ivec4 picture = sitting_->item("picture");
  const std::size_t before = sitting_->now();
  sitting_->move({5, 5});
  sitting_->stroke("n");
  sitting_->wait_for(" still", sitting_->wait_for("item \"nodes canvas\"", before));
  sitting_->keep("nodes-in-place-of-the-console.png");
  const ivec4 canvas = sitting_->item("nodes canvas");
  EXPECT_GE(canvas.y, picture.y + picture.w);
  sitting_->stroke("n");
  command(*sitting_, "ls");
  EXPECT_EQ(sitting_->item("picture"), picture);
  for (std::size_t i = before; i < sitting_->now(); ++i)
    EXPECT_EQ(sitting_->line(i).find(" picture "), std::string::npos) << sitting_->line(i);
}

// Lone ones, too, and in a pane that is low; a view that was set by hand stays.
TEST_F(NodesSitting, AllAreInSightAtOpeningUnlessTheViewWasSetByHand) {
  sitting_->click(sitting_->middle("tab nodes"));
  sitting_->wait_for(" still", sitting_->wait_for("item \"box key\""));
  const auto make = [&](const std::string& name) {
    sitting_->click(sitting_->middle("tab console"));
    type("createNode volumeRead -name " + name);
    const std::size_t before = sitting_->now();
    sitting_->click(sitting_->middle("tab nodes"));
    sitting_->wait_for("item \"box " + name + "\"", before);
    sitting_->wait_for(" still", sitting_->now());
  };
  const auto is_in_sight = [&](const std::string& name) {
    const ivec4 canvas = sitting_->item("nodes canvas"), box = sitting_->item("box " + name);
    return box.x >= canvas.x && box.y >= canvas.y && box.x + box.z <= canvas.x + canvas.z &&
           box.y + box.w <= canvas.y + canvas.w;
  };
  for (const char* name : {"lone1", "lone2", "lone3"}) make(name);
  keep("nodes-lone.png");
  for (const char* name : {"lone1", "lone2", "lone3", "key", "medium_shape"})
    EXPECT_TRUE(is_in_sight(name)) << name;

  const ivec4 canvas = sitting_->item("nodes canvas");
  const ivec2 middle(canvas.x + canvas.z / 2, canvas.y + canvas.w / 2);
  sitting_->drag(middle, middle - ivec2(0, canvas.w / 2), 2);
  sitting_->wait_for(" still", sitting_->now() - 1);
  const ivec4 place = sitting_->item("box key");
  EXPECT_FALSE(is_in_sight("key"));
  make("lone4");
  EXPECT_EQ(sitting_->item("box key"), place) << "as the hand left it";
  sitting_->move(middle);
  sitting_->wait_for_mouse(middle, 0);
  const std::size_t before = sitting_->now();
  sitting_->stroke("a");
  sitting_->wait_for("item \"box lone4\"", before);
  sitting_->wait_for(" still", sitting_->now() - 1);
  EXPECT_TRUE(is_in_sight("lone4"));
  EXPECT_TRUE(is_in_sight("key"));
}

TEST_F(NodesSitting, WhatFailsIsMarkedAndSoIsWhatItBlocks) {
  type("createNode volumeRead -name gone");
  type("setAttr gone.file \"/nowhere/gone.vdb\"");
  type("getAttr gone.file");
  type("connectAttr gone.volume medium_shape.volume -force");
  const ivec4 mark = sitting_->item("failed gone"), row = sitting_->item("node gone");
  EXPECT_GE(mark.y, row.y);
  EXPECT_LE(mark.y + mark.w, row.y + row.w);
  sitting_->item("failed medium_shape");
  sitting_->click(sitting_->middle("tab nodes"));
  sitting_->wait_for("item \"box gone\"");
  sitting_->move(sitting_->middle("node gone"));
  sitting_->wait_for_mouse(sitting_->middle("node gone"), 0);
  keep("nodes-failed.png");
}

TEST_F(NodesSitting, ARowOfTheOutlinerIsDraggedUnderATransformAndBackToTheTop) {
  type("createNode transform -name rig");
  type("setAttr rig.rotate 0 30 0");
  expect_command("parent key rig",
                 [&] { sitting_->drag(sitting_->middle("node key"), sitting_->middle("node rig")); });
  keep("outliner-parented.png");
  EXPECT_NE(saved("under.plinian").find("key under rig\n"), std::string::npos);
  const ivec4 last = sitting_->item("node time1");
  expect_command("parent -world key", [&] {
    sitting_->drag(sitting_->middle("node key"), ivec2(last.x + 40, last.y + 3 * last.w));
  });
}

}  // namespace
}  // namespace plinian
