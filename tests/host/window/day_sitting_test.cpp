// A day's work in one sitting, by hand alone: a volume is dropped, lit, tuned, compared, taken back and
// saved.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/core/media/real_files.h"
#include "tests/host/cli/program.h"
#include "tests/host/window/steps.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;

class DaySitting : public testing::Test {
 protected:
  static constexpr ivec2 size{960, 580}, nowhere{520, 574};
  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
    PLINIAN_NEEDS_REAL_FILES();
    smoke_ = fs::canonical(real_file("smoke.vdb"));
    sitting_ = std::make_unique<Sitting>(std::vector<std::string>{}, size);
  }
  void run(const std::vector<std::string>& arguments) {
    const Ended ended = plinian_program(arguments, {.folder = sitting_->folder().string()});
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  // What a batch job makes of such a script: the scene's text.
  std::string batch(const std::string& script) {
    std::ofstream(sitting_->folder() / "batch.pln") << script << "save batch.plinian\n";
    run({"run", "batch.pln"});
    return text_of(sitting_->folder() / "batch.plinian");
  }
  // Types a path into the dialog that such keys open.
  void choose(const std::string& keys, const fs::path& path, const std::string& ran, const char* picture) {
    const std::size_t before = sitting_->now();
    sitting_->stroke(keys);
    sitting_->wait_for_keys("keys to a field");
    sitting_->stroke("Control_L+a");
    sitting_->type(path.string());
    sitting_->keep(picture);
    sitting_->stroke("Return");
    sitting_->wait_for("ran " + ran, before);
    sitting_->wait_for_keys("keys to the window");
  }
  void stroke(const std::string& keys, const std::string& ran) {
    const std::size_t before = sitting_->now();
    sitting_->stroke(keys);
    sitting_->wait_for("ran " + ran, before);
  }
  // The last command of those that begin so, since then; empty where there was none.
  std::string last_command(const std::string& begin, std::size_t since) {
    const std::vector<std::string>& lines = sitting_->lines();
    for (std::size_t i = lines.size(); i-- > since;)
      if (const std::size_t at = lines[i].find(" ran " + begin); at != std::string::npos)
        return lines[i].substr(at + 5, lines[i].rfind(" (") - at - 5);
    return "";
  }
  int pictures(std::size_t since) {
    const std::vector<std::string>& lines = sitting_->lines();
    return int(std::count_if(lines.begin() + std::ptrdiff_t(since), lines.end(),
                             [](const std::string& line) { return line.find(" picture ") != line.npos; }));
  }
  Pixels picture() {
    sitting_->move(nowhere);
    return sitting_->pixels(sitting_->item("picture"));
  }

  fs::path smoke_;
  std::unique_ptr<Sitting> sitting_;
};

