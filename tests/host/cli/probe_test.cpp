// plinian probe.
#include <fstream>
#include <iterator>

#include "tests/host/cli/program_fixture.h"

namespace plinian::cli {
namespace {

using nlohmann::json;

TEST_F(Program, ProbesWhatAPixelSees) {
  const json report = json::parse(
      run({"probe", "explosion", "--resolution", "24", "--size", "32x32", "--pixel", "16,16", "--json", "-q"})
          .out);
  EXPECT_EQ(report["view"]["samples"].size(), 256u);
  ASSERT_TRUE(report["view"]["depth"].is_number());
  EXPECT_EQ(report["point"]["t"], report["view"]["depth"]);
  // Transmittance falls from 1 to under a half, and never rises.
  double before = 1.0;
  for (const json& sample : report["view"]["samples"]) {
    EXPECT_LE(sample["transmittance"][1].get<double>(), before + 1e-12);
    before = sample["transmittance"][1];
  }
  EXPECT_LT(before, 0.5);
  ASSERT_EQ(report["lights"].size(), 2u);
  for (const json& light : report["lights"])
    EXPECT_NEAR(light["map"][1].get<double>(), light["exact"][1].get<double>(), 0.1) << light["light"];
}

TEST_F(Program, DrawsAProbeOnAPage) {
  const Ended ended = run({"probe", "explosion", "--resolution", "24", "--size", "32x32", "--pixel", "16,16",
                           "-o", "probe.html"});
  EXPECT_NE(ended.out.find("key"), std::string::npos);
  std::ifstream file(folder_ / "probe.html");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(page.find("<polyline class=\"map\""), std::string::npos);
  EXPECT_TRUE(page.ends_with("</html>\n"));
}

TEST_F(Program, RefusesAPixelThatIsNone) {
  const auto error = [&](const char* pixel) {
    const Ended ended = run({"probe", "box", "--size", "32x32", "--pixel", pixel, "-q"});
    EXPECT_EQ(ended.code, 1);
    return ended.err;
  };
  EXPECT_EQ(error("32,0"), "plinian: error: --pixel: 32,0 lies outside the picture of 32x32 (--size)\n");
  EXPECT_EQ(error("left"), "plinian: error: --pixel: expected X,Y, as in 256,300, not 'left'\n");
}

}  // namespace
}  // namespace plinian::cli
