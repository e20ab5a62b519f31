// The node editor: the nodes of the scene as boxes, connected by hand.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/window/drawing/pane_rect.h"
#include "host/window/nodes/canvas_view.h"
#include "host/window/nodes/connect_drag.h"
#include "host/window/nodes/node_map.h"
#include "host/window/studio.h"

namespace plinian::window {

class NodePanel {
 public:
  explicit NodePanel(graph::Session& session);

  void show(Studio& studio, const PaneRect& pane);
  /// Whether an action is the pane's because the pointer is over it: to frame what is selected or everything.
  bool take(Action action);
  /// To be called in turns in which it is not shown.
  void hide();

 private:
  enum class Hold { nothing, pan, zoom, boxes, rectangle, wire };

  void show_controls(Studio& studio);
  void show_canvas(Studio& studio);
  void look_around();
  bool is_all_in_sight() const;
  void frame_what_came();
  void press(Studio& studio, bool twice);
  void drag(Studio& studio);
  void let_go(Studio& studio);
  void drop_wire(Studio& studio);
  void select(Studio& studio, const std::vector<std::size_t>& boxes);
  void draw(Studio& studio);
  void show_help(Studio& studio);
  void tell_places(Studio& studio);
  void frame(const std::set<graph::NodeId>& nodes);

  NodeMap map_;
  char filter_[64] = "";
  CanvasView view_;
  vec2 corner_{0.0f}, size_{1.0f};       // [points] of the canvas in the window
  vec2 mouse_{0.0f};                     // [points] from the corner
  std::optional<std::uint64_t> framed_;  // the scene that was framed
  std::optional<Action> wanted_;         // a frame that was asked for
  bool is_own_view_ = false;             // set by hand: it stays
  // As they were when it was looked whether all is in sight; no boxes: not shown since.
  std::size_t boxes_seen_ = 0;
  vec2 size_seen_{0.0f};
  std::set<graph::NodeId> selected_;
  DiagramHit hot_;
  Hold hold_ = Hold::nothing;
  vec2 pressed_{0.0f}, last_{0.0f};  // [points] from the corner, of the mouse
  bool moved_ = false;
  std::vector<std::pair<graph::NodeId, vec2>> held_;  // boxes that are moved, and where they were
  std::optional<ConnectDrag> wire_;
  std::string refused_;  // what was said last of a plug that it cannot end at
  bool hovered_ = false;
};

}  // namespace plinian::window
