// A look chosen from the gallery, and what one has made shown to others: a playblast.
#include <gtest/gtest.h>

#include "core/image/image_io.h"
#include "tests/host/window/steps.h"

namespace plinian {
namespace {

class ShowSitting : public testing::Test {
 protected:
  static constexpr ivec2 size{1000, 640}, nowhere{500, 634};
  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
    sitting_ = std::make_unique<Sitting>(std::vector<std::string>{"sphere"}, size);
    sitting_->move(nowhere);
    wait_for_rest(*sitting_, 0);
    sitting_->wait_for(" still", sitting_->now());
  }
  // What the palette finds first for those words.
  void take(const std::string& words, const std::string& found) {
    sitting_->stroke("Control_L+Shift_L+p");
    sitting_->wait_for_keys("keys to a field");
    const std::size_t before = sitting_->now();
    sitting_->type(words);
    sitting_->wait_for("palette finds " + found, before);
    sitting_->stroke("Return");
    sitting_->wait_for_keys("keys to the window");
  }
  std::unique_ptr<Sitting> sitting_;
};

TEST_F(ShowSitting, TheGalleryPutsALookOnAndUndoTakesItOff) {
  Sitting& sitting = *sitting_;
  const Pixels plain = sitting.pixels(sitting.item("picture"));
  take("look gallery", "menu look gallery");
  const ivec2 explosion = sitting.middle("look explosion");
  sitting.item("look sandstorm");
  sitting.wait_for(" still", sitting.now() - 1);
  sitting.keep("gallery-1.png");
  // Every look is another picture.
  const Pixels one = sitting.pixels(sitting.item("look ash")),
               other = sitting.pixels(sitting.item("look cloud"));
  EXPECT_LT(psnr(one, other.rgb), 35.0);
  std::size_t before = sitting.now();
  sitting.click(explosion);
  sitting.wait_for("ran preset apply \"explosion\" medium", before);
  sitting.move(nowhere);
  wait_for_rest(sitting, before);
  sitting.keep("gallery-2-explosion.png");
  const auto difference = [&] { return psnr(plain, sitting.pixels(sitting.item("picture")).rgb); };
  EXPECT_LT(difference(), 35.0);
  before = sitting.now();
  sitting.stroke("Control_L+z");
  wait_for_rest(sitting, sitting.wait_for("ran undo", before));
  sitting.click(sitting.middle("close the looks"));
  sitting.move(nowhere);
  sitting.wait_for(" still", sitting.now());
  EXPECT_GT(difference(), 60.0);
}

TEST_F(ShowSitting, TheGalleryFitsIntoALowWindow) {
  Sitting& sitting = *sitting_;
  const std::size_t before = sitting.now();
  sitting.resize({1000, 480});
  sitting.wait_for("item \"timeline\"", before);
  take("look gallery", "menu look gallery");
  sitting.item("look sandstorm");
  sitting.wait_for(" still", sitting.wait_for("item \"look sandstorm\"", before));
  sitting.keep("gallery-low.png");
  const ivec4 timeline = sitting.item("timeline"), strip = sitting.item("show");
  for (const char* name : {"look ash", "look cloud", "look explosion", "look sandstorm"}) {
    const ivec4 place = sitting.item(name);
    EXPECT_GE(place.y, strip.y + strip.w) << name;
    EXPECT_LT(place.y + place.w, timeline.y) << name;
    EXPECT_GE(place.w, 16) << name;
  }
}

TEST_F(ShowSitting, APlayblastIsAskedForRunsBesideTheWindowAndLeavesItsFrames) {
  Sitting& sitting = *sitting_;
  command(sitting, "setAttr settings.width 64");
  command(sitting, "setAttr settings.height 48");
  leave_fields(sitting, nowhere);
  sitting.stroke("Control_L+p");
  const auto fill = [&](const char* field, const std::string& text) {
    sitting.click(sitting.middle(field));
    sitting.wait_for_keys("keys to a field");
    sitting.stroke("Control_L+a");
    sitting.type(text);
  };
  fill("playblast last", "2");
  // A path that cannot be is said where it can be mended, and the dialog stays.
  std::size_t refused = sitting.now();
  fill("playblast path", "/nowhere/at/all/seen.####.png");
  sitting.click(sitting.middle("playblast render"));
  sitting.wait_for("playblast refused: ", refused);
  sitting.wait_for(" still", sitting.now());
  sitting.keep("playblast-refused.png");
  fill("playblast path", (sitting.folder() / "seen.####.png").string());
  sitting.keep("playblast-1.png");
  // The browser stands over it; what is chosen there is the path.
  std::filesystem::create_directory(sitting.folder() / "takes");
  std::size_t listed = sitting.now();
  sitting.click(sitting.middle("playblast browse"));
  sitting.wait_for("folder " + sitting.folder().string() + " lists", listed);
  sitting.wait_for_keys("keys to a field");
  sitting.wait_for(" still", sitting.now() - 1);
  sitting.keep("playblast-browser.png");
  sitting.stroke("Escape");
  sitting.wait_for_keys("keys to the window");
  listed = sitting.now();
  sitting.click(sitting.middle("playblast browse"));
  sitting.wait_for("folder " + sitting.folder().string() + " lists", listed);
  sitting.wait_for_keys("keys to a field");
  sitting.stroke("Control_L+a");
  sitting.type("takes/seen.####");
  sitting.stroke("Return");
  sitting.wait_for_keys("keys to the window");
  sitting.wait_for(" still", sitting.now() - 1);
  sitting.keep("playblast-chosen.png");
  const std::size_t before = sitting.now();
  sitting.click(sitting.middle("playblast render"));
  // The window goes on.
  sitting.move(nowhere);
  sitting.wait_for("playblast: 2 frames", before);
  sitting.wait_for(" still", before);
  sitting.keep("playblast-2.png");
  for (const char* name : {"seen.0001.png", "seen.0002.png"}) {
    const Image frame = read_image((sitting.folder() / "takes" / name).string());
    EXPECT_EQ(frame.width, 64) << name;
    EXPECT_EQ(frame.height, 48) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(sitting.folder() / "takes" / "seen.0003.png"));
}

}  // namespace
}  // namespace plinian
