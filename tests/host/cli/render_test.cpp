// The commands doing their work: pictures, reports, volumes, and a clean end on Ctrl-C.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST_F(Program, RendersAProceduralMediumFramedAndLit) {
  render({"ash", "--resolution", "32", "-o", "ash.exr", "-o", "ash.png"});
  const Image exr = picture("ash.exr"), png = picture("ash.png");
  EXPECT_EQ(exr.width, 48);
  EXPECT_EQ(exr.height, 32);
  EXPECT_EQ(png.width, 48);
  for (const char* channel : {"R", "G", "B", "A", "Z", "key.R", "rim.R", "ambient.R", "emission.R"})
    EXPECT_NE(exr.find(channel), nullptr) << channel;
  // Framed: the medium fills a good part of the picture and leaves its corners free.
  const std::vector<float>& alpha = exr.find("A")->values;
  EXPECT_GT(mean_of(exr, "A"), 0.1);
  EXPECT_LT(mean_of(exr, "A"), 0.8);
  for (const std::size_t corner :
       {std::size_t(0), std::size_t(47), std::size_t(48 * 31), std::size_t(48 * 32 - 1)})
    EXPECT_EQ(alpha[corner], 0.0f);
  // Lit: its brightest parts would not be clipped away, nor be lost in the dark.
  std::vector<float> red = exr.find("R")->values;
  std::sort(red.begin(), red.end());
  EXPECT_GT(red[red.size() * 95 / 100], 0.15f);
  EXPECT_LT(red[red.size() * 95 / 100], 1.5f);
}

TEST_F(Program, WritesWhatItDidIntoTheExr) {
  render({"sphere", "-o", "a.exr", "--preset", "high"});
  const Image image = picture("a.exr");
  EXPECT_EQ(text_fact(image, attribute::renderer), "cpu");
  EXPECT_EQ(text_fact(image, attribute::preset), "high");
  EXPECT_EQ(text_fact(image, attribute::version), PLINIAN_VERSION);
  EXPECT_TRUE(text_fact(image, attribute::command).starts_with("plinian render sphere -o a.exr"));
  EXPECT_EQ(text_fact(image, attribute::scene_hash).size(), 16u);
  EXPECT_TRUE(image.metadata.contains(attribute::world_to_camera));
  EXPECT_TRUE(image.metadata.contains(std::string(attribute::time_prefix) + "view"));
}

TEST_F(Program, GivesOneSceneOneHashWhateverTheQualityAndAnotherAfterAnEdit) {
  const auto hash = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"sphere", "-o", "a.exr"});
    render(arguments);
    return text_fact(picture("a.exr"), attribute::scene_hash);
  };
  const std::string plain = hash({});
  EXPECT_EQ(hash({"--preset", "high"}), plain);
  EXPECT_NE(hash({"--set", "medium.albedo=0.5"}), plain);
  EXPECT_NE(hash({"--set", "camera.azimuth=31"}), plain);
}

TEST_F(Program, SetReachesThePicture) {
  render({"sphere", "-o", "a.exr"});
  render({"sphere", "-o", "b.exr", "--set", "key.exposure=1.75"});  // a stop over its default
  EXPECT_NEAR(mean_of(picture("b.exr"), "key.G") / mean_of(picture("a.exr"), "key.G"), 2.0, 0.01);
  EXPECT_NEAR(mean_of(picture("b.exr"), "rim.G") / mean_of(picture("a.exr"), "rim.G"), 1.0, 1e-3);
}

TEST_F(Program, WithoutAnOutputWritesThePngOfThatNameHereAndSaysSo) {
  const Ended ended = render({"sphere"});
  EXPECT_TRUE(fs::exists(folder_.path() / "sphere.png"));
  EXPECT_NE(ended.err.find("sphere.png"), std::string::npos);
  EXPECT_EQ(ended.out, "");
}

TEST_F(Program, QuietSaysNothing) {
  EXPECT_EQ(render({"sphere", "--quiet"}).err, "");
}

