#include "host/graph/types/schema.h"

#include "tests/host/graph/message_of.h"

namespace plinian::graph {
namespace {

AttributeSpec number(const std::string& name, std::vector<std::string> affects = {}) {
  return {.name = name, .affects = std::move(affects)};
}
AttributeSpec output(const std::string& name) {
  return {.name = name, .output = true};
}

TEST(Schema, FlattensCompoundsAndKnowsWhoAffectsWhom) {
  const Schema schema({{.name = "key",
                        .type = AttributeType::compound,
                        .array = true,
                        .children = {{.name = "time", .type = AttributeType::time}, {.name = "value"}},
                        .affects = {"out"}},
                       number("other"),
                       output("out")});
  EXPECT_EQ(schema.paths(), (std::vector<std::string>{"key", "key.time", "key.value", "other", "out"}));
  const AttributeIndex time = schema.find("key.time"), out = schema.find("out");
  EXPECT_EQ(schema[time].array, schema.find("key"));
  EXPECT_EQ(schema[time].parent, schema.find("key"));
  EXPECT_EQ(schema[time].affects, std::vector{out});
  EXPECT_EQ(schema[out].affected_by, (std::vector{time, schema.find("key.value")}));
  EXPECT_EQ(schema.leaves(schema.find("key")).size(), 2u);
  EXPECT_FALSE(schema[out].spec.storable);
  EXPECT_EQ(schema.find("nothing"), no_attribute);
}

TEST(Schema, GivesANodeAttributesOfItsOwn) {
  const Schema schema({number("a")});
  const Schema more = schema.with_dynamic(
      {.name = "extra", .type = AttributeType::compound, .children = {number("x"), number("y")}});
  EXPECT_EQ(more.find("extra.y"), 3);
  EXPECT_TRUE(more[3].dynamic);
  EXPECT_EQ(more.without_last_dynamic().paths(), schema.paths());
  EXPECT_EQ(message_of([&] { schema.with_dynamic(number("a")); }), "attribute 'a' is there twice");
}

TEST(Schema, RefusesDeclarationsThatContradictThemselves) {
  const auto message = [](AttributeSpec spec) { return message_of([&] { Schema({spec}); }); };
  EXPECT_EQ(message(number("a b")), "attribute 'a b': a name is a letter or _, then letters, digits and _");
  EXPECT_EQ(message(number("a", {"out"})), "attribute 'a' affects 'out', which is no output");
  EXPECT_EQ(message({.name = "a", .type = AttributeType::choice}), "attribute 'a': an enum needs choices");
  EXPECT_EQ(message({.name = "a", .default_value = 2.0, .maximum = 1.0}),
            "attribute 'a': its default is out of its range");
  EXPECT_EQ(message({.name = "a", .default_value = std::string("x")}),
            "attribute 'a': its default expects a value of type float, not a text");
  EXPECT_EQ(message({.name = "a", .minimum = 2.0, .maximum = 1.0}),
            "attribute 'a': its minimum is above its maximum");
  AttributeSpec inner = number("b");
  inner.array = true;
  EXPECT_EQ(message({.name = "a", .type = AttributeType::compound, .array = true, .children = {inner}}),
            "attribute 'a.b': an array cannot hold arrays");
  EXPECT_NE(message({.name = "a", .type = AttributeType::choice, .choices = {{1, "x", ""}, {1, "y", ""}}})
                .find("twice"),
            std::string::npos);
}

}  // namespace
}  // namespace plinian::graph
