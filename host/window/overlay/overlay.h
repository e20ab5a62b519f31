// What is drawn over the picture, and what a click in it selects.
//
// It is drawn by the interface, so that nothing of it is in a picture that is rendered. Media
// hide the ground and bounds behind them.
#pragma once

#include <string>
#include <vector>

#include "host/window/drawing/pane_rect.h"
#include "host/window/overlay/overlay_choice.h"
#include "host/window/overlay/projection.h"
#include "host/window/studio.h"

namespace plinian::window {

struct WorldLine;
class Drawings;

class Overlay {
 public:
  /// Draws what is chosen over the picture that is shown. place, seen: [points] where that is, and the part
  /// of it that is seen; bottom: under which others write.
  void show(Studio& studio, const ViewPicture& picture, const PaneRect& place, const PaneRect& seen,
            float bottom);
  /// Selects by the mouse. free: it is over the picture, and nobody else's.
  void select(Studio& studio, Drawings& drawings, const ViewPicture& picture, const PaneRect& place,
              bool free);

 private:
  struct Icon {
    std::string node;
    vec2 at{0.0f};  // [points]
  };
  void show_bounds(Studio& studio, const ViewPicture& picture, const Projection& projection);
  void show_lights(Studio& studio, const ViewPicture& picture, const Projection& projection);
  void show_cameras(Studio& studio, const Projection& projection);
  void draw_icon(Studio& studio, const std::vector<WorldLine>& lines, const dvec3& at,
                 const std::string& node, const Projection& projection);

  std::vector<Icon> icons_;  // that were drawn last
  bool pressed_ = false;
  vec2 pressed_at_{0.0f};  // [points]
};

/// The command of a click on a node, or beside all where `node` is empty; empty where there is nothing to do.
std::string select_command(const std::string& node, bool add, bool toggle, bool is_selected,
                           bool anything_selected);

}  // namespace plinian::window
