// The window as somebody who sits before it finds it.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "core/files/atomic_file.h"
#include "core/image/image_io.h"
#include "tests/host/cli/program.h"
#include "tests/host/window/steps.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;

// What a picture's line says.
struct Shown {
  long number = 0;
  int width = 0, height = 0;
  double ms = 0.0;
};
Shown shown_in(const std::string& line) {
  Shown shown;
  std::istringstream words(line);
  std::string word;
  char x;
  words >> word >> word >> shown.number >> shown.width >> x >> shown.height >> word >> word >> word >>
      shown.ms;
  return shown;
}

TEST(Window, WithoutADisplaySaysInOneLineWhatToDoInstead) {
  const Ended ended = plinian_program({"view"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.error_lines(), 1);
  EXPECT_NE(ended.err.find("plinian render"), std::string::npos) << ended.err;
}

class WindowSitting : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  }
};

TEST_F(WindowSitting, LooksTunesTakesBackAndSaves) {
  Sitting sitting({}, {1280, 700});
  std::size_t at = wait_for_rest(sitting, 0);
  // What is drawn over the picture is none of it, so that it is hidden before pixels are compared.
  const ivec2 nowhere(700, 690);  // in the status line
  sitting.click(sitting.middle("show"));
  for (const char* drawn :
       {"show ground grid", "show axes", "show scale bar", "show bounds of what is selected",
        "show lights and cameras", "show gate of the scene's camera"})
    sitting.click(sitting.middle(drawn));
  sitting.click(nowhere);
  const ivec4 place = sitting.item("picture");
  sitting.keep("1-start.png");

  // At rest the window shows what a batch job renders.
  sitting.move({5, sitting.middle("node camera").y});
  command(sitting, "save first.plinian");
  sitting.move({5, 5});
  at = sitting.now();
  const Pixels seen = sitting.pixels(place);
  const Ended rendered = plinian_program({"render", "first.plinian", "-o", "first.png", "--size",
                                          std::to_string(place.z) + "x" + std::to_string(place.w), "-q"},
                                         {.folder = sitting.folder().string()});
  ASSERT_EQ(rendered.code, 0) << rendered.err;
  const Image batch = read_image((sitting.folder() / "first.png").string());
  ASSERT_EQ(batch.width, place.z);
  std::vector<std::uint8_t> bytes = to_display_bytes(batch, ViewTransform({.view = View::srgb}), false);
  const double agreement = psnr(seen, bytes);
  printf("window against batch: %.1f dB\n", agreement);
  EXPECT_GT(agreement, 60.0);

  // Tumbling changes the picture, `[` brings it back.
  sitting.key_down("Alt_L");
  const ivec2 middle = sitting.middle("picture");
  sitting.drag(middle, middle + ivec2(90, 20));
  sitting.key_up("Alt_L");
  sitting.move({5, 5});
  at = wait_for_rest(sitting, at);
  const ivec4 wide = sitting.item("picture");
  EXPECT_GE(wide.z, place.z) << "a camera of one's own fills the pane";
  sitting.keep("2-tumbled.png");
  EXPECT_LT(psnr(sitting.pixels(place), seen.rgb), 30.0);
  sitting.stroke("bracketleft");
  at = wait_for_rest(sitting, at + 1);
  EXPECT_GT(psnr(sitting.pixels(place), seen.rgb), 60.0) << "the same picture to the bit";

  // A dragged value is one step of undo.
  sitting.click(sitting.middle("node medium"));
  const ivec2 field = sitting.middle("medium.density_scale");
  sitting.keep("3-selected.png");
  const std::size_t before_drag = sitting.now();
  sitting.drag(field, field + ivec2(60, 0));
  at = wait_for_rest(sitting, before_drag);
  sitting.keep("4-dragged.png");
  command(sitting, "save dragged.plinian");
  EXPECT_NE(text_of(sitting.folder() / "first.plinian"), text_of(sitting.folder() / "dragged.plinian"));
  sitting.click(nowhere);  // out of the command line
  sitting.wait_for_keys("keys to the window");
  sitting.stroke("Control_L+z");
  command(sitting, "save back.plinian");
  EXPECT_EQ(text_of(sitting.folder() / "first.plinian"), text_of(sitting.folder() / "back.plinian"));

  // The scene that was saved is open; nothing is unsaved, so that the window closes.
  sitting.ask_to_close();
  EXPECT_EQ(sitting.exit_code(), 0) << sitting.errors();
}

