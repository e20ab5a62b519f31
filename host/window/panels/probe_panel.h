// The ray probe: a pixel is chosen in the picture, its curves stand in a corner.
#pragma once

#include "host/window/panels/picture_places.h"
#include "host/window/studio.h"

namespace plinian::window {

class ProbePanel {
 public:
  /// Takes the mouse in the picture, or at the same place of the one that it is compared with, while the
  /// probe is on. shown: [points] where the picture is; free: the mouse is in the viewport, and nobody
  /// else's. Marks the pixel.
  void choose(Studio& studio, const PicturePlaces& places, const PaneRect& shown, bool free);
  /// The curves, over the lower corner of the pane.
  void show(Studio& studio, const PaneRect& pane);
  /// Whether the mouse is choosing.
  bool is_held() const { return held_; }

 private:
  void show_view_ray(Studio& studio, const Inspection& inspection, vec2 size);
  void show_light_ray(const Inspection& inspection, vec2 size);

  bool held_ = false;
  vec2 way_{0.0f};  // [points] from where it holds to the picture
  InspectionPtr told_;
};

}  // namespace plinian::window
