#include "host/graph/model/conversion.h"

#include "tests/host/graph/message_of.h"

namespace plinian::graph {
namespace {

std::string problem(AttributeType from, AttributeType to, bool from_component = false,
                    bool to_component = false) {
  return connection_problem({.name = "a", .type = from, .data_type = "volume"}, from_component,
                            {.name = "b", .type = to, .data_type = "volume"}, to_component);
}

TEST(Conversion, WhatMeansTheSameConnectsAndNothingElse) {
  using enum AttributeType;
  EXPECT_EQ(problem(float1, integer), "");
  EXPECT_EQ(problem(double1, angle), "");
  EXPECT_EQ(problem(float3, colour), "");
  EXPECT_EQ(problem(string, path), "");
  EXPECT_EQ(problem(data, data), "");
  EXPECT_EQ(problem(float3, float1, true), "");
  EXPECT_EQ(problem(float1, colour, false, true), "");
  EXPECT_EQ(problem(distance, angle), "distance cannot drive angle: they measure different things");
  EXPECT_EQ(problem(float1, float3), "float cannot drive float3; a component may be named as .x or .r");
  EXPECT_EQ(problem(string, float1), "string cannot drive float");
  EXPECT_EQ(problem(matrix, float4), "matrix cannot drive float4; a component may be named as .x or .r");
  EXPECT_EQ(problem(compound, compound), "compounds are connected child by child");
  EXPECT_EQ(connection_problem({.name = "a", .type = data, .data_type = "volume"}, false,
                               {.name = "b", .type = data, .data_type = "image"}, false),
            "data of type volume cannot drive data of type image");
}

TEST(Conversion, NumbersRoundClampAndFindTheirChoice) {
  using enum AttributeType;
  EXPECT_EQ(converted(2.6, {.name = "b", .type = integer}), Value(3));
  EXPECT_EQ(converted(0.25f, {.name = "b", .type = boolean}), Value(true));
  EXPECT_EQ(converted(7.0, {.name = "b", .type = float1, .maximum = 2.0}), Value(2.0f));
  const AttributeSpec mode = {.name = "b", .type = choice, .choices = {{0, "off", ""}, {10, "low", ""}}};
  EXPECT_EQ(converted(9.8, mode), Value(10));
  EXPECT_EQ(message_of([&] { converted(5.0, mode); }), "5 is none of off (0), low (10)");
  EXPECT_EQ(component_of(vec3(1.0f, 2.0f, 3.0f), 1), Value(2.0f));
  EXPECT_EQ(with_component(vec2(1.0f, 2.0f), 1, 5.0), Value(vec2(1.0f, 5.0f)));
}

}  // namespace
}  // namespace plinian::graph
