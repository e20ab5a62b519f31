// How wide tiles get.
#include "viewport/passes/tile_pace.h"

#include <gtest/gtest.h>

namespace plinian::passes {
namespace {

int columns_at(double ms_per_column, TilePace& pace) {
  for (int i = 0; i < 12; ++i) pace.took(pace.columns(), ms_per_column * pace.columns());
  return pace.columns();
}

TEST(TilePace, TilesAreAsWideAsTheTimeAllows) {
  TilePace pace;
  EXPECT_EQ(columns_at(0.01, pace), TilePace::most_groups);
  const int some = columns_at(5.0, pace);
  EXPECT_LE(5.0 * some, 40.0);
  EXPECT_GE(5.0 * some, 20.0);
  EXPECT_EQ(columns_at(500.0, pace), 1) << "never none";
  EXPECT_EQ(columns_at(0.01, pace), TilePace::most_groups) << "what was slow once may be fast later";
}

TEST(TilePace, OneCheapTileDoesNotMakeADearOne) {
  TilePace pace;
  columns_at(30.0, pace);
  EXPECT_EQ(pace.columns(), 1);
  pace.took(1, 0.1);  // all sky
  EXPECT_EQ(pace.columns(), 2);
}

}  // namespace
}  // namespace plinian::passes