// Whatever is being rendered, the interface does not wait for it.
TEST_F(WindowSitting, AnswersWhileItRenders) {
  Sitting sitting({});
  wait_for_rest(sitting, 0);
  const std::size_t since = sitting.now();
  sitting.move({5, 5});
  sitting.stroke("2");
  sitting.wait_for("ran quality high", since);
  const ivec2 middle = sitting.middle("picture");
  sitting.key_down("Alt_L");
  for (int i = 0; i < 4; ++i) sitting.drag(middle, middle + ivec2(i % 2 ? -80 : 80, 10));
  sitting.key_up("Alt_L");
  sitting.key_down("l");
  sitting.drag(middle, middle + ivec2(-70, -30));
  sitting.key_up("l");
  for (const char* node : {"node key", "node medium", "node camera"}) sitting.click(sitting.middle(node));
  sitting.move({5, 5});
  const std::size_t sharp = sitting.wait_for(" refining ", sitting.now());
  const Shown last = shown_in(sitting.line(sharp));
  sitting.keep("5-high.png");
  double longest = 0.0;
  int pictures = 0;
  for (std::size_t i = since; i < sitting.now(); ++i) {
    const std::string line = sitting.line(i);
    if (const auto at = line.find(" stall "); at != line.npos)
      longest = std::max(longest, std::stod(line.substr(at + 7)));
    pictures += line.find(" picture ") != line.npos;
  }
  double at_start = 0.0;
  for (std::size_t i = 0; i < since; ++i)
    if (const auto at = sitting.line(i).find(" stall "); at != std::string::npos)
      at_start = std::max(at_start, std::stod(sitting.line(i).substr(at + 7)));
  printf(
      "longest stall at the start %.0f ms, afterwards %.0f ms (0: none over 50); %d pictures; the last "
      "took %.0f ms\n",
      at_start, longest, pictures, last.ms);
  EXPECT_GT(pictures, 3);
  if (last.ms > 1000.0) {
    EXPECT_LT(longest, last.ms) << "it waited for a picture";
  }
}

// A light's brightness is a matter of layers: the picture stays at rest while it is dragged.
TEST_F(WindowSitting, ComparesWithWhatWasKeptAndRelightsWithoutRendering) {
  Sitting sitting({});
  wait_for_rest(sitting, 0);
  sitting.move({5, 5});
  std::size_t at = sitting.now();
  sitting.stroke("p");
  at = sitting.wait_for("psnr", at);
  EXPECT_GT(psnr_in(sitting.line(at)), 100.0) << "it is that picture";
  sitting.stroke("Shift_L+w");
  const ivec2 exposure = sitting.middle("light key exposure");
  at = sitting.now();
  sitting.drag(exposure, exposure + ivec2(30, 0));
  sitting.wait_for("ran setAttr key.exposure", at);
  at = wait_for_rest(sitting, at);
  sitting.keep("7-wipe.png");
  EXPECT_LT(psnr_in(sitting.line(at)), 60.0) << sitting.line(at);
  for (std::size_t i = at; i < sitting.now(); ++i)
    EXPECT_EQ(sitting.line(i).find("quick"), std::string::npos)
        << "nothing was rendered: " << sitting.line(i);
  at = sitting.now();
  sitting.stroke("Control_L+z");
  at = sitting.wait_for("ran undo", at);
  // A picture of the drag may still come; the one that was kept comes after it.
  sitting.wait_for([](const std::string& line) { return psnr_in(line) > 100.0; }, at);
  sitting.keep("9-undone.png");
  const ivec4 place = sitting.item("picture");
  const ivec2 line(place.x + place.z / 2, place.y + place.w / 2);
  sitting.drag(line, line + ivec2(-60, 0));
  // The line is where it was dragged to, and is turned by a grip.
  sitting.move({5, 5});
  EXPECT_NEAR(sitting.middle("wipe line").x, line.x - 60, 2);
  const ivec2 grip = sitting.middle("wipe grip");
  EXPECT_NEAR(grip.x, line.x - 60, 2);
  sitting.drag(grip, grip + ivec2(-80, -20));
  sitting.move({5, 5});
  EXPECT_LT(sitting.middle("wipe grip").x, grip.x - 40);
  sitting.keep("9-turned.png");
  at = sitting.now();
  sitting.stroke("Shift_L+d");
  sitting.move({5, 5});
  sitting.wait_for("picture", at);
  sitting.keep("8-difference.png");
}

