// Controls of a strip in rows, and what goes to its menu.
#include "host/window/panels/strip_rows.h"

#include <gtest/gtest.h>

namespace plinian::window {
namespace {

const std::vector<StripWidth> controls = {{100, 0}, {50, 10}, {60, 10}, {40, 10}};

TEST(StripRows, WhatFitsStandsInOneRow) {
  const StripRows rows = wrap(controls, 280.0f, 2, 20.0f);
  EXPECT_EQ(rows.row, (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(rows.count, 1);
  EXPECT_FALSE(rows.has_menu());
}

TEST(StripRows, APointLessTakesASecondRow) {
  const StripRows rows = wrap(controls, 279.0f, 2, 20.0f);
  EXPECT_EQ(rows.row, (std::vector<int>{0, 0, 0, 1}));
  EXPECT_EQ(rows.count, 2);
}

TEST(StripRows, TheMenuHasItsPlaceInTheLastRow) {
  // 100 | 50 + 10 + 60 would fit, and the menu beside it not.
  const StripRows rows = wrap(controls, 120.0f, 2, 20.0f);
  EXPECT_EQ(rows.row, (std::vector<int>{0, 1, -1, -1}));
  EXPECT_TRUE(rows.has_menu());
  EXPECT_EQ(wrap(controls, 140.0f, 2, 20.0f).row, (std::vector<int>{0, 1, 1, -1}));
}

TEST(StripRows, OrderIsKeptAndNothingIsLostAtAnyWidth) {
  for (float room = 1.0f; room < 300.0f; room += 1.0f) {
    const StripRows rows = wrap(controls, room, 2, 20.0f);
    ASSERT_EQ(rows.row.size(), controls.size());
    float used[2] = {0.0f, 0.0f};
    int last = 0;
    for (std::size_t i = 0; i < controls.size(); ++i) {
      const int row = rows.row[i];
      ASSERT_TRUE(row < 0 || (last >= 0 && row >= last)) << room;
      last = row;
      if (row >= 0) used[row] += controls[i].width + (used[row] > 0.0f ? controls[i].gap : 0.0f);
    }
    if (room < 100.0f) continue;  // narrower than a control is
    EXPECT_LE(used[0], room);
    EXPECT_LE(used[1], room - (rows.has_menu() ? 20.0f : 0.0f)) << room;
  }
}

}  // namespace
}  // namespace plinian::window
