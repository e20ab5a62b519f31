// The picture, and the hand that moves the camera in it.
#pragma once

#include "host/window/panels/layout.h"
#include "host/window/studio.h"
#include "host/window/view/picture_texture.h"

namespace plinian::window {

class ViewportPanel {
 public:
  void show(Studio& studio, const PaneRect& pane, double pixel_ratio);

 private:
  enum class Hand { none, tumble, track, dolly, light };
  void settle_size(Studio& studio, const PaneRect& pane, double pixel_ratio);
  void take_picture(Studio& studio);
  void navigate(Studio& studio, bool hovered);
  void show_notes(Studio& studio, const PaneRect& pane);
  void show_comparison(Studio& studio, const PaneRect& pane);
  void show_figures(Studio& studio, const PaneRect& pane);
  void turn_light(Studio& studio, dvec2 mouse);
  void show_pixel(const PaneRect& pane);

  PictureTexture texture_, kept_texture_;
  ViewPicturePtr asked_kept_;
  bool wiping_ = false;
  ViewPicturePtr asked_picture_;
  std::string asked_development_, asked_kept_development_;
  vec2 begin_{0.0f}, end_{0.0f};  // [points] of the picture in the window
  Hand hand_ = Hand::none;
  bool moved_ = false;
  dvec2 last_{0.0}, pressed_{0.0};  // [points] of the mouse
  graph::NodeId light_;             // that is turned
  dvec3 light_start_{0.0};          // [degrees] its rotation when the mouse was pressed
  std::string merge_key_;
};

}  // namespace plinian::window