// A picture that a batch job made of the scene, under another exposure and before another background.
TEST_F(WindowSitting, MeasuresAgainstAPictureFromAFileAndRestoresASnapshot) {
  Sitting sitting({});
  std::size_t at = wait_for_rest(sitting, 0);
  command(sitting, "setAttr settings.width 320");
  command(sitting, "setAttr settings.height 240");
  command(sitting, "save shot.plinian");
  const Ended rendered = plinian_program({"render", "shot.plinian", "-o", "ref.exr", "--size", "320x240",
                                          "--set", "settings.background=0.3,0.1,0.1", "-q"},
                                         {.folder = sitting.folder().string()});
  ASSERT_EQ(rendered.code, 0) << rendered.err;
  at = sitting.now();
  command(sitting, "loadReference ref.exr");
  sitting.move({5, 5});
  at = sitting.wait_for(
      [](const std::string& line) {
        return line.find(" 320x240 ") != line.npos && line.find(" rest ") != line.npos && psnr_in(line) > 0.0;
      },
      at);
  EXPECT_GT(psnr_in(sitting.line(at)), 50.0) << "it is the scene's own picture: " << sitting.line(at);
  sitting.wait_for(" still", at);
  sitting.keep("10-file.png");
  // A snapshot brings its scene back, reference and all; one step of undo.
  command(sitting, "save before.plinian");
  sitting.click({sitting.item("picture").x + 3, sitting.item("picture").y + 3});
  sitting.wait_for_keys("keys to the window");
  sitting.stroke("p");
  sitting.item("snapshot 1");
  command(sitting, "setAttr medium.albedo 0.3 0.2 0.1");
  command(sitting, "delete reference");
  sitting.click(sitting.middle("snapshot 1"), 3);
  sitting.click(sitting.middle("restore snapshot 1"));
  sitting.wait_for("ran restoreSnapshot", at);
  sitting.keep("11-restored.png");
  command(sitting, "save after.plinian");
  EXPECT_EQ(text_of(sitting.folder() / "before.plinian"), text_of(sitting.folder() / "after.plinian"));
}

// Whoever renders a volume at another size has it framed for that.
TEST_F(WindowSitting, MeetsAFilesGateAndComesBackToTheFile) {
  Sitting sitting({"sphere"});
  wait_for_rest(sitting, 0);
  const Ended rendered = plinian_program({"render", "sphere", "-o", "ref.exr", "--size", "320x240", "-q"},
                                         {.folder = sitting.folder().string()});
  ASSERT_EQ(rendered.code, 0) << rendered.err;
  const auto measured = [&](std::size_t since) {
    return sitting.wait_for(
        [](const std::string& line) {
          return line.find(" 320x240 ") != line.npos && line.find(" rest ") != line.npos &&
                 psnr_in(line) > 50.0;
        },
        since);
  };
  const auto choose = [&](const char* entry) {
    sitting.click({sitting.item("picture").x + 3, sitting.item("picture").y + 3});
    sitting.wait_for_keys("keys to the window");
    sitting.stroke("Control_L+Shift_L+p");
    sitting.type(entry);
    sitting.stroke("Return");
  };
  std::size_t since = sitting.now();
  command(sitting, "loadReference ref.exr");
  sitting.wait_for(" picture ", since);  // held against it
  since = sitting.now();
  choose("set the gate");
  measured(sitting.wait_for("ran frameView", since));
  sitting.keep("12-gate.png");
  for (const char* back : {"compare with the reference", "FLIP"}) {
    choose("compare with nothing");
    since = sitting.now();
    choose(back);
    measured(since);
  }
  choose("compare with nothing");
  since = sitting.now();
  command(sitting, "loadReference ref.exr");
  measured(since);
  // What is kept of a picture of the gate's size is measured at that size.
  sitting.click({sitting.item("picture").x + 3, sitting.item("picture").y + 3});
  sitting.wait_for_keys("keys to the window");
  sitting.stroke("p");
  since = sitting.now();
  sitting.click(sitting.middle("snapshot 1"));
  measured(since);
}

TEST_F(WindowSitting, AsksAboutUnsavedChanges) {
  Sitting sitting({"--empty"});
  const auto ask = [&] {
    const std::size_t since = sitting.now();
    sitting.ask_to_close();
    sitting.wait_for(" still", sitting.wait_for(" question", since));
  };
  command(sitting, "createNode transform");
  ask();
  sitting.keep("6-question.png");
  sitting.click(sitting.middle("unsaved cancel"));
  command(sitting, "save kept.plinian");
  EXPECT_NE(text_of(sitting.folder() / "kept.plinian").find("node transform transform1"), std::string::npos);
  command(sitting, "createNode camera");
  ask();
  sitting.click(sitting.middle("unsaved discard"));
  EXPECT_EQ(sitting.exit_code(), 0) << sitting.errors();
  EXPECT_EQ(text_of(sitting.folder() / "kept.plinian").find("node camera"), std::string::npos);
}

