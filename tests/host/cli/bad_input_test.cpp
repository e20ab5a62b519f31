// Bad input at the command line: one clear line, a non-zero exit, nothing written and nothing lost.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/core/scene/temporary_folder.h"
#include "tests/host/cli/program.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;

class BadInput : public testing::Test {
 protected:
  // Runs in a folder of its own and returns the error. Whatever the input, nothing may appear beside it.
  std::string error_of(std::vector<std::string> arguments) {
    const auto before = listing();
    RunOptions options;
    options.folder = folder_.path().string();
    options.user = user_;
    const Ended ended = plinian_program(arguments, options);
    EXPECT_EQ(ended.code, 1) << ended.err;
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(listing(), before);
    EXPECT_EQ(ended.error_lines(), 1) << ended.err;
    const std::string start = "plinian: error: ";
    EXPECT_TRUE(ended.err.starts_with(start)) << ended.err;
    return ended.err.substr(std::min(ended.err.size(), start.size()));
  }
  // Renders with settings that would be quick if the input were good; what is said aloud is not asked for.
  std::string render_error(const std::string& input, std::vector<std::string> more = {}) {
    more.insert(more.begin(),
                {"render", input, "-o", "out.png", "--renderer", "cpu", "--samples", "1", "--quiet"});
    return error_of(more);
  }
  std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  std::string scene(const std::string& text) { return folder_.write("scene.json", text); }