TEST_F(Program, ReportsInJsonForScripts) {
  const Ended ended = render({"sphere", "-o", "a.png", "--json", "--quiet"});
  const json report = json::parse(ended.out);
  EXPECT_EQ(report["outputs"], json({"a.png"}));
  EXPECT_EQ(report["renderer"], "cpu");
  EXPECT_EQ(report["size"], json({48, 32}));
  EXPECT_EQ(report["passes"], 1);
  EXPECT_EQ(report["map_builds"], 2);  // two lights, one colour group
  EXPECT_GT(report["map_bytes"].get<int>(), 0);
  EXPECT_GE(report["time_ms"]["view"].get<double>(), 0.0);
}

TEST_F(Program, TakesThePresetsOfTheUser) {
  folder_.write(
      "plinian/presets/coarse.json",
      R"({"plinian_preset": {"major": 1, "minor": 0}, "map": {"coefficients": 3, "resolution": 64}})");
  RunOptions options;
  options.environment = {{"XDG_CONFIG_HOME", folder_.path().string()}};
  const Ended ended = run({"render", "sphere", "-o", "a.exr", "--preset", "coarse", "--renderer", "cpu",
                           "--samples", "1", "--size", "16x16"},
                          options);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(text_fact(picture("a.exr"), attribute::preset), "coarse");
}

TEST_F(Program, RendersASceneFileWithPathsRelativeToIt) {
  render({"ash", "--resolution", "32", "-o", "warm.png"});
  ASSERT_EQ(run({"make", "ash", "-o", "ash.vdb", "--resolution", "32"}).code, 0);
  folder_.write("scenes/a.json", R"({"volume": "../ash.vdb", "density_scale": 5,
    "lights": [{"type": "point", "position": [10, 20, 10], "kelvin": 3000}], "size": [20, 10]})");
  const Ended ended = run({"render", "scenes/a.json", "-o", "a.exr", "--renderer", "cpu", "--samples", "1"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const Image image = picture("a.exr");
  EXPECT_EQ(image.width, 20);
  // 3,000 K is warm, and a light without intensity lights the medium as the default key would.
  EXPECT_GT(mean_of(image, "light0.R"), 1.3 * mean_of(image, "light0.B"));
  EXPECT_GT(mean_of(image, "light0.R"), 0.005);
}

TEST_F(Program, MakesAVolumeThatItCanDescribeAndRender) {
  ASSERT_EQ(run({"make", "explosion", "-o", "e.vdb", "--resolution", "32", "--seed", "3"}).code, 0);
  const Ended info = run({"info", "e.vdb", "--json"});
  ASSERT_EQ(info.code, 0) << info.err;
  const json facts = json::parse(info.out);
  std::vector<std::string> grids;
  for (const json& grid : facts["grids"]) grids.push_back(grid["name"]);
  EXPECT_EQ(grids, (std::vector<std::string>{"density", "temperature"}));
  EXPECT_GT(facts["grids"][0]["active_voxels"].get<int>(), 100);
  EXPECT_NE(run({"info", "e.vdb"}).out.find("density"), std::string::npos);

  const Ended ended = render({"e.vdb", "-o", "e.exr"});
  EXPECT_GT(mean_of(picture("e.exr"), "emission.R"), 0.0);
  EXPECT_NE(ended.err.find("density scale"), std::string::npos) << ended.err;
}

TEST_F(Program, DescribesAPicture) {
  render({"sphere", "-o", "a.exr"});
  const Ended ended = run({"info", "a.exr"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_NE(ended.out.find("48x32"), std::string::npos);
  EXPECT_NE(ended.out.find("plinian:scene_hash"), std::string::npos);
  const json facts = json::parse(run({"info", "a.exr", "--json"}).out);
  EXPECT_EQ(facts["size"], json({48, 32}));
}

TEST_F(Program, ComparesPicturesAndFailsUnderALimit) {
  render({"sphere", "-o", "a.exr"});
  render({"sphere", "-o", "b.exr", "--set", "lights.exposure=2"});
  const Ended same = run({"compare", "a.exr", "a.exr", "--fail-under", "psnr=60,ssim=0.99"});
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_EQ(same.err, "");
  EXPECT_NE(run({"compare", "b.exr", "a.exr"}).err.find("different scenes"), std::string::npos);
  const Ended other = run(
      {"compare", "b.exr", "a.exr", "--fail-under", "psnr=60", "--json", "--quiet", "--report", "r.html"});
  EXPECT_EQ(other.code, 1);
  EXPECT_EQ(other.error_lines(), 2) << other.err << "one warns that the scenes differ";
  EXPECT_NE(other.err.find("psnr"), std::string::npos);
  EXPECT_LT(json::parse(other.out)["psnr"].get<double>(), 60.0);
  EXPECT_GT(fs::file_size(folder_.path() / "r.html"), 1000u);
}

TEST_F(Program, PutsPicturesSideBySideWithTheirHeatMaps) {
  render({"sphere", "-o", "a.exr", "-o", "a.png"});
  render({"sphere", "-o", "b.exr", "--set", "lights.exposure=2"});
  const auto sheet = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"sheet", "a.exr", "b.exr", "a.png", "-o", "sheet.png"});
    const Ended ended = run(more);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return picture("sheet.png");
  };
  const Image row = sheet({"--label", "one", "--label", "two"});
  EXPECT_EQ(row.width, 4 * 12 + 3 * 48);
  const Image column = sheet({"--columns", "1"});
  EXPECT_EQ(column.width, 2 * 12 + 48);
  EXPECT_GT(column.height, 3 * 32 + 4 * 12 - 1);
  // Under the first picture, which is the reference itself, its map is black; under the second it is not.
  const Image maps = sheet({"--against", "a.exr"});
  const auto brightest = [&](int left) {
    float value = 0.0f;
    for (int y = maps.height / 2 + 12; y < maps.height / 2 + 28; ++y)
      for (int x = left; x < left + 48; ++x)
        value = std::max(value, maps.find("R")->values[std::size_t(y) * maps.width + x]);
    return value;
  };
  EXPECT_LT(brightest(12), 0.01f);
  EXPECT_GT(brightest(72), 0.1f);
  EXPECT_EQ(run({"sheet", "a.exr", "-o", "sheet.exr"}).code, 1);
}

