#include "core/scene/nearest_word.h"

#include <gtest/gtest.h>

namespace plinian {
namespace {

TEST(NearestWord, CountsEditsAndTakesASwapOfNeighboursForOne) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("redner", "render"), 1);
  EXPECT_EQ(edit_distance("same", "same"), 0);
}

TEST(NearestWord, FindsWhatWasMeantAndNothingForNonsense) {
  const std::vector<std::string> words = {"render", "compare", "bench", "info", "make"};
  EXPECT_EQ(nearest_word("rendr", words), "render");
  EXPECT_EQ(nearest_word("COMPARE", words), "compare");
  EXPECT_EQ(nearest_word("comp", words), "compare");  // its beginning
  EXPECT_EQ(nearest_word("zebra", words), std::nullopt);
  EXPECT_EQ(nearest_word("", words), std::nullopt);
  EXPECT_EQ(did_you_mean("mkae", words), " (did you mean 'make'?)");
  EXPECT_EQ(did_you_mean("zebra", words), "");
}

}  // namespace
}  // namespace plinian