TEST_F(WindowSitting, IsClosedAlthoughAPluginGoesOn) {
  Sitting sitting({"sphere", "--autosave", "0.2"});
  wait_for_rest(sitting, 0);
  command(sitting, "loadPlugin \"" PLINIAN_PATIENT_PLUGIN "\"");
  command(sitting, "createNode patient");
  command(sitting, "setAttr patient1.deaf on");
  const std::size_t before = sitting.now();
  command(sitting, "connectAttr patient1.out medium.density_scale");
  sitting.wait_for("autosaved", before);
  // The plug-in computes for a minute, and the window is still there to be worked with.
  command(sitting, "createNode transform");
  const std::size_t since = sitting.now();
  sitting.ask_to_close();
  sitting.wait_for(" question", since);
  sitting.click(sitting.middle("unsaved discard"));
  EXPECT_EQ(sitting.exit_code(), 1);
  EXPECT_EQ(sitting.errors(),
            "plinian: error: patient1 (patient) goes on although the window is closed: it does not ask "
            "whether it is "
            "cancelled\n");
  EXPECT_TRUE(fs::is_empty(sitting.folder() / "state" / "plinian" / "unsaved"));
}

TEST_F(WindowSitting, StandsAgainWhereTheGpuWasReset) {
  Sitting sitting({"sphere"});
  wait_for_rest(sitting, 0);
  command(sitting, "loadPlugin \"" PLINIAN_WINDOW_PLUGINS "/reset.so\"");
  command(sitting, "createNode transform -name kept");
  leave_fields(sitting, {700, 554});
  sitting.wait_for(" still", sitting.now() - 1);
  const ivec4 place = sitting.item("picture");
  const Pixels before = sitting.pixels(place);
  sitting.keep("gpu-1-before.png");
  std::size_t at = sitting.now();
  command(sitting, "resetGpu");
  at = sitting.wait_for("window again", at);
  sitting.wait_for(" still", at);
  // What comes is rendered by what was lost, too.
  command(sitting, "setAttr medium.density_scale 3");
  wait_for_rest(sitting, at);
  at = sitting.now();
  command(sitting, "undo");
  leave_fields(sitting, {700, 554});
  wait_for_rest(sitting, at);
  sitting.keep("gpu-2-again.png");
  EXPECT_EQ(sitting.item("picture"), place);
  EXPECT_GT(psnr(before, sitting.pixels(place).rgb), 60.0);
  command(sitting, "save kept.plinian");
  EXPECT_NE(text_of(sitting.folder() / "kept.plinian").find("node transform kept"), std::string::npos);
  sitting.ask_to_close();
  EXPECT_EQ(sitting.exit_code(), 0) << sitting.errors();
}

TEST_F(WindowSitting, OffersAfterACrashWhatWasNotSaved) {
  const std::vector<std::string> arguments = {"--empty", "--autosave", "0.2"};
  Sitting sitting(arguments);
  command(sitting, "createNode transform");
  command(sitting, "save kept.plinian");
  const std::size_t before = sitting.now();
  command(sitting, "setAttr transform1.translate 4 5 6");
  sitting.wait_for("autosaved", before);
  sitting.kill_and_start_again(arguments);
  sitting.wait_for(" still");
  sitting.keep("7-recovery.png");
  sitting.click(sitting.middle("recovery recover"));
  sitting.wait_for("recovered");
  // It is the scene of its own file, with changes that are not saved yet.
  EXPECT_EQ(text_of(sitting.folder() / "kept.plinian").find(".translate.x 4"), std::string::npos);
  command(sitting, "save");
  EXPECT_NE(text_of(sitting.folder() / "kept.plinian").find(".translate.x 4"), std::string::npos);
  sitting.ask_to_close();
  EXPECT_EQ(sitting.exit_code(), 0) << sitting.errors();
  // Who ends in order leaves nothing behind.
  EXPECT_TRUE(fs::is_empty(sitting.folder() / "state" / "plinian" / "unsaved"));
}

TEST_F(WindowSitting, KeepsForTheNextStartWhatAPoliteKillFindsUnsaved) {
  const std::vector<std::string> arguments = {"--empty", "--autosave", "86400"};
  Sitting sitting(arguments);
  command(sitting, "createNode transform -name kept");
  sitting.kill_and_start_again(arguments, SIGTERM);
  sitting.click(sitting.middle("recovery recover"));
  sitting.wait_for("recovered");
  command(sitting, "save kept.plinian");
  EXPECT_NE(text_of(sitting.folder() / "kept.plinian").find("node transform kept"), std::string::npos);
}

}  // namespace
}  // namespace plinian
