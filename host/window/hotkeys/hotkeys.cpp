// The table, and chords as text.
#include "host/window/hotkeys/hotkeys.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "core/scene/nearest_word.h"

namespace plinian::window {

namespace {

const std::vector<std::string>& named_keys() {
  static const std::vector<std::string> names = {
      "F1",   "F2",  "F3",     "F4",       "F5",   "F6",    "F7",     "F8",     "F9",
      "F10",  "F11", "F12",    "Space",    "Tab",  "Enter", "Escape", "Delete", "Backspace",
      "Home", "End", "PageUp", "PageDown", "Left", "Right", "Up",     "Down",   "Insert"};
  return names;
}

std::string upper(std::string text) {
  for (char& c : text) c = char(std::toupper((unsigned char)c));
  return text;
}

Hotkey entry(Action action, const char* name, const char* group, const char* help, const char* chord) {
  return {action, name, group, help, chord_of(chord).value()};
}

Hotkey held(Action action, const char* name, const char* help, const char* chord) {
  return {action, name, "Mouse", help, chord_of(chord).value(), true};
}

}  // namespace

std::string text_of(const Chord& chord) {
  if (chord.key.empty()) return "none";
  return std::string(chord.ctrl ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "") + (chord.alt ? "Alt+" : "") +
         chord.key;
}

std::optional<Chord> chord_of(const std::string& text) {
  Chord chord;
  if (upper(text) == "NONE") return chord;
  std::string rest = text;
  for (;;) {
    const auto plus = rest.find('+');
    if (plus == rest.npos || plus + 1 == rest.size()) break;
    const std::string held = upper(rest.substr(0, plus));
    bool* flag = held == "CTRL"    ? &chord.ctrl
                 : held == "SHIFT" ? &chord.shift
                 : held == "ALT"   ? &chord.alt
                                   : nullptr;
    if (!flag || *flag) return std::nullopt;
    *flag = true;
    rest = rest.substr(plus + 1);
  }
  if (rest.size() == 1 && std::isgraph((unsigned char)rest[0])) {
    chord.key = upper(rest);
    return chord;
  }
  for (const std::string& name : named_keys())
    if (upper(name) == upper(rest)) {
      chord.key = name;
      return chord;
    }
  return std::nullopt;
}

Hotkeys::Hotkeys()
    : table_{
          held(Action::light_hand, "turnLight", "left drag turns the key light around the medium", "L"),
          held(Action::zoom_hand, "zoomHand", "wheel magnifies the picture, left drag pans it", "Z"),
          entry(Action::new_scene, "newScene", "Scene", "begin an empty scene", "Ctrl+N"),
          entry(Action::open_scene, "openScene", "Scene", "open a scene or a volume", "Ctrl+O"),
          entry(Action::save_scene, "saveScene", "Scene", "save the scene", "Ctrl+S"),
          entry(Action::save_scene_as, "saveSceneAs", "Scene", "save the scene under another name",
                "Ctrl+Shift+S"),
          entry(Action::playblast, "playblast", "Scene", "render frames or a film as seen", "Ctrl+P"),
          entry(Action::undo, "undo", "Edit", "take back the last edit", "Ctrl+Z"),
          entry(Action::redo, "redo", "Edit", "do it again", "Ctrl+Shift+Z"),
          entry(Action::duplicate_nodes, "duplicate", "Edit", "copy what is selected", "Ctrl+D"),
          entry(Action::delete_nodes, "delete", "Edit", "delete what is selected", "Delete"),
          entry(Action::tool_select, "select", "Tools", "select, with nothing to take hold of", "Q"),
          entry(Action::tool_translate, "translate", "Tools", "move what is selected", "W"),
          entry(Action::tool_rotate, "rotate", "Tools", "turn it", "E"),
          entry(Action::tool_scale, "scale", "Tools", "scale it", "R"),
          entry(Action::axis_space, "axes", "Tools", "along the world's axes, or its own", "O"),
          entry(Action::frame_selection, "frameSelection", "View", "show what is selected", "F"),
          entry(Action::frame_all, "frameAll", "View", "show everything", "A"),
          entry(Action::zoom_whole, "zoomWhole", "View", "the whole picture, no longer magnified", "Shift+Z"),
          entry(Action::zoom_in, "zoomIn", "View", "magnify the picture; the camera stays", "="),
          entry(Action::zoom_out, "zoomOut", "View", "... less", "-"),
          entry(Action::camera_back, "cameraBack", "View", "the view before", "["),
          entry(Action::camera_forth, "cameraForth", "View", "the view after", "]"),
          entry(Action::scene_camera, "sceneCamera", "View", "look through the scene's camera", "C"),
          entry(Action::quality_fast, "qualityFast", "View", "the quality set fast", "1"),
          entry(Action::quality_high, "qualityHigh", "View", "the quality set high", "2"),
          entry(Action::original_maps, "originalMaps", "View", "full-range maps in place of adaptive ones",
                "T"),
          entry(Action::snapshot_picture, "snapshot", "Compare", "keep picture and scene as a snapshot", "P"),
          entry(Action::reference, "reference", "Compare", "render the reference", "Shift+R"),
          entry(Action::load_reference, "loadReference", "Compare", "load a reference from a file", "Ctrl+R"),
          entry(Action::wipe, "wipe", "Compare", "wipe between the two pictures", "Shift+W"),
          entry(Action::side_by_side, "sideBySide", "Compare", "both side by side", "Shift+S"),
          entry(Action::flicker, "flicker", "Compare", "one after the other, by itself", "Shift+F"),
          entry(Action::flicker_turn, "flickerTurn", "Compare", "... by hand: now this one, now the other",
                "X"),
          entry(Action::difference, "difference", "Compare", "their signed difference", "Shift+D"),
          entry(Action::flip, "flip", "Compare", "where an eye sees a difference (FLIP)", "Shift+E"),
          entry(Action::probe, "probe", "View", "click in the picture to see why a pixel looks as it does",
                "I"),
          entry(Action::toggle_display, "headsUp", "View", "figures over the picture", "H"),
          entry(Action::set_key, "setKey", "Time", "key the place of what is selected", "S"),
          entry(Action::play, "play", "Time", "play, or stop", "Space"),
          entry(Action::previous_frame, "previousFrame", "Time", "the frame before", "Left"),
          entry(Action::next_frame, "nextFrame", "Time", "the frame after", "Right"),
          entry(Action::toggle_panels, "panels", "Window", "the picture alone, or with panels", "Tab"),
          entry(Action::console_line, "console", "Window", "go to the command line", "Enter"),
          entry(Action::node_editor, "nodes", "Window", "the node editor, or the console again", "N"),
          entry(Action::palette, "palette", "Window",
                "find an action, a node, an attribute, a command or a look", "Ctrl+Shift+P"),
          entry(Action::hotkey_list, "hotkeys", "Window", "this list", "F1"),
          entry(Action::cancel, "cancel", "Window", "stop what is running", "Escape"),
      } {}

const Chord& Hotkeys::chord(Action action) const {
  return std::find_if(table_.begin(), table_.end(), [&](const Hotkey& h) { return h.action == action; })
      ->chord;
}

std::optional<Action> Hotkeys::action(const Chord& pressed) const {
  if (pressed.key.empty()) return std::nullopt;
  for (const Hotkey& hotkey : table_)
    if (hotkey.chord == pressed) return hotkey.action;
  return std::nullopt;
}

std::vector<std::string> Hotkeys::read(const std::string& text, const std::string& file_name) {
  std::vector<std::string> problems;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string name, key, more;
    if (!(words >> name) || name.front() == '#') continue;
    const std::string where = file_name + ":" + std::to_string(number) + ": ";
    if (!(words >> key) || (words >> more && more.front() != '#')) {
      problems.push_back(where + "expected an action and a key, as in 'undo Ctrl+Z'");
      continue;
    }
    const auto found =
        std::find_if(table_.begin(), table_.end(), [&](const Hotkey& h) { return h.name == name; });
    const std::optional<Chord> chord = chord_of(key);
    if (found == table_.end()) {
      std::vector<std::string> names;
      for (const Hotkey& hotkey : table_) names.push_back(hotkey.name);
      problems.push_back(where + "no action is called '" + name + "'" + did_you_mean(name, names));
      continue;
    }
    if (!chord) {
      problems.push_back(where + "'" + key + "' is no key; one is A, 1, F5, Ctrl+Shift+Z, Delete or none");
      continue;
    }
    // Who asks for a key gets it.
    for (Hotkey& other : table_)
      if (&other != &*found && !chord->key.empty() && other.chord == *chord) other.chord = {};
    found->chord = *chord;
  }
  return problems;
}

}  // namespace plinian::window
