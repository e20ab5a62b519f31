// What is drawn over the picture and what a click in it selects, by hand.
#include <gtest/gtest.h>

#include "tests/host/window/sitting.h"

namespace plinian {
namespace {

TEST(OverlaySitting, AClickSelectsWhatIsUnderItAndWhatIsDrawnCanBeHidden) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  constexpr ivec2 size(1280, 800);
  Sitting sitting({"sphere"}, size);
  sitting.wait_for(" still", sitting.wait_for([](const std::string& line) {
    return line.find(" picture ") != line.npos && line.find(" rest ") != line.npos;
  }));
  const auto keep = [&](const char* name) {
    sitting.wait_for(" still", sitting.now() - 1);
    sitting.keep(name);
  };
  const ivec4 picture = sitting.item("picture");
  keep("overlay.png");
  // Blue of the selected bounds is nowhere in the picture of a grey ball, until it is selected.
  const auto blue_pixels = [&] {
    const Pixels seen = sitting.pixels({picture.x + 2, picture.y + 2, picture.z - 4, 3 * picture.w / 4});
    int count = 0;
    for (std::size_t i = 0; i < seen.rgb.size(); i += 3) count += seen.rgb[i + 2] > seen.rgb[i] + 60;
    return count;
  };
  std::size_t before = sitting.now();
  sitting.click(sitting.middle("picture"));
  sitting.wait_for(" still", sitting.wait_for("select medium_shape", before));
  keep("overlay-selected.png");
  EXPECT_GT(blue_pixels(), 100);

  sitting.click(sitting.middle("show"));
  sitting.click(sitting.middle("show bounds of what is selected"));
  keep("overlay-menu.png");
  before = sitting.now();
  sitting.stroke("Escape");
  const ivec2 beside(picture.x + picture.z - 5, picture.y + 5);
  sitting.click(beside);  // closes the menu
  sitting.click(beside);
  sitting.wait_for(" still", sitting.wait_for("select -clear", before));
  before = sitting.now();
  sitting.click(sitting.middle("picture"));
  sitting.wait_for(" still", sitting.wait_for("select medium_shape", before));
  EXPECT_LT(blue_pixels(), 100) << "hidden";
  before = sitting.now();
  sitting.stroke("Control_L+z");
  sitting.wait_for("undo", before);
}

}  // namespace
}  // namespace plinian
