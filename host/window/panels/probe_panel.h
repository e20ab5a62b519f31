// The ray probe: a pixel is chosen in the picture, its curves stand in a corner.
#pragma once

#include "host/window/panels/layout.h"
#include "host/window/studio.h"

namespace plinian::window {

class ProbePanel {
 public:
  /// Takes the mouse in the picture while the probe is on. hovered: the mouse is in the viewport, and nobody
  /// else's. Marks the pixel.
  void choose(Studio& studio, const PaneRect& picture, bool hovered);
  /// The curves, over the lower corner of the pane.
  void show(Studio& studio, const PaneRect& pane);
  /// Whether the mouse is choosing.
  bool is_held() const { return held_; }

 private:
  void show_view_ray(Studio& studio, const Inspection& inspection, vec2 size);
  void show_light_ray(const Inspection& inspection, vec2 size);

  bool held_ = false;
  InspectionPtr told_;
};

}  // namespace plinian::window
