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

}  // namespace
}  // namespace plinian