TEST_F(Program, TheReferenceRendersTheSameSceneAsTheMaps) {
  render({"sphere", "-o", "a.exr", "--preset", "high"});
  ASSERT_EQ(run({"render", "sphere", "-o", "r.exr", "--renderer", "reference", "--size", "48x32"}).code, 0);
  EXPECT_NEAR(mean_of(picture("a.exr"), "G") / mean_of(picture("r.exr"), "G"), 1.0, 0.03);
  EXPECT_EQ(text_fact(picture("a.exr"), attribute::scene_hash),
            text_fact(picture("r.exr"), attribute::scene_hash));
}

// Everything that is legal and awkward at once: nothing in the picture may fail to be a number.
TEST_F(Program, AwkwardScenesGiveFinitePictures) {
  const std::vector<std::string> scenes = {
      R"({"volume": "ash", "resolution": 32, "density_scale": 3e5, "camera": {"eye": [0.1, 4, 0], "target": [0, 9, 0]},
          "lights": [{"type": "point", "position": [0, 5, 0], "radius": 0.1}]})",
      R"({"volume": "sphere", "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]},
          "lights": [{"toward": [0, 0, 1], "irradiance": 0}, {"toward": [1, 0, 0], "colour": 0},
                     {"type": "spot", "position": [0, 0.5, 0], "toward": [0, 1, 0], "cone_angle": 1, "penumbra": 90}]})",
      R"({"volume": "box", "density_scale": 0, "lights": [], "ambient": 1, "background": 1})",
      R"({"volume": "box", "scale": [-1, 100, 0.001], "density_scale": 1e4, "sigma_s": [1, 0, 1e-6], "sigma_a": 0})"};
  for (const std::string& scene : scenes) {
    folder_.write("scene.json", scene);
    // Maps of every kind of ray, not many of each.
    render({"scene.json", "-o", "a.exr", "--pixels", "float", "--set", "map.resolution=128"});
    for (const Channel& channel : picture("a.exr").channels) {
      if (channel.name == "Z") continue;  // infinite where there is nothing
      for (const float value : channel.values)
        ASSERT_TRUE(std::isfinite(value)) << channel.name << " of " << scene;
    }
  }
}

TEST_F(Program, CtrlCEndsAPictureAfterItsPassAndWritesIt) {
  RunOptions options;
  options.signal_after_text = "camera: placed";
  options.signal_after_s = 0.7;
  const Ended ended = run({"render", "ash", "-o", "a.exr", "--renderer", "cpu", "--size", "48x48",
                           "--resolution", "32", "--passes", "60000", "--set", "map.resolution=64"},
                          options);
  expect_ctrl_c_keeps_the_picture(ended, picture("a.exr"));
  EXPECT_GT(mean_of(picture("a.exr"), "A"), 0.1);
}

