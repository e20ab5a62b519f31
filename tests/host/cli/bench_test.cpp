// bench on the CPU renderer: the shape of its report, and that edits cost what they should.
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

using nlohmann::json;

TEST_F(Program, BenchTimesEveryEditOfTheCpuRenderer) {
  const Ended ended = run({"bench", "ash", "--resolution", "32", "--size", "32x32", "--runs", "2",
                           "--renderer", "cpu", "--json", "--against", "true"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  expect_bench_shape(report, "cpu");
  EXPECT_TRUE(report["ratios"].contains("cpu.fast.against_over_orbit_frame"));
  EXPECT_EQ(
      run({"bench", "sphere", "--size", "8x8", "--runs", "1", "--renderer", "cpu", "--against", "false"})
          .code,
      1);
}

}  // namespace
}  // namespace plinian
