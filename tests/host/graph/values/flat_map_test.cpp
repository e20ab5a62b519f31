#include "host/graph/values/flat_map.h"

#include <gtest/gtest.h>

#include <random>
#include <unordered_map>

#include "host/graph/values/hash.h"

namespace plinian::graph {
namespace {

// A key whose hash is bad: most of them meet.
struct Bad {
  int value = 0;
  bool operator==(const Bad&) const = default;
};

}  // namespace
}  // namespace plinian::graph

template <>
struct std::hash<plinian::graph::Bad> {
  std::size_t operator()(const plinian::graph::Bad& key) const noexcept { return std::size_t(key.value % 7); }
};

namespace plinian::graph {
namespace {

template <class Key>
void agrees_with_the_standard(int range) {
  FlatMap<Key, int> map;
  std::unordered_map<int, int> truth;
  std::mt19937 random(11);
  for (int step = 0; step < 20'000; ++step) {
    const int key = int(random() % std::uint32_t(range));
    if (random() % 3 == 0) {
      map.erase(Key{key});
      truth.erase(key);
    } else {
      const auto [value, fresh] = map.emplace(Key{key});
      EXPECT_EQ(fresh, !truth.contains(key));
      *value = truth[key] = step;
    }
    ASSERT_EQ(map.size(), truth.size());
  }
  std::size_t seen = 0;
  for (const auto& [key, value] : map) {
    EXPECT_EQ(truth.at(key.value), value);
    ++seen;
  }
  EXPECT_EQ(seen, truth.size());
  for (int key = 0; key < range; ++key) {
    EXPECT_EQ(map.contains(Key{key}), truth.contains(key));
    if (const auto found = truth.find(key); found != truth.end()) {
      EXPECT_EQ(map.at(Key{key}), found->second);
    }
  }
  map.clear();
  EXPECT_EQ(map.size(), 0u);
  EXPECT_FALSE(map.contains(Key{1}));
}

struct Good {
  int value = 0;
  bool operator==(const Good&) const = default;
};

}  // namespace
}  // namespace plinian::graph

template <>
struct std::hash<plinian::graph::Good> {
  std::size_t operator()(const plinian::graph::Good& key) const noexcept { return std::size_t(key.value); }
};

namespace plinian::graph {
namespace {

TEST(FlatMap, AgreesWithTheStandardsTableWhateverComesAndGoes) {
  agrees_with_the_standard<Good>(3000);
}

TEST(FlatMap, DoesSoEvenWhereAlmostAllKeysMeet) {
  agrees_with_the_standard<Bad>(200);
}

TEST(FlatMap, FindsKeysThatAreStringsByAnyText) {
  FlatMap<std::string, int> map;
  for (int i = 0; i < 1000; ++i) map["a rather long name " + std::to_string(i)] = i;
  const std::string_view all = "a rather long name 17 and more";
  EXPECT_EQ(*map.find(all.substr(0, 21)), 17);
  EXPECT_EQ(*map.find("a rather long name 999"), 999);
  EXPECT_FALSE(map.contains(all));
  map.erase("a rather long name 17");
  EXPECT_EQ(map.find(all.substr(0, 21)), nullptr);
}

TEST(FlatMap, KeepsTheOrderInWhichEntriesCame) {
  FlatMap<Good, int> map;
  for (int i = 0; i < 1000; ++i) map[Good{i * 37 % 1009}] = i;
  int next = 0;
  for (const auto& [key, value] : map) EXPECT_EQ(value, next++);
}

}  // namespace
}  // namespace plinian::graph
