// A hand that does anything at all, seeded, for PLINIAN_RANDOM_SECONDS (15).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>

#include "tests/host/cli/program.h"
#include "tests/host/window/sitting.h"

namespace plinian {
namespace {

using Clock = std::chrono::steady_clock;

constexpr ivec2 screen(1000, 700);

class RandomHand {
 public:
  RandomHand(Sitting& sitting, unsigned seed) : sitting_(sitting), random_(seed) {}

  void act() {
    switch (below(10)) {
      case 0:
      case 1:
      case 2:
        return drag();
      case 3:
        sitting_.move(place());
        return wheel();
      case 4:
        return command();
      case 5:
        if (below(4) == 0) sitting_.resize({500 + below(screen.x - 499), 350 + below(screen.y - 349)});
        return;
      case 6:
        sitting_.move(place());
        sitting_.press();
        return sitting_.release();
      default:
        return sitting_.stroke(strokes[std::size_t(below(int(std::size(strokes))))]);
    }
  }

 private:
  int below(int n) { return int(random_() % unsigned(n)); }
  ivec2 place() { return {below(screen.x), below(screen.y)}; }

  void wheel() {
    const unsigned button = below(2) ? 4 : 5;
    sitting_.press(button);
    sitting_.release(button);
  }

  void drag() {
    static constexpr const char* held[] = {"", "Alt_L", "Control_L", "Shift_L", "l"};
    const char* key = held[below(5)];
    const unsigned button = 1 + unsigned(below(3));
    if (*key) sitting_.key_down(key);
    sitting_.move(place());
    sitting_.press(button);
    for (int i = below(6); i >= 0; --i) sitting_.move(place());
    sitting_.release(button);
    if (*key) sitting_.key_up(key);
  }

  void command() {
    static constexpr const char* lines[] = {"setAttr medium.density_scale 20",
                                            "setAttr medium.albedo 0.9 0.5 0.2",
                                            "createNode pointLight -name spark",
                                            "setAttr key.rotate.y 40",
                                            "import explosion",
                                            "import cloud",
                                            "currentTime 12",
                                            "preset apply sandstorm medium",
                                            "frameView",
                                            "select key",
                                            "newScene -force",
                                            "import -setup ash",
                                            "undo 3",
                                            "redo 2",
                                            "save kept.plinian",
                                            "open -force kept.plinian",
                                            "no such command"};
    sitting_.stroke("Escape");
    sitting_.stroke("Return");
    sitting_.type(lines[below(int(std::size(lines)))]);
    sitting_.stroke("Return");
  }

  static constexpr const char* strokes[] = {"f",
                                            "a",
                                            "c",
                                            "bracketleft",
                                            "bracketright",
                                            "1",
                                            "2",
                                            "t",
                                            "p",
                                            "i",
                                            "h",
                                            "s",
                                            "space",
                                            "Left",
                                            "Right",
                                            "Tab",
                                            "F1",
                                            "x",
                                            "Escape",
                                            "Shift_L+w",
                                            "Shift_L+s",
                                            "Delete",
                                            "Up",
                                            "Shift_L+f",
                                            "Shift_L+d",
                                            "Shift_L+e",
                                            "Shift_L+r",
                                            "Control_L+z",
                                            "Control_L+Shift_L+z",
                                            "Control_L+d",
                                            "q",
                                            "w",
                                            "e",
                                            "r",
                                            "o"};

  Sitting& sitting_;
  std::mt19937 random_;
};

TEST(RandomSitting, NothingThatAHandDoesEndsTheProgram) {
  if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  const char* asked = std::getenv("PLINIAN_RANDOM_SECONDS");
  const char* asked_seed = std::getenv("PLINIAN_RANDOM_SEED");
  const double seconds = asked ? std::atof(asked) : 15.0;
  const unsigned seed = asked_seed ? unsigned(std::atol(asked_seed)) : 1u;
  Sitting sitting({"ash"}, screen);
  RandomHand hand(sitting, seed);
  const Clock::time_point begin = Clock::now();
  const auto since = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  double next_report = 60.0;
  int actions = 0;
  while (since() < seconds) {
    hand.act();
    ++actions;
    ASSERT_TRUE(sitting.is_running()) << "after " << actions << " actions of seed " << seed << "\n"
                                      << sitting.errors();
    if (since() > next_report) {
      std::printf("%.0f s: %.0f MiB\n", since(), sitting.memory());
      next_report += 60.0;
    }
  }
  for (const char* key : {"Alt_L", "Control_L", "Shift_L", "l"}) sitting.key_up(key);
  // It still answers.
  sitting.resize(screen);
  const std::size_t then = sitting.now();
  sitting.move({screen.x / 2, screen.y / 2});
  sitting.wait_for(" mouse ", then);
  std::vector<double> stalls;
  int pictures = 0;
  for (const std::string& line : sitting.lines()) {
    if (const std::size_t at = line.find(" stall "); at != line.npos)
      stalls.push_back(std::atof(&line[at + 7]));
    pictures += line.find(" picture ") != line.npos;
  }
  std::sort(stalls.begin(), stalls.end());
  std::printf("seed %u: %d actions, %d pictures, %zu stalls over 50 ms, the longest %.0f ms, %.0f MiB\n",
              seed, actions, pictures, stalls.size(), stalls.empty() ? 0.0 : stalls.back(), sitting.memory());
  EXPECT_GT(pictures, 2);
  EXPECT_EQ(sitting.errors().find("GL error"), std::string::npos) << sitting.errors();
  sitting.send(SIGTERM);
  EXPECT_EQ(sitting.exit_code(), 130) << sitting.errors();
}

}  // namespace
}  // namespace plinian
