// The ray probe in the window, by hand.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/host/cli/program.h"
#include "tests/host/window/sitting.h"

namespace plinian {
namespace {

// "probe X Y at T LIGHT exact E map M"
struct Probed {
  int x = 0, y = 0;
  double t = 0.0, exact = 0.0, map = 0.0;
  std::string light;
};

Probed probed_in(const std::string& line) {
  std::istringstream words(line.substr(line.find(" probe ")));
  std::string word;
  Probed result;
  words >> word >> result.x >> result.y >> word >> result.t >> result.light >> word >> result.exact >> word >>
      result.map;
  return result;
}

TEST(ProbeSitting, AClickTellsWhatTheCommandLineTellsOfTheSamePixel) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  constexpr ivec2 size(1280, 800);
  Sitting sitting({"sphere"}, size);
  const auto looks_settled = [](const std::string& line) {
    return line.find(" picture ") != line.npos && line.find(" rest ") != line.npos;
  };
  sitting.wait_for(" still", sitting.wait_for(looks_settled));
  sitting.stroke("i");
  sitting.item("probe");
  const std::size_t before = sitting.now();
  sitting.click(sitting.middle("picture"));
  const std::size_t told = sitting.wait_for(" probe ", before);
  const Probed first = probed_in(sitting.line(told));
  EXPECT_NEAR(first.map, first.exact, 0.05);
  EXPECT_GT(first.exact, 0.0);

  // The same pixel of the same scene, by the program without its window.
  const ivec4 picture = sitting.item("picture");
  const Ended ended = plinian_program(
      {"probe", "sphere", "--size", std::to_string(picture.z) + "x" + std::to_string(picture.w), "--pixel",
       std::to_string(first.x) + "," + std::to_string(first.y), "--json", "--quiet"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json report = nlohmann::json::parse(ended.out);
  EXPECT_NEAR(report["point"]["t"].get<double>(), first.t, 1e-4 * first.t);
  const auto mean = [](const nlohmann::json& rgb) {
    return (rgb[0].get<double>() + rgb[1].get<double>() + rgb[2].get<double>()) / 3.0;
  };
  bool found = false;
  for (const nlohmann::json& light : report["lights"]) {
    if (light["light"] != first.light) continue;
    found = true;
    EXPECT_NEAR(mean(light["exact"]), first.exact, 1e-3);
    EXPECT_NEAR(mean(light["map"]), first.map, 1e-3);
  }
  EXPECT_TRUE(found) << first.light;

  // Further along the ray there is less light from in front, or more from behind: another value in any case.
  const ivec4 ray = sitting.item("probe ray");
  const std::size_t then = sitting.now();
  sitting.click({ray.x + 4 * ray.z / 5, ray.y + ray.w / 2});
  const Probed second = probed_in(sitting.line(sitting.wait_for(" probe ", then)));
  EXPECT_GT(second.t, first.t);
  EXPECT_EQ(second.x, first.x);
  EXPECT_NE(second.exact, first.exact);
  sitting.wait_for(" still", then);
  sitting.keep("probe.png");
}

}  // namespace
}  // namespace plinian
