// Number fields: arithmetic, and what a drag makes of a value.
#include <gtest/gtest.h>

#include "host/window/fields/arithmetic.h"
#include "host/window/fields/number_drag.h"

namespace plinian::window {
namespace {

TEST(Arithmetic, CountsAsOneWouldOnPaper) {
  const std::pair<const char*, double> truths[] = {
      {"3", 3.0},    {" 2 + 3 * 4 ", 14.0}, {"(2+3)*4", 20.0}, {"-5", -5.0},      {"1e3/4", 250.0},
      {"2--3", 5.0}, {".5", 0.5},           {"10/4/5", 0.5},   {"-(1-3)*2", 4.0}, {"+7", 7.0}};
  for (const auto& [text, value] : truths) {
    const auto typed = typed_number(text, 100.0);
    ASSERT_TRUE(typed) << text;
    EXPECT_DOUBLE_EQ(*typed, value) << text;
  }
}

TEST(Arithmetic, ChangesTheValueThatWasThere) {
  EXPECT_DOUBLE_EQ(*typed_number("*2", 3.0), 6.0);
  EXPECT_DOUBLE_EQ(*typed_number("/4", 3.0), 0.75);
  EXPECT_DOUBLE_EQ(*typed_number("+=1/2", 3.0), 3.5);
  EXPECT_DOUBLE_EQ(*typed_number("-=5", 3.0), -2.0);
  EXPECT_DOUBLE_EQ(*typed_number(" *= 2+1", 3.0), 9.0);
}

TEST(Arithmetic, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"", " ", "abc", "1+", "(1", "1)", "1/0", "2 3", "=3", "*=", "35mm", "1e999", "0/0", "nan"})
    EXPECT_FALSE(typed_number(text, 1.0)) << text;
  EXPECT_FALSE(typed_number(std::string(100000, '('), 1.0)) << "however deep";
}

NumberRange slider(double low, double high) {
  NumberRange range;
  range.soft_minimum = low;
  range.soft_maximum = high;
  return range;
}

TEST(NumberDrag, CrossesTheSoftRangeInThreeHundredPoints) {
  EXPECT_NEAR(dragged(slider(0.0, 3.0), 0.0, 300.0, DragPace::usual), 3.0, 1e-9);
  EXPECT_NEAR(dragged(slider(0.0, 3.0), 0.0, 100.0, DragPace::usual), 1.0, 1e-9);
  EXPECT_NEAR(dragged(slider(0.0, 3.0), 1.0, 100.0, DragPace::fine), 1.1, 1e-9);
  EXPECT_NEAR(dragged(slider(0.0, 30.0), 10.0, 10.0, DragPace::coarse), 20.0, 1e-9);
}

TEST(NumberDrag, StaysInTheSoftRangeUnlessItBeganOutside) {
  EXPECT_EQ(dragged(slider(0.0, 3.0), 2.0, 1e6, DragPace::usual), 3.0);
  EXPECT_NEAR(dragged(slider(0.0, 3.0), 5.0, 100.0, DragPace::usual), 10.0, 1e-9);
  NumberRange hard = slider(0.0, 3.0);
  hard.maximum = 5.5;
  EXPECT_EQ(dragged(hard, 5.0, 100.0, DragPace::usual), 5.5);
}

TEST(NumberDrag, GoesRoundWhereItsEndsAreOnePlace) {
  NumberRange angle = slider(-180.0, 180.0);
  angle.wraps = true;
  EXPECT_NEAR(dragged(angle, 170.0, 25.0, DragPace::usual), -160.0, 1e-9);
  EXPECT_NEAR(dragged(angle, -170.0, -25.0, DragPace::usual), 160.0, 1e-9);
  EXPECT_NEAR(wrapped(angle, 270.0), -90.0, 1e-9);
  EXPECT_NEAR(wrapped(angle, -900.0), -180.0, 1e-9);
}

