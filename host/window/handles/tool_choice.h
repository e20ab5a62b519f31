// What the mouse does to what is selected. No part of the scene.
#pragma once

namespace plinian::window {

enum class Tool { select, translate, rotate, scale };

enum class AxisSpace { world, local };

struct ToolChoice {
  Tool tool = Tool::select;
  AxisSpace translate_space = AxisSpace::world, rotate_space = AxisSpace::local;  // as in Maya
  bool is_dragging = false;                                                       // a handle is held
  bool give_up = false;  // what is held goes back to where it was

  /// Along what axes the tool works; scaling knows its own alone.
  AxisSpace space() const {
    return tool == Tool::translate ? translate_space : tool == Tool::rotate ? rotate_space : AxisSpace::local;
  }
  void switch_space() {
    AxisSpace* space = tool == Tool::translate ? &translate_space
                       : tool == Tool::rotate  ? &rotate_space
                                               : nullptr;
    if (space) *space = *space == AxisSpace::world ? AxisSpace::local : AxisSpace::world;
  }
};

}  // namespace plinian::window