  TemporaryFolder folder_;
  unsigned user_ = 0;
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

#define EXPECT_SAYS(text, part)                               \
  do {                                                        \
    const std::string said = (text);                          \
    EXPECT_TRUE(contains(said, part)) << "it says: " << said; \
  } while (false)

TEST_F(BadInput, NoSuchFileOrMedium) {
  EXPECT_SAYS(render_error("nowhere/smoke.vdb"), "nowhere/smoke.vdb: no such file");
  EXPECT_SAYS(render_error("ahs"), "ahs: no such file, and no medium of that name (did you mean 'ash'?)");
  EXPECT_SAYS(render_error("nowhere.json"), "nowhere.json: no such file");
  EXPECT_SAYS(error_of({"info", "nowhere.vdb"}), "nowhere.vdb: no such file");
  EXPECT_SAYS(error_of({"make", "clod", "-o", "x.vdb"}), "did you mean 'cloud'?");
}

TEST_F(BadInput, AFileThatIsNoVdb) {
  folder_.write("text.vdb", "this is a letter to a friend, and no volume at all");
  EXPECT_SAYS(render_error("text.vdb"), "text.vdb");
  folder_.write("empty.vdb", "");
  EXPECT_SAYS(render_error("empty.vdb"), "empty.vdb");
  EXPECT_SAYS(error_of({"info", "text.vdb"}), "text.vdb");
  fs::create_directory(folder_.path() / "folder.vdb");
  EXPECT_SAYS(render_error("folder.vdb"), "folder.vdb");
}

TEST_F(BadInput, APresetWithAnUnknownKeyAWrongTypeOrAValueOutOfRange) {
  const auto preset = [&](const std::string& map) {
    folder_.write("mine.json", R"({"plinian_preset": {"major": 1, "minor": 0}, "map": {)" + map + "}}");
    return render_error("ash", {"--preset", "./mine.json"});
  };
  EXPECT_SAYS(preset(R"("treshold": 0.1)"),
              "mine.json: map.treshold: unknown key (did you mean 'map.threshold'?)");
  EXPECT_SAYS(preset(R"("threshold": "low")"),
              "mine.json: map.threshold: expected a number in (0, 1), got \"low\"");
  EXPECT_SAYS(preset(R"("coefficients": 17)"),
              "mine.json: map.coefficients: expected an integer from 2 to 16, got 17");
  EXPECT_SAYS(render_error("ash", {"--preset", "fsat"}), "fsat: no such preset (did you mean 'fast'?)");
  EXPECT_SAYS(render_error("ash", {"--coefficients", "99"}),
              "--coefficients: expected an integer from 2 to 16, got 99");
  EXPECT_SAYS(render_error("ash", {"--threshold", "2"}), "--threshold: expected a number in (0, 1), got 2");
  EXPECT_SAYS(render_error("ash", {"--encoding", "fourier"}), "--encoding: expected one of tfm, atfm");
}

TEST_F(BadInput, ASceneWithAnUnknownKeyAWrongTypeOrAValueOutOfRange) {
  EXPECT_SAYS(render_error(scene(R"({"volume": "ash", "albdeo": 1})")),
              "scene.json: albdeo: unknown key (did you mean 'albedo'?)");
  EXPECT_SAYS(render_error(scene(R"({"volume": "ash", "size": "large"})")), "scene.json: size: expected");
  EXPECT_SAYS(render_error(scene(R"({"volume": "ash", "lights": [{"irradiance": [1, -1, 0]}]})")),
              "scene.json: lights[0].irradiance: expected a number or 3 numbers >= 0, got [1,-1,0]");
  EXPECT_SAYS(render_error(scene(R"({"volume": "ash", )")), "scene.json:1:");
  EXPECT_SAYS(render_error(scene(R"({"volume": "box", "lights": [{"type": "point"}]})")),
              "scene.json: light0.position: a spot or point light needs one");
  EXPECT_SAYS(render_error(scene(R"({"volume": "box", "lights": [{"toward": [0, 0, 0]}]})")),
              "scene.json: light0.toward: has no length");
  EXPECT_SAYS(render_error(scene(R"({"volume": "box", "camera": {"eye": [1, 2, 3], "target": [1, 2, 3]}})")),
              "scene.json: camera.eye");
  EXPECT_SAYS(render_error(scene(R"({"volume": "missing.vdb"})")), "missing.vdb: no such file");
}

TEST_F(BadInput, ASingularTransform) {
  EXPECT_SAYS(render_error(scene(R"({"volume": "box", "scale": [1, 0, 1]})")),
              "box: scale: no axis may be 0");
}

TEST_F(BadInput, AnOptionThatDoesNotGoWithTheInput) {
  EXPECT_SAYS(render_error("box", {"--grid", "density"}), "box: grid: only a .vdb file has one");
  EXPECT_SAYS(render_error("box", {"--resolution", "64"}),
              "box: resolution: only a procedural medium has one");
}

TEST_F(BadInput, ValuesOfTheCommandLine) {
  EXPECT_SAYS(render_error("box", {"--set", "medium.albedo=7"}), "--set medium.albedo: expected");
  EXPECT_SAYS(render_error("box", {"--set", "medium.albdo=1"}), "(did you mean 'albedo'?)");
  EXPECT_SAYS(render_error("box", {"--set", "kye.exposure=1"}), "(did you mean 'key'?)");
  EXPECT_SAYS(render_error("box", {"--set", "map.treshold=0.1"}), "(did you mean 'map.threshold'?)");
  EXPECT_SAYS(render_error("box", {"--set", "albedo"}), "--set albedo: expected KEY=VALUE");
  EXPECT_SAYS(render_error("box", {"--size", "512"}), "--size 512: expected WIDTHxHEIGHT");
  EXPECT_SAYS(render_error("box", {"--size", "0x10"}), "--size 0x10: expected WIDTHxHEIGHT");
  EXPECT_SAYS(render_error("box", {"--vdb-memory-limit", "lots"}), "--vdb-memory-limit lots: expected");
  EXPECT_SAYS(render_error("box", {"--view", "sepia"}), "sepia");
}

TEST_F(BadInput, AnOutputThatCannotBeWrittenIsToldBeforeAnythingIsRendered) {
  const auto output_error = [&](const std::string& output) {
    return error_of(
        {"render", "ash", "-o", output, "--quiet", "--resolution", "1024"});  // minutes, if it began
  };
  EXPECT_SAYS(output_error("nowhere/out.png"), "nowhere");
  EXPECT_SAYS(output_error("out.jpeg2000"), "out.jpeg2000");
  EXPECT_SAYS(output_error("out"), "out");
  fs::create_directory(folder_.path() / "folder.png");
  EXPECT_SAYS(output_error("folder.png"), "folder.png");
  EXPECT_SAYS(error_of({"make", "ash", "-o", "nowhere/ash.vdb"}), "nowhere");
  EXPECT_SAYS(error_of({"make", "ash", "-o", "ash.png"}),
              "ash.png: the name of what make writes ends in .vdb");
}

TEST_F(BadInput, AReadOnlyPictureIsLeftAsItWas) {
  const std::string path = folder_.write("kept.png", "precious");
  fs::permissions(path, fs::perms::owner_read);
  if (geteuid() == 0) {  // to whom nothing is read-only
    user_ = 65534;
    ASSERT_EQ(chown(path.c_str(), user_, user_), 0);
    ASSERT_EQ(chown(folder_.path().c_str(), user_, user_), 0);
  }
  EXPECT_SAYS(error_of({"render", "box", "-o", "kept.png", "--quiet"}), "kept.png");
}

TEST_F(BadInput, AFailedRenderLeavesAnExistingPictureAlone) {
  const std::string path = folder_.write("out.png", "precious");
  render_error("nowhere.vdb");
  std::ifstream file(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "precious");
}

TEST_F(BadInput, ComparingWhatCannotBeCompared) {
  folder_.write("text.exr", "no picture");
  EXPECT_SAYS(error_of({"compare", "text.exr", "text.exr"}), "text.exr");
  EXPECT_SAYS(error_of({"compare", "nowhere.exr", "text.exr"}), "nowhere.exr");
  folder_.write("a.plinian", "plinian scene 1.0\nend\n");
  EXPECT_SAYS(error_of({"compare", "a.plinian", "text.exr"}),
              "a.plinian: is a scene, not a picture: render it first");
  EXPECT_SAYS(error_of({"compare", "text.exr", "text.exr", "--fail-under", "beauty=1"}), "beauty");
}

}  // namespace
}  // namespace plinian
