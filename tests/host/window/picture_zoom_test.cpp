// The picture under a magnifying glass: what stays where, how far it goes, and where it is in the pane.
#include "host/window/navigation/picture_zoom.h"

#include <gtest/gtest.h>

#include "host/window/compare/wipe.h"
#include "host/window/panels/picture_places.h"

namespace plinian::window {
namespace {

const PaneRect whole{{100.0f, 50.0f}, {640.0f, 360.0f}};

// Of the picture's sides.
vec2 seen_at(const PictureZoom& zoom, vec2 at, const PaneRect& place = whole) {
  const PaneRect picture = zoom.magnified(place);
  return (at - picture.begin) / picture.size;
}

void expect_same(vec2 a, vec2 b, float tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(PictureZoom, ItGoesInStepsFromTheWholePictureTo32) {
  PictureZoom zoom;
  EXPECT_FALSE(zoom.is_on());
  EXPECT_EQ(zoom.magnified(whole).begin, whole.begin);
  EXPECT_EQ(zoom.magnified(whole).size, whole.size);
  zoom.step(1, {200.0f, 100.0f}, whole);
  EXPECT_NEAR(zoom.factor(), 1.41421356f, 1e-6f);
  zoom.step(2, {200.0f, 100.0f}, whole);
  zoom.step(1, {200.0f, 100.0f}, whole);
  EXPECT_EQ(zoom.factor(), 4.0f);
  EXPECT_EQ(zoom.magnified(whole).size, whole.size * 4.0f);
  zoom.step(100, {200.0f, 100.0f}, whole);
  EXPECT_EQ(zoom.factor(), 32.0f);
  zoom.step(-100, {739.0f, 51.0f}, whole);
  EXPECT_FALSE(zoom.is_on());
  EXPECT_EQ(zoom.magnified(whole).begin, whole.begin);
}

// From wherever one is.
TEST(PictureZoom, WhatIsUnderThePointerStaysThereOnTheWayIn) {
  for (const vec2 pan : {vec2(0.0f), vec2(900.0f, -700.0f), vec2(-90.0f, 40.0f)})
    for (const vec2 at :
         {vec2(100.0f, 50.0f), vec2(739.0f, 409.0f), vec2(420.0f, 230.0f), vec2(500.0f, 60.0f)}) {
      PictureZoom zoom;
      zoom.step(2, {300.0f, 200.0f}, whole);
      zoom.pan(zoom.centre(), pan, whole);
      const vec2 seen = seen_at(zoom, at);
      if (seen.x < 0.0f || seen.y < 0.0f || seen.x > 1.0f || seen.y > 1.0f) continue;
      for (int i = 0; i < 8; ++i) {
        zoom.step(1, at, whole);
        expect_same(seen_at(zoom, at), seen, 1e-5f);
      }
    }
  // ... and on the way out, within the picture.
  PictureZoom zoom;
  const vec2 at(350.0f, 190.0f), seen = seen_at(zoom, at);
  zoom.step(10, at, whole);
  zoom.step(-6, at, whole);
  expect_same(seen_at(zoom, at), seen, 1e-5f);
}

TEST(PictureZoom, AHandTakesThePictureWithItAsFarAsThatReaches) {
  PictureZoom zoom;
  zoom.pan(zoom.centre(), {50.0f, 20.0f}, whole);
  EXPECT_EQ(zoom.magnified(whole).begin, whole.begin) << "all of it is seen";
  zoom.step(6, {420.0f, 230.0f}, whole);
  const vec2 from(420.0f, 230.0f), seen = seen_at(zoom, from);
  zoom.pan(zoom.centre(), {-37.0f, 11.0f}, whole);
  expect_same(seen_at(zoom, from + vec2(-37.0f, 11.0f)), seen, 1e-5f);
  // Any pixel of an edge comes into the pane, but not past its middle.
  zoom.pan(zoom.centre(), {1e6f, 1e6f}, whole);
  const PaneRect picture = zoom.magnified(whole);
  EXPECT_GT(picture.begin.x, whole.begin.x);
  EXPECT_LE(picture.begin.x, whole.begin.x + 0.5f * whole.size.x);
  EXPECT_GT(picture.begin.y, whole.begin.y);
  EXPECT_LE(picture.begin.y, whole.begin.y + 0.5f * whole.size.y);
}

TEST(PictureZoom, AnotherPaneKeepsWhatIsInItsMiddle) {
  PictureZoom zoom;
  zoom.step(6, {180.0f, 300.0f}, whole);
  const vec2 seen = seen_at(zoom, {420.0f, 230.0f});
  const PaneRect other{{10.0f, 20.0f}, {320.0f, 180.0f}};
  expect_same(seen_at(zoom, other.begin + 0.5f * other.size, other), seen, 1e-6f);
}

TEST(PicturePlaces, SideBySideBothAreMagnifiedAlikeEachInItsHalf) {
  PictureZoom zoom;
  const PaneRect pane{{233.0f, 60.0f}, {804.0f, 500.0f}};
  const PicturePlaces one = picture_places(pane, {804.0f, 500.0f}, 804, false, 4.0f, zoom, 1.0f);
  EXPECT_EQ(one.picture.size, pane.size);
  EXPECT_EQ(one.room.size, pane.size);
  EXPECT_FALSE(one.is_over_other({1000.0f, 300.0f}));
  zoom.step(5, {300.0f, 200.0f}, one.whole);
  const PicturePlaces two = picture_places(pane, {804.0f, 500.0f}, 804, true, 4.0f, zoom, 1.0f);
  EXPECT_EQ(two.room.size.x, 400.0f);
  EXPECT_EQ(two.whole.size.x, 400.0f);
  EXPECT_EQ(two.other_room.begin.x, pane.begin.x + 404.0f);
  EXPECT_EQ(two.other.begin - two.other_room.begin, two.picture.begin - two.room.begin);
  EXPECT_EQ(two.other.size, two.picture.size);
  const vec2 at = two.other_room.begin + vec2(17.0f, 90.0f);
  EXPECT_TRUE(two.is_over_other(at));
  EXPECT_EQ(at + two.way_to_picture(at), two.room.begin + vec2(17.0f, 90.0f));
  EXPECT_EQ(two.way_to_picture(two.room.begin + vec2(17.0f, 90.0f)), vec2(0.0f));
}

// Not how far the picture is from its fitted size: side by side it is shrunk to begin with.
TEST(PicturePlaces, PixelsAreSquaresOnceTheyAreFourOfTheScreen) {
  struct Case {
    int pixels;  // of the picture, in a pane of 640 points
    bool side_by_side;
    float ratio;
    int steps;
    float side;
    bool squares;
  };
  for (const Case& c : {Case{640, false, 1.0f, 0, 1.0f, false}, Case{640, false, 1.0f, 3, 2.83f, false},
                        Case{640, false, 1.0f, 4, 4.0f, true}, Case{640, true, 1.0f, 4, 1.99f, false},
                        Case{640, true, 1.0f, 6, 3.975f, true}, Case{1280, false, 2.0f, 4, 4.0f, true},
                        Case{160, false, 1.0f, 0, 4.0f, false}, Case{160, false, 1.0f, 1, 5.66f, true}}) {
    PictureZoom zoom;
    zoom.step(c.steps, {300.0f, 200.0f}, whole);
    const PicturePlaces places =
        picture_places(whole, whole.size, c.pixels, c.side_by_side, 4.0f, zoom, c.ratio);
    EXPECT_NEAR(places.pixel_side, c.side, 0.01f) << c.pixels << " " << c.steps;
    EXPECT_EQ(places.shows_squares, c.squares) << c.pixels << " " << c.steps;
    EXPECT_EQ(places.is_magnified, c.steps > 0);
  }
}

// Else squares would be of different sizes.
TEST(PicturePlaces, MagnifiedPicturesBeginAtPixelsOfTheScreen) {
  PictureZoom zoom;
  zoom.step(4, {317.3f, 211.9f}, whole);
  for (const float ratio : {1.0f, 2.0f}) {
    const vec2 begin = picture_places(whole, whole.size, 640, false, 4.0f, zoom, ratio).picture.begin * ratio;
    expect_same(begin, glm::round(begin), 1e-3f);
  }
}

TEST(Wipe, ItsLineComesAlongWhereItWouldLeaveWhatIsSeen) {
  const vec2 begin(-500.0f, -300.0f), size(2000.0f, 1000.0f), part(100.0f, 50.0f), room(400.0f, 200.0f);
  Wipe wipe;
  wipe.at = {0.35f, 0.9f};  // at 200, 600: its upright line crosses the part
  wipe.keep_within(part, room, begin, size);
  EXPECT_NEAR((begin + wipe.at * size).x, 200.0f, 0.1f) << "the line itself stays";
  EXPECT_NEAR((begin + wipe.at * size).y, 150.0f, 0.1f);
  wipe.at = {0.9f, 0.5f};
  wipe.keep_within(part, room, begin, size);
  EXPECT_NEAR((begin + wipe.at * size).x, 500.0f, 0.1f) << "at the part's edge";
  const vec2 at = wipe.at;
  wipe.keep_within(part, room, begin, size);
  EXPECT_EQ(wipe.at, at);
}

}  // namespace
}  // namespace plinian::window
