// The command palette by hand.
#include <gtest/gtest.h>

#include "tests/host/window/steps.h"

namespace plinian {
namespace {

TEST(PaletteSitting, AFewLettersSelectANodeTakeAnActionAndBeginACommand) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  constexpr ivec2 size(900, 600);
  Sitting sitting({"sphere"}, size);
  sitting.wait_for(" still", sitting.wait_for(" rest "));
  const auto find = [&](const std::string& letters, const std::string& wanted) {
    sitting.stroke("Control_L+Shift_L+p");
    sitting.wait_for_keys("keys to a field");
    const std::size_t before = sitting.now();
    sitting.type(letters);
    sitting.wait_for("palette finds " + wanted, before);
  };
  std::size_t before = sitting.now();
  find("rim", "node rim");
  sitting.keep("palette.png");
  sitting.stroke("Return");
  sitting.wait_for("ran select rim", before);
  sitting.wait_for_keys("keys to the window");

  // What was used stands first; the one below it is taken by an arrow.
  sitting.stroke("Control_L+Shift_L+p");
  sitting.wait_for_keys("keys to a field");
  sitting.keep("palette-recent.png");
  before = sitting.now();
  sitting.stroke("Return");
  sitting.wait_for("ran select rim", before);
  sitting.wait_for_keys("keys to the window");

  before = sitting.now();
  find("undo", "action undo");
  sitting.stroke("Return");
  sitting.wait_for("ran undo", before);
  sitting.wait_for_keys("keys to the window");

  // As high as what is found.
  find("node rim", "node rim");
  sitting.wait_for(" still", sitting.now());
  const ivec4 window = sitting.item("palette window"), row = sitting.item("palette node rim");
  EXPECT_LT(window.w, size.y * 7 / 10);
  EXPECT_LT(row.y + row.w, window.y + window.w);
  sitting.keep("palette-few.png");
  sitting.stroke("Escape");
  sitting.wait_for_keys("keys to the window");

  find("setattr", "command setAttr");
  sitting.stroke("Return");
  sitting.wait_for_keys("keys to the window");
  sitting.wait_for_keys("keys to a field");
  before = sitting.now();
  sitting.type("key.exposure 2");
  sitting.keep("palette-line.png");
  sitting.stroke("Return");
  sitting.wait_for("ran setAttr key.exposure 2", before);
}

TEST(PaletteSitting, AnAttributeIsFoundAndItsFieldTakesTheKeys) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  constexpr ivec2 size(1100, 600);
  Sitting sitting({"sphere"}, size);
  wait_for_rest(sitting, 0);
  const auto type_into = [&](const std::string& letters, const std::string& attribute, const char* value) {
    sitting.stroke("Control_L+Shift_L+p");
    sitting.wait_for_keys("keys to a field");
    std::size_t before = sitting.now();
    sitting.type(letters);
    sitting.wait_for("palette finds attribute " + attribute, before);
    sitting.keep("palette-" + letters + ".png");
    before = sitting.now();
    sitting.stroke("Return");
    sitting.wait_for("sought " + attribute, before);
    sitting.wait_for_keys("keys to a field");
    sitting.type(value);
    sitting.keep("palette-" + letters + "-typed.png");
    sitting.stroke("Return");
    sitting.wait_for(value, sitting.wait_for("ran setAttr " + attribute, before));
    sitting.wait_for_keys("keys to the window");
  };
  type_into("density", "medium.density_scale", "7");
  // In a group that is closed, far below.
  type_into("threshold", "settings.fast.map.threshold", "0.05");
  const ivec4 field = sitting.item("settings.fast.map.threshold");
  EXPECT_GT(field.y, 20);
  EXPECT_LT(field.y + field.w, size.y - 20);
  // What takes no keys is shown.
  sitting.stroke("Control_L+Shift_L+p");
  sitting.wait_for_keys("keys to a field");
  std::size_t before = sitting.now();
  sitting.type("medium.phase");
  sitting.wait_for("palette finds attribute medium.phase", before);
  before = sitting.now();
  sitting.stroke("Return");
  sitting.wait_for("sought medium.phase", before);
  sitting.wait_for_keys("keys to the window");
  sitting.wait_for(" still", before);
  sitting.keep("palette-phase.png");
  // A name of a file is a text.
  command(sitting, "createNode volumeRead -name file");
  leave_fields(sitting, {550, 594});
  type_into("file.file", "file.file", "none.vdb");
}

}  // namespace
}  // namespace plinian
