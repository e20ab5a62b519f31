// The other picture in the viewport, and how far the two are apart.
#pragma once

#include "host/window/panels/layout.h"
#include "host/window/studio.h"
#include "host/window/view/picture_texture.h"

namespace plinian::window {

class ComparisonOverlay {
 public:
  /// Takes over what was developed, and asks for what is to be. shown: the picture that is compared, or null.
  void take_picture(Studio& studio, const DevelopedPtr& shown);
  /// picture: [points] where it is; other: where the other one is, side by side;
  /// hovered: the mouse is in the viewport, also while it is down.
  void show(Studio& studio, const PaneRect& pane, const PaneRect& picture, const PaneRect& other,
            const DevelopedPtr& shown, double pixel_ratio, bool hovered);
  /// Whether the mouse has hold of the line.
  bool is_held() const { return hold_ != Hold::nothing; }

 private:
  enum class Hold { nothing, line, forward_grip, backward_grip };
  void show_wipe(Studio& studio, const PaneRect& picture, bool hovered);
  void draw_whole(const PaneRect& place) const;

  PictureTexture texture_;
  ViewPicturePtr asked_;
  std::string asked_how_;
  Hold hold_ = Hold::nothing;
  vec2 grabbed_{0.0f};  // [points] from the line's middle to the mouse
};

/// What there is to say of the comparison, a line each: figures, what was matched, what stands in the way.
std::vector<std::string> comparison_lines(const Studio& studio, const DevelopedPtr& shown);

}  // namespace plinian::window