TEST_F(Program, APictureTakesThePassesThatItNeedsAndNoMore) {
  const auto report = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "-o", "a.exr", "--renderer", "cpu", "--size", "48x48", "--json"});
    const Ended ended = run(more);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return json::parse(ended.out);
  };
  const std::vector<std::string> ash = {"ash", "--resolution", "32", "--set", "map.resolution=64"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), ash.begin(), ash.end());
    return report(more);
  };
  const json usual = with({});
  EXPECT_GT(usual["passes"], 1);
  EXPECT_LT(usual["passes"], 32);
  EXPECT_LE(usual["rest_change"], 2.0);
  EXPECT_EQ(with({})["passes"], usual["passes"]) << "the same again";
  const json finer = with({"--set", "view.rest_change=0.5", "--set", "view.passes=200"});
  EXPECT_GT(finer["passes"], usual["passes"]);
  EXPECT_LE(finer["rest_change"], 0.5);
  EXPECT_EQ(with({"--set", "view.rest_change=1e-9", "--set", "view.passes=5"})["passes"], 5) << "at most";
  // An exact number is exact, at rest or not.
  EXPECT_EQ(with({"--passes", "40"})["passes"], 40);
  EXPECT_FALSE(with({"--passes", "1"}).contains("rest_change"));
  // A picture without any medium to see is at rest at once.
  EXPECT_EQ(report({"box", "--set", "medium.density_scale=0"})["passes"], 2);
}

TEST_F(Program, CtrlCEndsARenderWithNothingWritten) {
  RunOptions options;
  options.signal_after_s = 1.0;
  const auto start = std::chrono::steady_clock::now();
  const Ended ended = run(
      {"render", "ash", "-o", "a.exr", "--renderer", "reference", "--size", "2048x2048", "--quiet"}, options);
  EXPECT_EQ(ended.code, 130);
  EXPECT_EQ(ended.err, "plinian: error: cancelled; nothing was written\n");
  EXPECT_TRUE(fs::is_empty(folder_.path()));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 30.0);
}

// The names of the libraries that a call loads, as the dynamic linker tells them.
std::string libraries_of(const Ended& ended) {
  EXPECT_EQ(ended.code, 0) << ended.out;
  EXPECT_NE(ended.err.find("libtbb"), std::string::npos) << "the linker does not tell what it loads";
  return ended.err;
}

TEST_F(Program, OpenImageIOIsLoadedWhenAPictureIsReadAndNeitherAtTheStartNorToWriteAPng) {
  const RunOptions tell{.environment = {{"LD_DEBUG", "files"}}};
  EXPECT_EQ(libraries_of(run({"--version"}, tell)).find("libOpenImageIO"), std::string::npos);
  const std::vector<std::string> small = {"render", "ash",   "--resolution", "16", "--renderer", "cpu",
                                          "--size", "16x16", "--passes",     "1",  "-o",         "a.png"};
  EXPECT_EQ(libraries_of(run(small, tell)).find("libOpenImageIO"), std::string::npos);
  EXPECT_NE(libraries_of(run({"info", "a.png"}, tell)).find("libOpenImageIO"), std::string::npos);
}

TEST_F(Program, AMissingOrForeignPictureModuleIsOneLine) {
  render({"ash", "--resolution", "16", "-o", "a.png"});
  for (const auto& [module, reason] :
       {std::pair("/nowhere/module.so", "/nowhere/module.so: No such file"), std::pair("a.png", "a.png: "),
        std::pair(PLINIAN_OTHER_MODULE, "is not a module of Plinian")}) {
    const Ended ended = run({"info", "a.png"}, {.environment = {{"PLINIAN_IMAGE_FILES", module}}});
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.error_lines(), 1) << ended.err;
    EXPECT_NE(ended.err.find("picture files cannot be used: "), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find(reason), std::string::npos) << ended.err;
  }
  // Known before anything is rendered.
  const Ended ended =
      run({"render", "ash", "-o", "a.exr"}, {.environment = {{"PLINIAN_IMAGE_FILES", "/nowhere/module.so"}}});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.error_lines(), 1) << ended.err;
}

}  // namespace
}  // namespace plinian