TEST(NumberDrag, WithoutARangeGoesByTheValueItself) {
  EXPECT_NEAR(dragged({}, 50.0, 100.0, DragPace::usual), 100.0, 1e-9);
  EXPECT_NEAR(dragged({}, 0.0, -100.0, DragPace::usual), -1.0, 1e-9);
}

// Of a density, twice as much is as far from once as once from half, however dense it is.
TEST(NumberDrag, MultipliesAFactor) {
  NumberRange factor = slider(0.01, 1000.0);
  factor.factor = true;
  for (const double start : {0.05, 1.0, 31.0}) {
    EXPECT_NEAR(dragged(factor, start, 75.0, DragPace::usual), 2.0 * start, 1e-9) << start;
    EXPECT_NEAR(dragged(factor, start, -150.0, DragPace::usual), 0.25 * start, 0.01 * start) << start;
    EXPECT_NEAR(dragged(factor, start, 750.0, DragPace::fine), 2.0 * start, 1e-9) << start;
  }
  EXPECT_EQ(shown_number(dragged(factor, 12.3456789, 10.0, DragPace::usual)), "13.5") << "round";
  EXPECT_EQ(dragged(factor, 10.0, 1e6, DragPace::usual), 1000.0);
  EXPECT_NEAR(dragged(factor, 2000.0, 75.0, DragPace::usual), 4000.0, 1e-9) << "it began outside";
  EXPECT_NEAR(dragged(factor, 0.0, 75.0, DragPace::usual), 0.02, 1e-9) << "nothing times two is nothing";
  factor.maximum = 20.0;
  EXPECT_EQ(dragged(factor, 15.0, 75.0, DragPace::usual), 20.0);
}

TEST(NumberDrag, ShowsHowFarAFactorIsByItsPowers) {
  NumberRange factor = slider(0.01, 100.0);
  EXPECT_NEAR(*share_of(factor, 50.005), 0.5, 1e-6);
  factor.factor = true;
  EXPECT_NEAR(*share_of(factor, 1.0), 0.5, 1e-6);
  EXPECT_EQ(*share_of(factor, 0.0), 0.0f);
  EXPECT_EQ(*share_of(factor, 1e6), 1.0f);
  EXPECT_FALSE(share_of({}, 1.0));
}

TEST(NumberDrag, LandsOnRoundNumbers) {
  EXPECT_EQ(shown_number(dragged(slider(0.0, 1.0), 0.123456789, 100.0, DragPace::usual)), "0.457");
  NumberRange whole;
  whole.whole = true;
  EXPECT_EQ(dragged(whole, 3.0, 14.0, DragPace::usual), 4.0);
}

TEST(NumberDrag, GoesInTheStepsOfItsAttribute) {
  NumberRange thirds = slider(0.0, 3.0);
  thirds.step = 0.3;
  EXPECT_NEAR(dragged(thirds, 0.0, 100.0, DragPace::usual), 0.9, 1e-9);
  EXPECT_NEAR(dragged(thirds, 0.9, 10.0, DragPace::usual), 0.9, 1e-9);
  EXPECT_NEAR(dragged(thirds, 0.9, 20.0, DragPace::usual), 1.2, 1e-9);
  EXPECT_EQ(dragged(thirds, 0.9, 1e4, DragPace::usual), 3.0);
}

TEST(NumberDrag, ShowsNoMoreDigitsThanItNeeds) {
  EXPECT_EQ(shown_number(0.1f), "0.1");
  EXPECT_EQ(shown_number(-0.0), "0");
  EXPECT_EQ(shown_number(1234567.0), "1.23457e+06");
}

TEST(NumberDrag, ARangeThatIsClosedOnBothSidesIsItsOwnSlider) {
  graph::AttributeSpec spec;
  spec.minimum = 0.0;
  spec.maximum = 1.0;
  EXPECT_EQ(range_of(spec).soft_minimum, 0.0);
  EXPECT_EQ(range_of(spec).soft_maximum, 1.0);
  spec.maximum.reset();
  EXPECT_FALSE(range_of(spec).soft_maximum);
}

}  // namespace
}  // namespace plinian::window
