#include "host/graph/types/type_registry.h"

#include "tests/host/graph/message_of.h"

namespace plinian::graph {
namespace {

TEST(TypeRegistry, FindsTypesAndNamesTheNearestForAMistypedOne) {
  TypeRegistry registry;
  registry.add({.name = "transform", .attributes = {{.name = "visibility", .type = AttributeType::boolean}}});
  EXPECT_NE(registry.find("transform"), nullptr);
  EXPECT_EQ(registry.find("camera"), nullptr);
  EXPECT_EQ(message_of([&] { registry.get("trasform"); }),
            "unknown node type 'trasform' (did you mean 'transform'?)");
  EXPECT_EQ(message_of([&] { registry.add({.name = "transform", .plugin = "other"}); }),
            "node type 'transform' is already registered");
  registry.remove("transform");
  EXPECT_EQ(registry.find("transform"), nullptr);
}

TEST(TypeRegistry, RefusesTypesThatContradictThemselves) {
  TypeRegistry registry;
  EXPECT_EQ(message_of([&] { registry.add({.name = "n", .attributes = {{.name = "o", .output = true}}}); }),
            "node type 'n': has outputs but computes nothing");
  EXPECT_EQ(message_of([&] {
              registry.add({.name = "n", .aliases = {{"old", "gone"}}});
            }),
            "node type 'n': the alias 'old' names no attribute");
  EXPECT_EQ(message_of([&] {
              registry.add({.name = "n", .version = 2, .migrators = {{2, nullptr}}});
            }),
            "node type 'n': a migrator must lead from an older version");
  const auto shown_when = [&](const std::string& other, const std::vector<std::string>& words) {
    return message_of([&] {
      registry.add({.name = "n",
                    .attributes = {{.name = "size", .layout = {.shown_when = other, .shown_words = words}},
                                   {.name = "mode",
                                    .type = AttributeType::choice,
                                    .choices = {{0, "off", ""}, {1, "high", ""}}}}});
    });
  };
  EXPECT_EQ(
      shown_when("mod", {"high"}),
      "node type 'n': attribute 'size' is shown when 'mod' reads so, which is no attribute (did you mean "
      "'mode'?)");
  EXPECT_EQ(
      shown_when("mode", {"high", "hihg"}),
      "node type 'n': attribute 'size' is shown when 'mode' reads 'hihg', which it never does (did you mean "
      "'high'?)");
  EXPECT_TRUE(registry.names().empty());
}

TEST(TypeRegistry, AnAliasStandsForAnAttributeAndAllInIt) {
  const NodeType type(
      {.name = "n", .attributes = {{.name = "weights", .array = true}}, .aliases = {{"w", "weights"}}});
  EXPECT_EQ(type.current_path("w"), "weights");
  EXPECT_EQ(type.current_path("w[3]"), "weights[3]");
  EXPECT_EQ(type.current_path("wide"), "wide");
}

}  // namespace
}  // namespace plinian::graph
