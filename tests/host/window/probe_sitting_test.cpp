// The ray probe in the window, by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/host/cli/program.h"
#include "tests/host/window/steps.h"

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

const auto looks_settled = [](const std::string& line) {
  return line.find(" picture ") != line.npos && line.find(" rest ") != line.npos &&
         line.find("passes 0") == line.npos;
};

bool covers(ivec4 card, ivec2 at) {
  return at.x >= card.x && at.y >= card.y && at.x < card.x + card.z && at.y < card.y + card.w;
}

TEST(ProbeSitting, AClickTellsWhatTheCommandLineTellsOfTheSamePixel) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  constexpr ivec2 size(1280, 800);
  Sitting sitting({"sphere"}, size);
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

// Where there is little room for both.
TEST(ProbeSitting, InASmallWindowThePictureStaysFree) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  Sitting sitting({"sphere"}, {1000, 700});
  sitting.wait_for(" still", sitting.wait_for(looks_settled));
  const ivec4 picture = sitting.item("picture");
  const ivec2 pixel(picture.x + picture.z / 2, picture.y + 2 * picture.w / 3);
  std::size_t since = sitting.now();
  sitting.stroke("i");
  sitting.item("probe");
  sitting.click(pixel);
  sitting.wait_for(" still", sitting.wait_for(" probe ", since));
  sitting.keep("probe-2-beneath.png");
  EXPECT_EQ(sitting.item("picture"), picture) << "it has the room that it had";
  EXPECT_GE(sitting.item("probe").y, picture.y + picture.w);
  EXPECT_TRUE(covers(sitting.item("probe"), sitting.middle("probe ray")));
  for (std::size_t i = since; i < sitting.now(); ++i)
    EXPECT_EQ(sitting.line(i).find(" picture "), std::string::npos) << "rendered: " << sitting.line(i);
  // Its plots take the mouse there, too.
  const ivec4 ray = sitting.item("probe ray");
  const Probed first = probed_in(sitting.line(sitting.wait_for(" probe ", since)));
  since = sitting.now();
  sitting.click({ray.x + 4 * ray.z / 5, ray.y + ray.w / 2});
  EXPECT_GT(probed_in(sitting.line(sitting.wait_for(" probe ", since))).t, first.t);
  // The console comes before it by its tab, and the next pixel brings it back.
  sitting.click(sitting.middle("tab console"));
  since = sitting.now();
  sitting.click(sitting.middle("command line"));
  sitting.wait_for_keys("keys to a field");
  sitting.keep("probe-3-console.png");
  sitting.click({pixel.x + 20, pixel.y});
  sitting.wait_for(" still", sitting.wait_for(" probe ", since));
  sitting.keep("probe-4-back.png");
  // Off again, the console is where it was.
  sitting.stroke("i");
  command(sitting, "select medium");
}

TEST(ProbeSitting, TheCardLeavesThePixelFreeAndStaysWhereItIsDragged) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  Sitting sitting({"sphere"}, {1440, 900});
  sitting.wait_for(" still", sitting.wait_for(looks_settled));
  sitting.stroke("i");
  sitting.item("probe");
  const ivec4 picture = sitting.item("picture");
  std::size_t since = sitting.now();
  sitting.click(sitting.middle("picture"));
  sitting.move(sitting.middle("picture") + ivec2(1, 0));
  sitting.wait_for(" still", sitting.wait_for(" probe ", since));
  EXPECT_FALSE(covers(sitting.item("probe"), sitting.middle("picture")));
  sitting.keep("probe-5-floating.png");
  // Beneath it one comes with the button down: it gives way.
  const ivec4 first = sitting.item("probe");
  const ivec2 below(std::clamp(first.x + first.z / 2, picture.x + 5, picture.x + picture.z - 5),
                    first.y + first.w / 2);
  ASSERT_TRUE(covers(first, below)) << "else this shows nothing";
  since = sitting.now();
  sitting.drag(sitting.middle("picture"), below);
  sitting.move(below + ivec2(1, 0));
  sitting.wait_for(" still", sitting.wait_for("item \"probe\"", since));
  EXPECT_FALSE(covers(sitting.item("probe"), below));
  sitting.keep("probe-6-gave-way.png");
  const ivec4 before = sitting.item("probe");
  EXPECT_LT(before.z * before.w, picture.z * picture.w * 2 / 5) << "most of the picture is free";
  const ivec2 grip(before.x + 8, before.y + before.w - 3);
  const ivec2 way(before.x > 600 ? -120 : 120, before.y > 250 ? -60 : 60);
  sitting.drag(grip, grip + way);
  sitting.move({5, 5});
  const ivec4 dragged = sitting.item("probe");
  EXPECT_NEAR(dragged.x, before.x + way.x, 2);
  EXPECT_NEAR(dragged.z, before.z, 1);
  EXPECT_NEAR(dragged.y, before.y + way.y, 2);
  sitting.kill_and_start_again({"sphere"}, SIGTERM);
  sitting.wait_for(" still", sitting.wait_for(looks_settled));
  sitting.stroke("i");
  EXPECT_NEAR(sitting.item("probe").x, dragged.x, 2);
  EXPECT_NEAR(sitting.item("probe").y, dragged.y, 2);
  since = sitting.now();
  sitting.click({picture.x + 3 * picture.z / 5, picture.y + picture.w / 4});
  sitting.wait_for(" still", sitting.wait_for(" probe ", since));
  sitting.keep("probe-7-dragged.png");
  since = sitting.now();
  sitting.click(sitting.middle("probe card reset"));
  sitting.move({5, 5});
  sitting.wait_for("item \"probe\"", since);
  EXPECT_EQ(sitting.item("probe").z, before.z);
  EXPECT_NE(sitting.item("probe").x, dragged.x);
}

}  // namespace
}  // namespace plinian
