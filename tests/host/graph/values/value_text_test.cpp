#include "host/graph/values/value_text.h"

#include <bit>
#include <cmath>
#include <random>

#include "tests/host/graph/message_of.h"

namespace plinian::graph {
namespace {

const NodeNames names = {[](NodeId id) { return id.value == 7 ? std::string("ash:cloud") : ""; },
                         [](std::string_view name) { return NodeId{name == "ash:cloud" ? 7u : 0u}; }};

AttributeSpec spec_of(AttributeType type) {
  return {.name = "x", .type = type, .choices = {{0, "off", ""}, {10, "low", ""}, {30, "high", ""}}};
}

Value read(AttributeType type, const std::string& text) {
  return read_value(spec_of(type), split_words(text), names);
}

std::string write(AttributeType type, const Value& value) {
  return write_value(spec_of(type), value, names);
}

TEST(ValueText, EachTypeIsSpelledInItsOwnWay) {
  EXPECT_EQ(read(AttributeType::boolean, "on"), Value(true));
  EXPECT_EQ(write(AttributeType::boolean, false), "false");
  EXPECT_EQ(read(AttributeType::integer, "-12"), Value(-12));
  EXPECT_EQ(write(AttributeType::float1, 0.1f), "0.1");
  EXPECT_EQ(write(AttributeType::double1, 0.1), "0.1");
  EXPECT_EQ(write(AttributeType::double1, 1e300), "1e+300");
  EXPECT_EQ(read(AttributeType::choice, "high"), Value(30));
  EXPECT_EQ(read(AttributeType::choice, "10"), Value(10));
  EXPECT_EQ(write(AttributeType::choice, 30), "high");
  EXPECT_EQ(write(AttributeType::path, std::string("$SHOW/a b.vdb")), "\"$SHOW/a b.vdb\"");
  EXPECT_EQ(read(AttributeType::float3, "1 2.5 -3"), Value(vec3(1.0f, 2.5f, -3.0f)));
  EXPECT_EQ(read(AttributeType::float3, "1,2.5,-3"), Value(vec3(1.0f, 2.5f, -3.0f)));
  EXPECT_EQ(read(AttributeType::colour, "0.5"), Value(vec3(0.5f)));
  EXPECT_EQ(write(AttributeType::colour, vec3(1.0f, 0.5f, 0.0f)), "1 0.5 0");
  EXPECT_EQ(read(AttributeType::distance, "35mm"), Value(35 * 0.001));
  EXPECT_EQ(read(AttributeType::distance, "2km"), Value(2000.0));
  EXPECT_EQ(read(AttributeType::time, "24f"), Value(24.0));
  EXPECT_NEAR(std::get<double>(read(AttributeType::angle, "3.14159265358979rad")), 180.0, 1e-10);
  EXPECT_EQ(read(AttributeType::node, "ash:cloud"), Value(NodeId{7}));
  EXPECT_EQ(write(AttributeType::node, NodeId{7}), "ash:cloud");
  EXPECT_EQ(write(AttributeType::node, NodeId{8}), "none");
  EXPECT_EQ(read(AttributeType::node, "none"), Value(NodeId()));
  const Value ramp = read(AttributeType::ramp, "0:0.5:linear 1:1,0.25,0:smooth");
  EXPECT_EQ((*std::get<Boxed<Ramp>>(ramp)).points.at(1).value, vec3(1.0f, 0.25f, 0.0f));
  EXPECT_EQ(write(AttributeType::ramp, ramp), "0:0.5:linear 1:1,0.25,0:smooth");
  const Value matrix = read(AttributeType::matrix, "1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1");
  EXPECT_EQ((*std::get<Boxed<dmat4>>(matrix))[3], dvec4(5.0, 6.0, 7.0, 1.0));
  EXPECT_EQ(write(AttributeType::matrix, matrix), "1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1");
}

TEST(ValueText, NumbersComeBackToTheBit) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    const auto d = std::bit_cast<double>(random());
    const auto f = std::bit_cast<float>(std::uint32_t(random()));
    if (std::isfinite(d)) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(
                    std::get<double>(read(AttributeType::double1, write(AttributeType::double1, d)))),
                std::bit_cast<std::uint64_t>(d));
    }
    if (std::isfinite(f)) {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(
                    std::get<float>(read(AttributeType::float1, write(AttributeType::float1, f)))),
                std::bit_cast<std::uint32_t>(f));
    }
  }
}