TEST_F(DaySitting, AVolumeIsDroppedTunedComparedTakenBackAndSaved) {
  Sitting& sitting = *sitting_;
  wait_for_rest(sitting, 0);
  sitting.keep("day-01-start.png");
  run({"render", smoke_, "-o", "reference.exr", "--passes", "2", "-q"});

  // Found, framed and lit, in place of the sample.
  std::size_t before = sitting.now();
  sitting.drop({smoke_}, sitting.middle("picture"));
  wait_for_rest(sitting, before);
  sitting.keep("day-02-dropped.png");
  const Pixels dropped = picture();
  int bright = 0;
  for (std::size_t i = 0; i < dropped.rgb.size(); i += 3) bright += dropped.rgb[i] > 120;
  EXPECT_GT(bright, dropped.width * dropped.height / 50) << "lit, and large in the picture";

  before = sitting.now();
  sitting.key_down("Alt_L");
  const ivec2 middle = sitting.middle("picture");
  sitting.drag(middle, middle + ivec2(120, 15));
  sitting.key_up("Alt_L");
  sitting.move(nowhere);
  wait_for_rest(sitting, before);
  sitting.keep("day-03-tumbled.png");
  EXPECT_LT(psnr(dropped, picture().rgb), 30.0);

  before = sitting.now();
  const ivec2 density = sitting.middle("smoke.density_scale");
  sitting.drag(density, density + ivec2(70, 0));
  sitting.move(nowhere);
  wait_for_rest(sitting, before);
  sitting.keep("day-04-denser.png");
  const std::string denser = last_command("setAttr smoke.density_scale", before);
  EXPECT_NE(denser, "");

  before = sitting.now();
  const Pixels lit_before = picture();
  sitting.key_down("l");
  sitting.drag(middle, middle + ivec2(-110, 30));
  sitting.key_up("l");
  sitting.move(nowhere);
  wait_for_rest(sitting, before);
  sitting.keep("day-05-key-light.png");
  const std::string turned = last_command("setAttr key.rotate", before);
  EXPECT_NE(turned, "");
  EXPECT_LT(psnr(lit_before, picture().rgb), 30.0);

  before = sitting.now();
  const Pixels fast = picture();
  stroke("2", "quality high");
  wait_for_rest(sitting, before);
  sitting.keep("day-06-high.png");
  EXPECT_NE(picture().rgb, fast.rgb);
  before = sitting.now();
  stroke("1", "quality fast");
  wait_for_rest(sitting, before);
  EXPECT_EQ(picture().rgb, fast.rgb) << "switching back and forth is the same picture to the bit";
  sitting.keep("day-07-fast-again.png");

  // What stands there now is what a script of the same commands makes.
  choose("Control_L+Shift_L+s", sitting.folder() / "tuned.plinian", "save", "day-08-save-as.png");
  const std::string import = "import " + smoke_.string() + " -setup -name smoke\n";
  EXPECT_EQ(text_of(sitting.folder() / "tuned.plinian"), batch(import + denser + "\n" + turned + "\n"));

  // The reference is of the scene's camera, as it was before all this.
  before = sitting.now();
  choose("Control_L+r", sitting.folder() / "reference.exr", "loadReference", "day-09-load-reference.png");
  sitting.stroke("c");
  sitting.move(nowhere);
  std::size_t measured = sitting.wait_for(
      [](const std::string& line) { return line.find(" rest ") != line.npos && psnr_in(line) > 0.0; },
      before);
  sitting.wait_for(" still", measured);
  sitting.keep("day-10-wipe.png");
  EXPECT_LT(psnr_in(sitting.line(measured)), 40.0) << "it was tuned since";
  const ivec2 line = sitting.middle("wipe line");
  sitting.drag(line, line + ivec2(-90, 0));
  sitting.move(nowhere);
  EXPECT_NEAR(sitting.middle("wipe line").x, line.x - 90, 2);
  sitting.keep("day-11-wiped.png");

  sitting.stroke("p");
  sitting.item("snapshot 1");
  sitting.wait_for(" still", sitting.now() - 1);
  sitting.keep("day-12-snapshot.png");

  // Reference, light, density, and what was dropped.
  for (int step = 0; step < 3; ++step) stroke("Control_L+z", "undo");
  sitting.move(nowhere);
  wait_for_rest(sitting, before);
  choose("Control_L+Shift_L+s", sitting.folder() / "untuned.plinian", "save", "day-13-taken-back.png");
  EXPECT_EQ(text_of(sitting.folder() / "untuned.plinian"), batch(import));
  before = sitting.now();
  stroke("Control_L+z", "undo");
  wait_for_rest(sitting, before);
  sitting.keep("day-14-as-at-the-start.png");
  stroke("Control_L+s", "save");
  EXPECT_EQ(text_of(sitting.folder() / "untuned.plinian"), batch("import ash -setup\n"));

  // Nothing is unsaved: it closes without a question.
  sitting.ask_to_close();
  EXPECT_EQ(sitting.exit_code(), 0) << sitting.errors();
  EXPECT_EQ(sitting.errors(), "");
}

}  // namespace
}  // namespace plinian
