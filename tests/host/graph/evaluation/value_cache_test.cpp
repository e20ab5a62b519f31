#include "host/graph/evaluation/value_cache.h"

#include <gtest/gtest.h>

namespace plinian::graph {
namespace {

ValueCache::Entry entry(std::size_t bytes, std::uint64_t identity) {
  Result result;
  result.value = std::make_shared<const Data>(Data{"blob", nullptr, bytes, identity});
  result.identity = {identity, identity};
  return {std::make_shared<const Result>(std::move(result)), {}};
}

TEST(ValueCache, LetsGoOfTheValueUsedLongestAgoButRemembersWhatItWas) {
  ValueCache cache(2500);
  for (std::uint64_t i = 1; i <= 3; ++i) cache.insert({i, 0}, entry(700, i));
  EXPECT_LE(cache.bytes(), 2500u);
  EXPECT_TRUE(cache.find({1, 0})->result->has_value);
  cache.insert({4, 0}, entry(700, 4));  // 2 is the oldest by use
  EXPECT_FALSE(cache.find({2, 0})->result->has_value);
  EXPECT_EQ(cache.find({2, 0})->result->identity, (Hash{2, 2}));
  EXPECT_TRUE(cache.find({1, 0})->result->has_value);
  cache.insert({2, 0}, entry(700, 2));
  EXPECT_TRUE(cache.find({2, 0})->result->has_value);
  EXPECT_LE(cache.bytes(), 2500u);
  EXPECT_FALSE(cache.find({9, 0}));
  cache.set_budget(0);
  EXPECT_EQ(cache.bytes(), 0u);
  EXPECT_FALSE(cache.find({1, 0})->result->has_value);
  cache.clear();
  EXPECT_FALSE(cache.find({1, 0}));
}

TEST(ValueCache, KeepsItsBooksOverManyInsertions) {
  ValueCache cache(10'000);
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    cache.insert({i % 97, 0}, entry((i * 7919) % 900, i));
    EXPECT_LE(cache.bytes(), 10'000u);
  }
  cache.set_budget(1 << 20);
  cache.set_budget(0);
  EXPECT_EQ(cache.bytes(), 0u);
}

}  // namespace
}  // namespace plinian::graph
