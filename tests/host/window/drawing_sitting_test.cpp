// What a plug-in draws, seen in the window by somebody who sits before it.
#include "tests/host/window/drawing_sitting.h"

#include <cmath>

namespace plinian {
namespace {

class MarkerSitting : public DrawingSitting {
 protected:
  /// Of a length in the plane z. [points]
  double points(double length, double z = 0.0) {
    const double half_height = std::tan(20.0 * 3.14159265358979 / 180.0) * (6.0 - z);
    return length * sitting_->item("picture").w / (2.0 * half_height);
  }
  /// Pixels of that colour in the picture: how many lie on a circle of that radius [points] around its
  /// middle, and how many do not.
  std::pair<int, int> ring(std::array<int, 3> colour, double radius) {
    const ivec4 place = sitting_->item("picture");
    const Pixels seen = sitting_->pixels(place);
    std::pair<int, int> count{0, 0};
    for (int y = 0; y < seen.height; ++y)
      for (int x = 0; x < seen.width; ++x) {
        const std::uint8_t* rgb = seen.rgb.data() + 3 * (std::size_t(y) * seen.width + std::size_t(x));
        if (rgb[0] != colour[0] || rgb[1] != colour[1] || rgb[2] != colour[2]) continue;
        const double away = std::hypot(x + 0.5 - 0.5 * place.z, y + 0.5 - 0.5 * place.w);
        ++(std::abs(away - radius) < 2.0 ? count.first : count.second);
      }
    return count;
  }

  static constexpr std::array<int, 3> orange = {255, 128, 0};
};

TEST_F(MarkerSitting, AMarkerIsSeenWhereItStandsUntilItIsHiddenOrItsPluginGoes) {
  sit_down();
  command("addMarker 1.5");
  command("select -clear");
  sitting_->keep("drawing-1-marker.png");
  const double wide = points(1.5);
  // As many pixels as the steps of a circle, but for those that the interface writes over.
  const int whole = int(8.0 * wide / std::sqrt(2.0));
  const auto expect_ring = [&](double radius, const char* when) {
    const auto [on, off] = ring(orange, radius);
    EXPECT_GT(on, int(0.7 * 8.0 * radius / std::sqrt(2.0))) << when;
    EXPECT_EQ(off, 0) << when;
  };
  const auto expect_none = [&](const char* when) {
    const auto [on, off] = ring(orange, wide);
    EXPECT_EQ(on + off, 0) << when;
  };
  expect_ring(wide, "at first");
  EXPECT_LE(ring(orange, wide).first, whole + 20);

  command("createNode transform -name t");
  command("parent marker1 t");
  command("select -clear");
  command("setAttr t.visibility off");
  expect_none("hidden");
  command("undo");
  expect_ring(wide, "after undo");
  command("isolate medium_shape");
  expect_none("isolated away");
  command("isolate -off");
  expect_ring(wide, "after that");
  sitting_->click(sitting_->middle("show"));
  sitting_->click(sitting_->middle("show plug-in drawings"));
  const ivec4 place = sitting_->item("picture");
  sitting_->stroke("Escape");
  sitting_->click({place.x + 5, place.y + 5});  // closes the menu
  command("ls");
  expect_none("not shown");
  sitting_->click(sitting_->middle("show"));
  sitting_->click(sitting_->middle("show plug-in drawings"));
  sitting_->stroke("Escape");
  sitting_->click({place.x + 5, place.y + 5});
  command("ls -type marker");
  expect_ring(wide, "shown again");

  // Within the ball, and then before it.
  command("setAttr marker1.radius 0.5");
  expect_none("within the ball");
  command("setAttr t.translate 0 0 2");
  sitting_->keep("drawing-2-before.png");
  expect_ring(points(0.5, 2.0), "before it");
  command("setAttr t.translate 0 0 -2");
  expect_none("behind it");
  sitting_->keep("drawing-3-behind.png");
  command("setAttr marker1.radius 1.5");
  expect_ring(points(1.5, -2.0), "around it, from behind");

  command("unloadPlugin -force marker");
  expect_none("its plug-in has gone");
  command("loadPlugin \"" PLINIAN_TEST_PLUGINS "/marker.so\"");
  expect_ring(points(1.5, -2.0), "its plug-in is back");
  command("newScene -force");
  EXPECT_TRUE(sitting_->is_running());
  EXPECT_EQ(sitting_->errors(), "");
}

TEST_F(MarkerSitting, AClickOnItSelectsIt) {
  sit_down();
  command("addMarker 1.5");
  command("select -clear");
  const ivec4 place = sitting_->item("picture");
  const ivec2 middle(place.x + place.z / 2, place.y + place.w / 2);
  std::size_t before = sitting_->now();
  sitting_->click({middle.x - int(points(1.5)), middle.y});
  sitting_->wait_for(" still", sitting_->wait_for("ran select marker1", before));
  sitting_->keep("drawing-4-selected.png");
  EXPECT_GT(ring({255, 255, 255}, points(1.5)).first, 200);
  EXPECT_EQ(ring(orange, points(1.5)).first, 0);
  before = sitting_->now();
  sitting_->click(middle);
  sitting_->wait_for("ran select medium_shape", before);
  command("setAttr marker1.radius 0.5");
  before = sitting_->now();
  sitting_->click({middle.x - int(points(0.5)), middle.y});
  const std::size_t chosen = sitting_->wait_for("ran select ", before);
  EXPECT_NE(sitting_->line(chosen).find("select medium_shape"), std::string::npos) << "it is within the ball";
}

// Nothing is drawn again while nothing changes; a picture that moves takes the drawing with it.
TEST_F(MarkerSitting, ItIsDrawnAgainOnlyWhenThereIsSomethingNew) {
  sit_down();
  command("addMarker 1.5");
  command("select -clear");
  const auto drawings = [&] {
    int count = 0;
    for (const std::string& line : sitting_->lines())
      count += line.find(" drawings 1 over picture") != line.npos;
    return count;
  };
  const ivec4 place = sitting_->item("picture");
  const int before = drawings();
  EXPECT_GT(before, 0);
  for (int i = 0; i < 20; ++i) sitting_->move({place.x + 10 + 7 * i, place.y + 20});
  command("ls");
  EXPECT_EQ(drawings(), before) << "the mouse moved, a command was typed";
  // Through a camera of one's own the ring is another ellipse: it is drawn over each picture that comes.
  const std::size_t since = sitting_->now();
  sitting_->key_down("Alt_L");
  sitting_->drag({place.x + 60, place.y + 60}, {place.x + 160, place.y + 60});
  sitting_->key_up("Alt_L");
  wait_for_rest(since);
  sitting_->keep("drawing-5-turned.png");
  // Each drawing is over the picture that was shown last, not over the view that is asked for.
  std::string shown;
  int followed = 0;
  for (std::size_t i = 0; i < sitting_->lines().size(); ++i) {
    const std::string& line = sitting_->lines()[i];
    const auto number = [&](const std::string& words) {
      const std::size_t at = line.find(words) + words.size();
      return line.substr(at, line.find(' ', at) - at);
    };
    if (line.find(" picture ") != line.npos && line.find(" drawings ") == line.npos)
      shown = number(" picture ");
    if (line.find(" drawings 1 over picture ") == line.npos) continue;
    EXPECT_EQ(number(" over picture "), shown) << line;
    followed += i > since;
  }
  EXPECT_GT(followed, 1);
}

}  // namespace
}  // namespace plinian
