// The command palette by hand.
#include <gtest/gtest.h>

#include "tests/host/window/sitting.h"

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

}  // namespace
}  // namespace plinian