TEST(ValueText, SaysWhatItExpectsAndWhatItGot) {
  EXPECT_EQ(message_of([] { read(AttributeType::float1, "soft"); }), "expects a number, not 'soft'");
  EXPECT_EQ(message_of([] { read(AttributeType::float1, "nan"); }), "expects a number, not 'nan'");
  EXPECT_EQ(message_of([] { read(AttributeType::float1, "1 2"); }), "expects a number, not '1 2'");
  EXPECT_EQ(message_of([] { read(AttributeType::float3, "1 2"); }), "expects 3 numbers, not '1 2'");
  EXPECT_EQ(message_of([] { read(AttributeType::integer, "1.5"); }), "expects an integer, not '1.5'");
  EXPECT_EQ(message_of([] { read(AttributeType::choice, "hihg"); }),
            "'hihg' is none of off (0), low (10), high (30) (did you mean 'high'?)");
  EXPECT_EQ(message_of([] { read(AttributeType::choice, "20"); }),
            "'20' is none of off (0), low (10), high (30)");
  EXPECT_EQ(message_of([] { read(AttributeType::node, "gone"); }),
            "expects a node or none, and there is no node 'gone'");
  EXPECT_NE(message_of([] { read(AttributeType::ramp, "1:1:linear 0:1:linear"); }).find("ascending"),
            std::string::npos);
  EXPECT_NE(message_of([] { read(AttributeType::double1, "1e999"); }).find("expects a number"),
            std::string::npos);
}

TEST(ValueText, ARangeSaysWhichEndsAreOpenAndANumberWhichUnitsItTakes) {
  const auto range = [](std::optional<double> low, std::optional<double> high) {
    return expectation({.name = "x", .type = AttributeType::float1, .minimum = low, .maximum = high});
  };
  const double above_0 = std::nextafter(0.0f, 1.0f), below_180 = std::nextafter(180.0f, 0.0f);
  EXPECT_EQ(range(above_0, {}), "a number above 0");
  EXPECT_EQ(range(above_0, below_180), "a number above 0 and below 180");
  EXPECT_EQ(range(0.0, below_180), "a number >= 0 and below 180");
  EXPECT_EQ(range(std::nextafter(-1.0f, 0.0f), 1.0), "a number above -1 and <= 1");
  EXPECT_EQ(range(0.1, 0.75), "a number from 0.1 to 0.75");
  EXPECT_EQ(range({}, 1e-30), "a number <= 1e-30");
  EXPECT_EQ(message_of([] { read(AttributeType::distance, "3 miles"); }),
            "expects a number, or one with a unit (km, cm, mm, in, ft, m), not '3 miles'");
  EXPECT_EQ(message_of([] { read(AttributeType::angle, "1turn"); }),
            "expects a number, or one with a unit (deg, rad), not '1turn'");
}

TEST(ValueText, AnAttributeClampsWhatIsOutOfItsHardRangeAndRefusesOtherKinds) {
  const AttributeSpec spec = {.name = "x", .type = AttributeType::float1, .minimum = 0.0, .maximum = 1.0};
  bool clamped = false;
  EXPECT_EQ(fitted(spec, 0.5, &clamped), Value(0.5f));
  EXPECT_FALSE(clamped);
  EXPECT_EQ(fitted(spec, 7, &clamped), Value(1.0f));
  EXPECT_TRUE(clamped);
  EXPECT_EQ(message_of([&] { fitted(spec, std::string("a")); }), "expects a value of type float, not a text");
  EXPECT_EQ(message_of([&] { fitted(spec, NAN); }), "expects a finite number");
  EXPECT_EQ(message_of([&] { fitted(spec_of(AttributeType::choice), 11); }),
            "11 is none of off (0), low (10), high (30)");
  EXPECT_EQ(message_of([&] { fitted(spec_of(AttributeType::integer), 1.5); }), "expects an integer");
}

}  // namespace
}  // namespace plinian::graph
