// bench on the CPU renderer: the shape of its report, and that edits cost what they should.
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

using nlohmann::json;

TEST_F(Program, BenchTimesEveryEditOfTheCpuRenderer) {
  const Ended ended =
      run({"bench", "ash", "--resolution", "32", "--size", "32x32", "--runs", "2", "--renderer", "cpu",
           "--json", "--against", "true", "--set", "map.resolution=128"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  expect_bench_shape(report, "cpu");
  EXPECT_TRUE(report["ratios"].contains("cpu.fast.against_over_orbit_frame"));
  EXPECT_EQ(
      run({"bench", "sphere", "--size", "8x8", "--runs", "1", "--renderer", "cpu", "--against", "false"})
          .code,
      1);
}

TEST_F(Program, BenchTellsHowTheErrorChangesFromFrameToFrame) {
  const Ended ended =
      run({"bench", "ash", "--resolution", "32", "--size", "32x32", "--renderer", "cpu", "--json", "--preset",
           "fast", "--preset", "high", "--swim", "3", "--set", "map.resolution=128"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_EQ(report["frames"], 3);
  for (const char* movement : {"orbit", "key_turn"}) {
    const json& fast = report["swim"]["cpu"]["fast"][movement];
    const json& high = report["swim"]["cpu"]["high"][movement];
    EXPECT_GT(fast["psnr"].get<double>(), 20.0);
    EXPECT_GT(high["psnr"].get<double>(), fast["psnr"].get<double>());
    EXPECT_GT(fast["largest_step"].get<double>(), 0.0);
    // Two errors that have nothing to do with each other would give 1.41.
    EXPECT_LT(fast["step_over_error"].get<double>(), 1.0);
  }
  // Nothing changes where nothing moves.
  const Ended still = run({"bench", "sphere", "--size", "16x16", "--renderer", "cpu", "--json", "--preset",
                           "fast", "--swim", "2", "--swim-degrees", "0", "--set", "map.resolution=64"});
  ASSERT_EQ(still.code, 0) << still.err;
  const json orbit = json::parse(still.out)["swim"]["cpu"]["fast"]["orbit"];
  EXPECT_TRUE(orbit["psnr_step"].is_null());
  EXPECT_EQ(orbit["largest_step"], 0.0);
  EXPECT_TRUE(orbit["psnr"].is_number());
}

// The shape that scripts rely on; what the figures are is the machine's.
TEST_F(Program, BenchDragsAsAHandDoes) {
  const std::vector<std::string> arguments = {"bench",
                                              "ash",
                                              "--resolution",
                                              "32",
                                              "--size",
                                              "48x32",
                                              "--renderer",
                                              "cpu",
                                              "--drags",
                                              "--set",
                                              "map.resolution=64",
                                              "--drag-seconds",
                                              "0.3",
                                              "--drag-samples",
                                              "2",
                                              "--rest-seconds",
                                              "0.5"};
  std::vector<std::string> for_scripts = arguments;
  for_scripts.insert(for_scripts.end(), {"--json", "--drag-pictures", "pictures"});
  const Ended ended = run(for_scripts);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_EQ(report["size"], json({48, 32}));
  EXPECT_EQ(report["preset"], "fast");
  for (const char* name : {"density", "key", "camera"}) {
    SCOPED_TRACE(name);
    const json& drag = report["drags"][name];
    EXPECT_EQ(drag["asked"], 19);
    EXPECT_GE(drag["pictures"].get<int>(), 1);
    EXPECT_LE(drag["pictures"].get<int>() + drag["dropped"].get<int>(), 19);
    for (const char* key :
         {"per_second", "within_150_ms", "ssim_over_0.9", "map_ms", "view_ms", "map_builds", "changes"})
      EXPECT_TRUE(drag[key].is_number()) << key;
    for (const char* key : {"median", "p95", "worst"})
      EXPECT_GT(drag["latency_ms"][key].get<double>(), 0.0) << key;
    EXPECT_LE(drag["latency_ms"]["median"], drag["latency_ms"]["worst"]);
    EXPECT_LE(drag["ssim"]["worst"], drag["ssim"]["median"]);
    EXPECT_GT(drag["ssim"]["worst"].get<double>(), 0.5) << "it is a picture of the same scene";
    EXPECT_GE(drag["ssim"]["samples"].get<int>(), 1);
  }
  EXPECT_EQ(report["drags"]["density"]["map_builds"], 0) << "up to twice as dense maps are kept";
  EXPECT_GT(report["drags"]["key"]["map_builds"].get<int>(), 0);
  const json& rest = report["rest"];
  EXPECT_EQ(rest["preset"], "high");
  EXPECT_EQ(rest["psnr_after_s"].size(), 4u);
  ASSERT_FALSE(rest["pictures"].empty());
  EXPECT_GT(rest["pictures"].back()["psnr"].get<double>(), 25.0);
  EXPECT_TRUE(rest["pop"]["ssim"].is_number());
  EXPECT_GT(report["take_hold_ms"]["worst"].get<double>(), 0.0);
  EXPECT_EQ(read_image(folder_ / "pictures/density_01_quick.png").width, 48);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "pictures/rest_reference.png"));

  std::vector<std::string> for_people = arguments;
  for_people.back() = "0";  // without the reference
  const Ended table = run(for_people);
  ASSERT_EQ(table.code, 0) << table.err;
  for (const char* word : {"pictures/s", "within 150 ms", "SSIM", "density", "key", "camera", "taking hold"})
    EXPECT_NE(table.out.find(word), std::string::npos) << word;
  EXPECT_EQ(table.out.find("let go"), std::string::npos);
}

TEST_F(Program, BenchRefusesDragsThatMakeNoSense) {
  const auto expect_refused = [&](std::vector<std::string> arguments, int code) {
    arguments.insert(arguments.begin(), {"bench", "ash"});
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_EQ(ended.error_lines(), 1) << ended.err;
    EXPECT_EQ(ended.out, "");
  };
  expect_refused({"--drags", "--drag-seconds", "0"}, 2);
  expect_refused({"--drags", "--drag-samples", "many"}, 2);
  expect_refused({"--drags", "--swim", "3"}, 2);
  expect_refused({"--drag-seconds", "2"}, 2);
}

}  // namespace
}  // namespace plinian
