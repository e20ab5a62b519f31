// The program on the GL renderer.
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

using nlohmann::json;

TEST_F(Program, BenchTimesEveryEditOfTheGlRenderer) {
  const Ended ended = run(
      {"bench", "ash", "--resolution", "32", "--size", "32x32", "--runs", "1", "--renderer", "gl", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  expect_bench_shape(json::parse(ended.out), "gl");
}

TEST_F(Program, RendersOnGl) {
  const Ended ended = run({"render", "ash", "--resolution", "32", "-o", "a.exr", "--renderer", "gl",
                           "--samples", "4", "--size", "32x32"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_GT(mean_of(picture("a.exr"), "A"), 0.1);
}

// Three times the volume, and 200 MiB for the program with its libraries and the picture.
TEST_F(Program, MemoryOfAPictureStaysWithinThreeTimesItsVolumeAnd200MiB) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer takes more memory than the program";
#endif
  const Ended ended = run({"render", "ash", "--resolution", "128", "--size", "512x512", "--passes", "1",
                           "--renderer", "gl", "-o", "a.png", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const double mib = 1024.0 * 1024.0;
  const double volume = json::parse(ended.out).at("volume_bytes").get<double>() / mib;
  const double peak = double(ended.peak_memory) / 1024.0;
  EXPECT_GT(volume, 1.0);
  EXPECT_GT(peak, 20.0);
  EXPECT_LE(peak, 3.0 * volume + 200.0);
  std::printf("peak %.0f MiB, volume %.2f MiB\n", peak, volume);
}

TEST_F(Program, CtrlCEndsAPictureOnGlAfterItsPassAndWritesIt) {
  RunOptions options;
  options.signal_after_text = "camera: placed";
  options.signal_after_s = 0.7;
  const Ended ended = run({"render", "ash", "-o", "a.exr", "--renderer", "gl", "--size", "48x48",
                           "--resolution", "32", "--passes", "60000"},
                          options);
  expect_ctrl_c_keeps_the_picture(ended, picture("a.exr"));
}

TEST_F(Program, AnEditCostsNoMoreThanItsOwnWorkOnTheGpu) {
  expect_edits_cost_their_own_work("gl", "24", "24x24", 1);
}

}  // namespace
}  // namespace plinian
