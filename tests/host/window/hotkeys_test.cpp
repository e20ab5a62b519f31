// Keys: how they are spelled, what they do, how a file changes them.
#include "host/window/hotkeys/hotkeys.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

namespace plinian::window {
namespace {

TEST(Hotkeys, AKeyReadsAsItIsWritten) {
  for (const char* text : {"A", "Ctrl+Z", "Ctrl+Shift+Z", "Alt+F4", "[", "+", "Ctrl++", "Delete", "none"}) {
    const auto chord = chord_of(text);
    ASSERT_TRUE(chord) << text;
    EXPECT_EQ(text_of(*chord), text);
  }
  EXPECT_EQ(chord_of("ctrl+shift+z"), chord_of("Ctrl+Shift+Z"));
  for (const char* text : {"", "Ctrl", "Ctrl+", "Ctrl+Ctrl+A", "Hyper+A", "F13", "AB"})
    EXPECT_FALSE(chord_of(text)) << text;
}

TEST(Hotkeys, EveryActionHasOneNameAndNoKeyDoesTwoThings) {
  const Hotkeys hotkeys;
  std::set<std::string> names, keys;
  for (const Hotkey& hotkey : hotkeys.all()) {
    EXPECT_TRUE(names.insert(hotkey.name).second) << hotkey.name;
    EXPECT_FALSE(hotkey.help.empty());
    if (!hotkey.chord.key.empty()) {
      EXPECT_TRUE(keys.insert(text_of(hotkey.chord)).second) << text_of(hotkey.chord);
      EXPECT_EQ(hotkeys.action(hotkey.chord), hotkey.action);
    }
  }
  EXPECT_EQ(hotkeys.action(*chord_of("Ctrl+Z")), Action::undo);
  EXPECT_EQ(hotkeys.action(*chord_of("Z")), Action::zoom_hand) << "what is held beside a key counts";
}

TEST(Hotkeys, TheReadmeTellsThemAll) {
  std::ifstream file(std::string(PLINIAN_SOURCE_DIR) + "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  const std::size_t begin = readme.find("| key | does |"), end = readme.find("\n\n", begin);
  ASSERT_NE(begin, std::string::npos);
  const std::string table = readme.substr(begin, end - begin);
  const Hotkeys hotkeys;
  for (const Hotkey& hotkey : hotkeys.all())
    EXPECT_NE(table.find("`" + text_of(hotkey.chord) + "`"), std::string::npos) << hotkey.name;
}

TEST(Hotkeys, AFileChangesThemAndTellsWhatItCannot) {
  Hotkeys hotkeys;
  const auto problems = hotkeys.read(
      "# mine\n"
      "undo F5\n"
      "frameAll none   # never\n"
      "frameSelection A\n"
      "undoo Ctrl+Y\n"
      "redo Ctrl+Yes\n"
      "redo\n",
      "keys");
  EXPECT_EQ(hotkeys.action(*chord_of("F5")), Action::undo);
  EXPECT_EQ(hotkeys.action(*chord_of("Ctrl+Z")), std::nullopt);
  EXPECT_EQ(hotkeys.action(*chord_of("A")), Action::frame_selection);
  EXPECT_EQ(hotkeys.action(*chord_of("Ctrl+Shift+Z")), Action::redo)
      << "a line that is wrong changes nothing";
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0], "keys:5: no action is called 'undoo' (did you mean 'undo'?)");
  EXPECT_EQ(problems[1], "keys:6: 'Ctrl+Yes' is no key; one is A, 1, F5, Ctrl+Shift+Z, Delete or none");
  EXPECT_EQ(problems[2], "keys:7: expected an action and a key, as in 'undo Ctrl+Z'");
}

TEST(Hotkeys, WhoAsksForATakenKeyGetsIt) {
  Hotkeys hotkeys;
  EXPECT_TRUE(hotkeys.read("redo Ctrl+Z\n", "keys").empty());
  EXPECT_EQ(hotkeys.action(*chord_of("Ctrl+Z")), Action::redo);
  EXPECT_TRUE(hotkeys.chord(Action::undo).key.empty());
}

}  // namespace
}  // namespace plinian::window
