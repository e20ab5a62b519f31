// What keys do: one table of actions, shown in the program, with keys that a file may change.
//
// The file holds a line for each action that is to have another key, `undo Ctrl+Z`; `none` takes the key
// away, # begins a comment.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plinian::window {

/// A key with what is held beside it.
struct Chord {
  bool ctrl = false, shift = false, alt = false;
  std::string key;  // as it is written on it: A, 1, [, F1, Delete, Space; empty: none
  bool operator==(const Chord&) const = default;
};

/// "Ctrl+Shift+Z"; "none" for none. In the other direction none where it is no key.
std::string text_of(const Chord& chord);
std::optional<Chord> chord_of(const std::string& text);

enum class Action {
  zoom_hand,
  light_hand,
  zoom_in,
  zoom_out,
  zoom_whole,
  undo,
  redo,
  new_scene,
  open_scene,
  save_scene,
  save_scene_as,
  delete_nodes,
  duplicate_nodes,
  tool_select,
  tool_translate,
  tool_rotate,
  tool_scale,
  axis_space,
  frame_selection,
  frame_all,
  camera_back,
  camera_forth,
  scene_camera,
  quality_fast,
  quality_high,
  original_maps,
  set_key,
  play,
  next_frame,
  previous_frame,
  snapshot_picture,
  reference,
  wipe,
  side_by_side,
  flicker,
  flicker_turn,
  difference,
  probe,
  flip,
  load_reference,
  playblast,
  toggle_display,
  toggle_panels,
  console_line,
  node_editor,
  palette,
  hotkey_list,
  cancel,
};

struct Hotkey {
  Action action;
  std::string name;   // as the file spells it
  std::string group;  // heading it is listed under
  std::string help;   // what it does, in a few words
  Chord chord;
  bool is_held = false;  // it goes on while the key is down, and asks for the mouse
};

class Hotkeys {
 public:
  /// The table with the keys that it comes with.
  Hotkeys();
  const std::vector<Hotkey>& all() const { return table_; }
  const Chord& chord(Action action) const;
  /// The action of a key, if it has one.
  std::optional<Action> action(const Chord& pressed) const;
  /// Takes the changes of a file. Returns what is wrong with it, one line for each line that it names.
  std::vector<std::string> read(const std::string& text, const std::string& file_name);

 private:
  std::vector<Hotkey> table_;
};

}  // namespace plinian::window
