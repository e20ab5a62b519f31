// A hand that does anything at all, seeded, for PLINIAN_RANDOM_SECONDS (15).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>
#include <thread>
#include <utility>

#include "tests/host/cli/program.h"
#include "tests/host/window/sitting.h"

namespace plinian {
namespace {

using Clock = std::chrono::steady_clock;

constexpr ivec2 screen(1000, 700);
constexpr double worth_telling_ms = 100.0;

// The word of a line of the trace that says how long the interface was not looked at. [ms]
constexpr char stall_word[] = " stall ";

double stall_of(const std::string& line) {
  const std::size_t at = line.find(stall_word);
  return at == line.npos ? 0.0 : std::atof(&line[at + sizeof(stall_word) - 1]);
}

class RandomHand {
 public:
  RandomHand(Sitting& sitting, unsigned seed) : sitting_(sitting), random_(seed) {}

  /// Lets go of the scene and of everything that is only kept for being wanted again; returns what is left.
  /// [MiB]
  double memory_of_an_empty_scene() {
    for (int attempt = 0; attempt < 10; ++attempt) {
      sitting_.resize(screen);  // a larger window takes more
      const std::size_t then = sitting_.now();
      for (int i = 0; i < 3; ++i) sitting_.stroke("Escape");  // a field, the dialog it is in, what is typed
      for (const char* entry : {"stop the reference", "compare with nothing"}) {
        sitting_.stroke("Control_L+Shift_L+p");
        sitting_.type(entry);
        sitting_.stroke("Return");
        sitting_.stroke("Escape");  // there is none of that name now: what is typed next is for a new palette
      }
      for (const char* line : {"deleteSnapshot", "newScene -force", "cache -clear"}) run(line);
      const Clock::time_point asked = Clock::now();
      Clock::time_point quiet_since = asked;
      std::ptrdiff_t made = 0;
      double lowest = std::numeric_limits<double>::infinity();
      bool has_run = false;
      while (Clock::now() - asked < std::chrono::seconds(has_run ? 60 : 10)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        const std::vector<std::string>& lines = sitting_.lines();
        const auto ran =
            std::find_if(lines.begin() + std::ptrdiff_t(then), lines.end(),
                         [](const auto& line) { return line.find("ran cache -clear") != line.npos; });
        has_run = ran != lines.end();
        if (!has_run) continue;
        // Two pictures that take turns never stand still; nothing is made for them.
        const auto pictures = std::count_if(
            ran, lines.end(), [](const auto& line) { return line.find(" picture ") != line.npos; });
        if (std::exchange(made, pictures) != pictures) quiet_since = Clock::now();
        // What was kept for the next picture is given back where none follows: by everybody who renders.
        const double now = sitting_.memory();
        if (now < lowest - 1.0) quiet_since = Clock::now();
        lowest = std::min(lowest, now);
        if (Clock::now() - quiet_since > std::chrono::seconds(6)) return lowest;
      }
    }
    sitting_.keep("random-not-emptied.png");
    std::string last;
    const std::vector<std::string>& lines = sitting_.lines();
    for (std::size_t i = lines.size() - std::min<std::size_t>(lines.size(), 25); i < lines.size(); ++i)
      last += "\n  " + lines[i];
    throw std::runtime_error("the scene could not be emptied; the trace ends with" + last);
  }

  void begin_with_ash() { run("import -setup ash"); }

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
                                            "import smoke.vdb",
                                            "cache -clear",
                                            "undo 3",
                                            "redo 2",
                                            "save kept.plinian",
                                            "open -force kept.plinian",
                                            "no such command"};
    run(lines[below(int(std::size(lines)))]);
  }

  void run(const char* line) {
    sitting_.stroke("Escape");
    sitting_.stroke("Return");
    sitting_.type(line);
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
                                            "o",
                                            "n",
                                            "Control_L+Shift_L+p"};

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
  ASSERT_EQ(plinian_program(
                {"make", "cloud", "--resolution", "96", "-o", (sitting.folder() / "smoke.vdb").string()})
                .code,
            0);
  RandomHand hand(sitting, seed);
  const Clock::time_point begin = Clock::now();
  const auto since = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  double next_look = 60.0;
  std::vector<double> levels;  // of memory, at the end of each minute [MiB]
  int actions = 0;
  while (since() < seconds) {
    hand.act();
    ++actions;
    ASSERT_TRUE(sitting.is_running()) << "after " << actions << " actions of seed " << seed << "\n"
                                      << sitting.errors();
    if (since() < next_look) continue;
    const double full = sitting.memory();
    levels.push_back(hand.memory_of_an_empty_scene());
    hand.begin_with_ash();
    std::printf("%.0f s: %.0f MiB, %.0f of them without a scene\n", next_look, full, levels.back());
    std::fflush(stdout);
    next_look += 60.0;
  }
  for (const char* key : {"Alt_L", "Control_L", "Shift_L", "l"}) sitting.key_up(key);
  // It still answers.
  sitting.resize(screen);
  const std::size_t then = sitting.now();
  sitting.move({screen.x / 2, screen.y / 2});
  sitting.wait_for(" mouse ", then);
  std::vector<double> stalls;
  int pictures = 0;
  const std::vector<std::string>& lines = sitting.lines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    pictures += lines[i].find(" picture ") != std::string::npos;
    const double ms = stall_of(lines[i]);
    if (ms == 0.0) continue;
    stalls.push_back(ms);
    if (ms < worth_telling_ms) continue;
    std::printf("a stall:\n");
    for (std::size_t j = i < 6 ? 0 : i - 6; j < std::min(i + 2, lines.size()); ++j)
      std::printf("  %s\n", lines[j].c_str());
  }
  std::sort(stalls.begin(), stalls.end());
  std::printf("seed %u: %d actions, %d pictures, %zu stalls over 50 ms, the longest %.0f ms, %.0f MiB\n",
              seed, actions, pictures, stalls.size(), stalls.empty() ? 0.0 : stalls.back(), sitting.memory());
  if (levels.size() > 1) {
    EXPECT_LT(levels.back(), levels.front() * 1.05) << "memory leaks";
  }
  EXPECT_GT(pictures, 2);
  EXPECT_EQ(sitting.errors().find("GL error"), std::string::npos) << sitting.errors();
  sitting.send(SIGTERM);
  EXPECT_EQ(sitting.exit_code(), 130) << sitting.errors();
}

}  // namespace
}  // namespace plinian
