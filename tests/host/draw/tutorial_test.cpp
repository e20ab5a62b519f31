// The tutorial's plug-in from its building to its going; also with libraries that were built outside the
// tree.
#include <cstdlib>

#include "host/graph/files/scene_writer.h"
#include "tests/host/draw/draw_scene.h"

namespace plinian::draw {
namespace {

// Folders to take the plug-in from.
std::string library(const std::string& name) {
  const char* folder = std::getenv("PLINIAN_TUTORIAL");  // where the installation's test has built it
  return std::string(folder ? folder : PLINIAN_TEST_PLUGINS) + "/" + name + ".so";
}

class Tutorial : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Libraries, Tutorial, testing::Values("marker", "marker_old"),
                         [](const auto& info) { return info.param; });

// Pixels of exactly that colour, all of which must be about `radius` from the middle, and their number.
int ring_pixels(const std::vector<std::array<unsigned char, 4>>& picture, std::array<unsigned char, 4> colour,
                double radius) {
  int count = 0;
  for (int y = 0; y < DrawScene::size; ++y)
    for (int x = 0; x < DrawScene::size; ++x) {
      const auto& pixel = picture[std::size_t(y * DrawScene::size + x)];
      if (pixel == std::array<unsigned char, 4>{}) continue;
      EXPECT_EQ(pixel, colour) << x << ", " << y;
      const double distance = std::hypot(x + 0.5 - 32.0, y + 0.5 - 32.0) / 16.0;
      EXPECT_NEAR(distance, radius, 0.1) << x << ", " << y;
      ++count;
    }
  return count;
}

constexpr std::array<unsigned char, 4> orange = {255, 128, 0, 255}, white = {255, 255, 255, 255};

TEST_P(Tutorial, LoadsDrawsUndoesUnloads) {
  DrawScene s;
  EXPECT_EQ(s.run("loadPlugin \"" + library(GetParam()) + "\""), "marker");
  EXPECT_EQ(s.run("addMarker 1.5\nselect -clear\ngetAttr marker1.circumference").substr(0, 16),
            "marker1\n9.424777");
  // A circle of radius 1.5 in a picture 4 wide: as many pixels as its octants step over.
  const int large = ring_pixels(s.picture(), orange, 1.5);
  EXPECT_NEAR(large, 8 * 24.0 / std::numbers::sqrt2, 12.0);

  s.run("setAttr marker1.radius 0.5");
  const int small = ring_pixels(s.picture(), orange, 0.5);
  EXPECT_LT(small, large / 2);
  s.run("undo");
  EXPECT_EQ(ring_pixels(s.picture(), orange, 1.5), large);
  s.run("select marker1");
  EXPECT_EQ(ring_pixels(s.picture(), white, 1.5), large);

  s.run("undo 100");
  EXPECT_EQ(s.run("ls"), "time1");
  EXPECT_EQ(ring_pixels(s.picture(), white, 1.5), 0);
  s.run("redo 100");
  EXPECT_EQ(ring_pixels(s.picture(), white, 1.5), large);

  const std::string before = write_scene(s.session.graph());
  s.run("unloadPlugin -force marker");
  EXPECT_EQ(s.driver->counters().releases, s.driver->counters().uploads);
  EXPECT_EQ(ring_pixels(s.picture(), white, 1.5), 0);
  EXPECT_EQ(write_scene(s.session.graph()), before);
  s.run("loadPlugin \"" + library(GetParam()) + "\"");
  EXPECT_EQ(ring_pixels(s.picture(), white, 1.5), large);
  s.run("delete marker1\nunloadPlugin marker");
  EXPECT_TRUE(s.driver->take_reports().empty());
}

TEST_P(Tutorial, IsHiddenBehindThePictureAndHitWhereItIsDrawn) {
  DrawScene s;
  s.run("loadPlugin \"" + library(GetParam()) + "\"\naddMarker 1.5\nselect -clear");
  EXPECT_GT(ring_pixels(s.picture(), orange, 1.5), 100);
  s.depth_beneath = 0.4f;  // the ring stands half way between the planes
  EXPECT_EQ(ring_pixels(s.picture(), orange, 1.5), 0);
  s.depth_beneath = 0.6f;
  EXPECT_GT(ring_pixels(s.picture(), orange, 1.5), 100);

  s.view.view_from_world = glm::translate(dmat4(1.0), dvec3(0, 0, -2));
  const auto hit = [&](float x, float y) {
    return s.driver->hit(s.view, [&](graph::NodeId node) { return s.place(node); }, {x, y});
  };
  ASSERT_TRUE(hit(32 + 24, 32));
  EXPECT_EQ(hit(32 + 24, 32)->node, s.session.graph().get("marker1").id);
  EXPECT_LE(hit(32 + 24, 32)->distance, std::hypot(1.5, 2.0) + 1e-6);
  EXPECT_GE(hit(32 + 24, 32)->distance, std::hypot(1.5 * std::cos(std::numbers::pi / 64.0), 2.0) - 1e-6)
      << "the middle of a side";
  EXPECT_TRUE(hit(32 - 17, 32 - 17));
  EXPECT_TRUE(hit(32, 32 + 26)) << "beside it, but no more than four points";
  EXPECT_FALSE(hit(32, 32 + 29));
  EXPECT_FALSE(hit(32, 32)) << "the middle is empty";
}

TEST_P(Tutorial, SaysWhatItBrings) {
  DrawScene s;
  EXPECT_EQ(s.run("pluginInfo \"" + library(GetParam()) + "\""),
            "marker 1.0, A. Artist, interface 1.3, registers node:marker command:addMarker, " +
                library(GetParam()));
  s.run("loadPlugin \"" + library(GetParam()) + "\"");
  ASSERT_EQ(s.plugins.menu().size(), 1u);
  EXPECT_EQ(s.plugins.menu()[0].command, "addMarker 1");
  EXPECT_EQ(graph::message_of([&] { s.session.execute("addMarker wide"); }),
            "addMarker: RADIUS expects a number, not 'wide'");
}

}  // namespace
}  // namespace plinian::draw
