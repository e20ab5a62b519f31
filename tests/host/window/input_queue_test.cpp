// Each picture of the interface is told what it can tell apart, and nothing is lost or changes places.
#include "host/window/platform/input_queue.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <random>

namespace plinian::window {
namespace {

using Kind = InputEvent::Kind;

InputEvent motion(double x) {
  return {.kind = Kind::motion, .at = {x, 0.0}};
}
InputEvent button(bool down, int code = GLFW_MOUSE_BUTTON_LEFT) {
  return {.kind = Kind::button, .code = code, .down = down};
}
InputEvent key(int code, bool down, int modifiers = 0) {
  return {.kind = Kind::key, .code = code, .down = down, .modifiers = modifiers};
}
InputEvent character(char c) {
  return {.kind = Kind::character, .code = c};
}

// "m3" a motion to 3, "b+" and "b-" a button, "w" a wheel, "k65+" a key, "'a" a character.
std::string text_of(const std::vector<InputEvent>& events) {
  std::string text;
  for (const InputEvent& event : events) {
    if (!text.empty()) text += ' ';
    const std::string sign = event.down ? "+" : "-";
    switch (event.kind) {
      case Kind::motion:
        text += "m" + std::to_string(int(event.at.x));
        break;
      case Kind::button:
        text += "b" + sign;
        break;
      case Kind::wheel:
        text += "w";
        break;
      case Kind::key:
        text += "k" + std::to_string(event.code) + sign;
        break;
      case Kind::character:
        text += std::string("'") + char(event.code);
        break;
    }
  }
  return text;
}

// What each picture is told.
std::vector<std::string> pictures(const std::vector<InputEvent>& events) {
  InputQueue queue;
  for (const InputEvent& event : events) queue.add(event);
  std::vector<std::string> told;
  while (!queue.is_empty()) told.push_back(text_of(queue.take()));
  return told;
}

using Told = std::vector<std::string>;

TEST(InputQueue, AClickIsSeenDownAndUpAndWhereItWas) {
  EXPECT_EQ(pictures({motion(1), motion(2), button(true), button(false), motion(9), button(true)}),
            (Told{"m2 b+", "b-", "m9 b+"}));
}

TEST(InputQueue, AKeyThatIsTappedIsSeenDown) {
  EXPECT_EQ(pictures({key(GLFW_KEY_N, true), character('n'), key(GLFW_KEY_N, false)}),
            (Told{"k78+ 'n", "k78-"}));
}

TEST(InputQueue, WordsComeInFewPictures) {
  EXPECT_EQ(pictures({key('A', true), character('a'), key('A', false), key('B', true), character('b'),
                      key('B', false), key('B', true), character('b'), key('B', false)}),
            (Told{"k65+ 'a k66+ 'b", "k65- k66- k66+ 'b", "k66-"}));
}

// Escape may take the keys from a field, and Enter give them to one.
TEST(InputQueue, WhatFollowsAKeyOfConsequenceWaitsForIt) {
  const int escape = GLFW_KEY_ESCAPE, enter = GLFW_KEY_ENTER;
  EXPECT_EQ(pictures({key(escape, true), key(escape, false), key(enter, true), key(enter, false),
                      key('A', true), character('a'), key(enter, true)}),
            (Told{"k256+", "k256- k257+", "k257- k65+ 'a", "k257+"}));
}

TEST(InputQueue, AKeyThatIsTappedTwiceIsSeenTwice) {
  const int enter = GLFW_KEY_ENTER;
  EXPECT_EQ(pictures({key(enter, true), key(enter, false), key(enter, true), key(enter, false)}),
            (Told{"k257+", "k257-", "k257+", "k257-"}));
}

TEST(InputQueue, AChordIsOneOfConsequence) {
  EXPECT_EQ(pictures({key(GLFW_KEY_LEFT_CONTROL, true), key('Z', true, GLFW_MOD_CONTROL), key('Z', false),
                      key(GLFW_KEY_LEFT_CONTROL, false), motion(4)}),
            (Told{"k341+ k90+", "k90- k341- m4"}));
}

// Else a click would be one with Alt held, or without.
TEST(InputQueue, TextIsNotToldTogetherWithControlWhichWouldMakeItNone) {
  constexpr int control = GLFW_KEY_LEFT_CONTROL;
  EXPECT_EQ(pictures({key('B', true), character('b'), key('B', false), key(control, true),
                      key('A', true, GLFW_MOD_CONTROL), key('A', false, GLFW_MOD_CONTROL),
                      key(control, false), key('C', true), character('c'), key('C', false)}),
            (std::vector<std::string>{"k66+ 'b", "k66- k341+ k65+", "k65- k341- k67+ 'c", "k67-"}));
  EXPECT_EQ(pictures({key(control, true), key(control, false), key('C', true), character('c')}),
            (std::vector<std::string>{"k341+", "k341- k67+ 'c"}))
      << "Control that is let go before is no Ctrl+C";
}

TEST(InputQueue, ModifiersAreHeldOverAClickAsTheyWere) {
  const int alt = GLFW_KEY_LEFT_ALT;
  EXPECT_EQ(pictures({key(alt, true), button(true), button(false), key(alt, false), button(true)}),
            (Told{"k342+ b+", "b-", "k342- b+"}));
  EXPECT_EQ(pictures({key(alt, true), key(alt, false), button(true)}), (Told{"k342+", "k342- b+"}));
}

TEST(InputQueue, AHeldKeyRepeatsWithoutHoldingUpAnything) {
  const InputEvent repeat{.kind = Kind::key, .code = GLFW_KEY_LEFT, .down = true, .repeat = true};
  EXPECT_EQ(pictures({key(GLFW_KEY_LEFT, true), repeat, repeat, repeat}), (Told{"k263+ k263+ k263+ k263+"}));
}

// Whatever comes, in whatever order.
TEST(InputQueue, LosesNothing) {
  std::mt19937 random(5);
  const int codes[] = {'A', 'B', GLFW_KEY_ESCAPE, GLFW_KEY_LEFT_SHIFT};
  for (int round = 0; round < 200; ++round) {
    InputQueue queue;
    std::vector<InputEvent> sent, told;
    for (int i = 0; i < 40; ++i) {
      const bool down = random() % 2;
      const InputEvent events[] = {motion(i), button(down, int(random() % 2)), key(codes[random() % 4], down),
                                   character('a')};
      sent.push_back(events[random() % 4]);
      queue.add(sent.back());
      if (random() % 3 == 0)
        for (const InputEvent& event : queue.take()) told.push_back(event);
    }
    for (int turn = 0; !queue.is_empty(); ++turn) {
      ASSERT_LT(turn, 100) << "every picture is told something";
      for (const InputEvent& event : queue.take()) told.push_back(event);
    }
    const auto of = [](const std::vector<InputEvent>& events, auto wanted) {
      std::vector<InputEvent> found;
      for (const InputEvent& event : events)
        if (wanted(event)) found.push_back(event);
      return text_of(found);
    };
    const auto is_motion = [](const InputEvent& event) { return event.kind == Kind::motion; };
    const auto is_button = [](const InputEvent& event) { return event.kind == Kind::button; };
    EXPECT_EQ(of(told, is_button), of(sent, is_button));
    for (const int code : codes) {
      const auto is_key = [&](const InputEvent& e) { return e.kind == Kind::key && e.code == code; };
      EXPECT_EQ(of(told, is_key), of(sent, is_key));
    }
    // The last place of the mouse is where it is.
    const std::string end = of(told, is_motion), meant = of(sent, is_motion);
    EXPECT_EQ(end.substr(end.rfind('m') + 1), meant.substr(meant.rfind('m') + 1));
  }
}

}  // namespace
}  // namespace plinian::window
