// How the program speaks: help, versions, mistyped words.
#include <gtest/gtest.h>

#include "tests/core/scene/temporary_folder.h"
#include "tests/host/cli/program.h"

namespace plinian {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// What a wrong call says; checks that it is one line, that it fails and that nothing else is printed.
std::string usage_error(const std::vector<std::string>& arguments) {
  const Ended ended = plinian_program(arguments);
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(ended.error_lines(), 1) << ended.err;
  return ended.err;
}

TEST(Usage, WithoutArgumentsTheProgramSaysWhatItIsAndHowToBegin) {
  const Ended ended = plinian_program({});
  EXPECT_EQ(ended.code, 0);
  for (const char* word : {"plinian render ash", "render", "compare", "bench", "info", "make", "sheet", "run",
                           "plugins", "--help"})
    EXPECT_TRUE(contains(ended.out, word)) << word;
  EXPECT_EQ(plinian_program({"--help"}).out, ended.out);
}

TEST(Usage, EveryCommandHasHelpWithExamples) {
  for (const char* command : {"render", "compare", "bench", "info", "make", "sheet", "run", "plugins"}) {
    const Ended ended = plinian_program({command, "--help"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_TRUE(contains(ended.out, "Examples:")) << command;
    EXPECT_TRUE(contains(ended.out, std::string("plinian ") + command)) << command;
    EXPECT_EQ(ended.err, "");
  }
}

TEST(Usage, HelpOfACommandIsTheSameEitherWay) {
  const Ended ended = plinian_program({"help", "compare"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out, plinian_program({"compare", "--help"}).out);
  EXPECT_EQ(plinian_program({"help", "comapre"}).code, 2);
}

TEST(Usage, QualityAndSceneKeysAreListed) {
  const Ended quality = plinian_program({"render", "--help-quality"});
  EXPECT_EQ(quality.code, 0);
  EXPECT_TRUE(contains(quality.out, "map.threshold"));
  EXPECT_TRUE(contains(quality.out, "a number in (0, 1)"));
  EXPECT_TRUE(contains(quality.out, "Presets: fast, high"));
  const Ended scene = plinian_program({"render", "--help-scene"});
  EXPECT_EQ(scene.code, 0);
  for (const char* key : {"camera.focal_length", "medium.albedo", "LIGHT.kelvin", "background"})
    EXPECT_TRUE(contains(scene.out, key)) << key;
}

TEST(Usage, TheVersionIsThatOfTheProject) {
  EXPECT_EQ(plinian_program({"--version"}).out, std::string("plinian ") + PLINIAN_VERSION + "\n");
}

TEST(Usage, AMistypedCommandOrOptionIsToldTheNearestOne) {
  EXPECT_EQ(
      usage_error({"rendr", "ash"}),
      "plinian: error: rendr: no such command (did you mean 'render'?); there are: view, render, compare, "
      "bench, info, probe, make, sheet, run, plugins\n");
  EXPECT_TRUE(contains(usage_error({"render", "ash", "--presett", "fast"}),
                       "--presett: no such option (did you mean '--preset'?)"));
  EXPECT_TRUE(
      contains(usage_error({"bench", "ash", "--run=3"}), "--run: no such option (did you mean '--runs'?)"));
  EXPECT_TRUE(contains(usage_error({"info", "a.vdb", "b.vdb"}), "b.vdb: one argument too many"));
}

TEST(Usage, CommandsOfScriptsAreToldApartAndHelpedWith) {
  EXPECT_EQ(usage_error({"import", "ash"}),
            "plinian: error: import: is a command of scripts: 'plinian run SCRIPT' runs them, as in echo "
            "'import ...' "
            "| plinian run -; 'plinian help import' shows what it takes\n");
  const Ended ended = plinian_program({"help", "setAttr"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out, plinian_program({"plugins", "--command", "setAttr"}).out);
  EXPECT_TRUE(contains(ended.out, "setAttr PLUG VALUE...")) << ended.out;
}

TEST(Usage, AFileInPlaceOfACommandIsToldHowToRenderIt) {
  TemporaryFolder folder;
  const std::string file = folder.write("cloud.vdb", "x");
  EXPECT_TRUE(contains(usage_error({file}), "did you mean 'plinian render " + file + "'?"));
}

TEST(Usage, WrongArgumentsAreOneLineThatNamesThem) {
  EXPECT_TRUE(contains(usage_error({"render"}), "INPUT"));
  EXPECT_TRUE(contains(usage_error({"render", "ash", "--passes", "0"}), "--passes"));
  EXPECT_TRUE(contains(usage_error({"render", "ash", "--samples", "many"}), "--passes"));
  EXPECT_TRUE(contains(usage_error({"render", "ash", "--passes", "2", "--passes", "3"}),
                       "--passes: is given more than once;"));
  EXPECT_TRUE(contains(usage_error({"render", "ash", "--renderer", "magic"}), "--renderer"));
  EXPECT_TRUE(contains(usage_error({"render", "ash", "-o"}), "-o"));
  EXPECT_TRUE(contains(usage_error({"make", "ash"}), "--output"));
  EXPECT_TRUE(contains(usage_error({"compare", "a.exr"}), "B"));
}

}  // namespace
}  // namespace plinian
