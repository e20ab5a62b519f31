// Where the probe's card lies: beside the pixel, and where it hides little.
#include "host/window/panels/probe_place.h"

#include <gtest/gtest.h>

namespace plinian::window {
namespace {

constexpr float reach = 26.0f;

float nothing(vec2) {
  return 0.0f;
}

// As in a window of 1000 x 700, in one of 1600 x 1000, and hardly any.
const PaneRect rooms[] = {{{243.0f, 110.0f}, {392.0f, 328.0f}},
                          {{243.0f, 84.0f}, {993.0f, 654.0f}},
                          {{10.0f, 60.0f}, {260.0f, 190.0f}}};

TEST(ProbePlace, NoPixelIsEverCovered) {
  for (const PaneRect& room : rooms) {
    const std::vector<ProbeCard> cards = probe_cards(room, 1.0f);
    ASSERT_FALSE(cards.empty());
    for (const ProbeCard& card : cards) {
      const PaneRect inside = common(card.place, room);
      EXPECT_NEAR(inside.size.x, card.place.size.x, 1e-3f);
      EXPECT_NEAR(inside.size.y, card.place.size.y, 1e-3f);
    }
    for (float x = 0.0f; x <= 1.0f; x += 0.05f)
      for (float y = 0.0f; y <= 1.0f; y += 0.05f) {
        const vec2 pixel = room.begin + room.size * vec2(x, y);
        const ProbeCard& card = cards[least_hiding(cards, pixel, reach, nothing, std::nullopt)];
        EXPECT_TRUE(leaves_free(card.place, pixel, room.size.y > 300.0f ? reach : 0.0f)) << x << " " << y;
      }
  }
}

// Over a small one it would hide what it is about, whichever edge it lies at.
TEST(ProbePlace, UnderALowOrNarrowPictureItLiesBeneath) {
  const PaneRect bottom{{233.0f, 515.0f}, {412.0f, 161.0f}};
  const auto beneath = [&](vec2 pane, float scale = 1.0f) {
    return is_better_beneath({{233.0f, 75.0f}, pane}, bottom, scale);
  };
  EXPECT_TRUE(beneath({412.0f, 397.0f})) << "in a window of 1000 x 700";
  EXPECT_TRUE(beneath({1100.0f, 420.0f})) << "a low one";
  EXPECT_FALSE(beneath({854.0f, 622.0f})) << "in one of 1440 x 900";
  EXPECT_FALSE(is_better_beneath({{0.0f, 22.0f}, {412.0f, 397.0f}}, {}, 1.0f)) << "there is no pane for it";
  EXPECT_FALSE(is_better_beneath({{0.0f, 22.0f}, {412.0f, 397.0f}}, {{0.0f, 500.0f}, {412.0f, 60.0f}}, 1.0f));
  EXPECT_TRUE(is_better_beneath({{0.0f, 22.0f}, {824.0f, 794.0f}}, {{0.0f, 900.0f}, {824.0f, 322.0f}}, 2.0f));
}

TEST(ProbePlace, ItLiesWhereThereIsNoSmoke) {
  const PaneRect& room = rooms[1];
  const std::vector<ProbeCard> cards = probe_cards(room, 1.0f);
  const vec2 middle = room.begin + 0.5f * room.size;
  for (const vec2 clear : {vec2(1, 1), vec2(-1, 1), vec2(1, -1), vec2(-1, -1)}) {
    // Smoke everywhere but in one quarter.
    const auto smoke = [&](vec2 at) {
      return glm::min(clear.x * (at.x - middle.x), clear.y * (at.y - middle.y)) > 0.0f ? 0.0f : 1.0f;
    };
    const ProbeCard& card = cards[least_hiding(cards, middle, reach, smoke, std::nullopt)];
    const vec2 away = card.place.begin + 0.5f * card.place.size - middle;
    EXPECT_GT(clear.x * away.x, 0.0f);
    EXPECT_GT(clear.y * away.y, 0.0f);
  }
}

TEST(ProbePlace, ItStaysWhereAnotherPlaceIsHardlyBetter) {
  const PaneRect& room = rooms[1];
  const std::vector<ProbeCard> cards = probe_cards(room, 1.0f);
  const vec2 middle = room.begin + 0.5f * room.size;
  const auto smoke = [&](vec2 at) { return at.x > middle.x ? 0.55f : 0.5f; };
  const std::size_t free = least_hiding(cards, middle, reach, smoke, std::nullopt);
  for (std::size_t now = 0; now < 4; ++now)
    EXPECT_EQ(least_hiding(cards, middle, reach, smoke, now), now) << "and not " << free;
  // A pixel beneath it has it go.
  const vec2 pixel = cards[0].place.begin + 0.5f * cards[0].place.size;
  EXPECT_NE(least_hiding(cards, pixel, reach, smoke, 0), 0u);
}

}  // namespace
}  // namespace plinian::window
