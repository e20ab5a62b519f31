// The other picture in the viewport, and how far the two are apart.
#pragma once

#include "host/window/panels/layout.h"
#include "host/window/studio.h"
#include "host/window/view/picture_texture.h"

namespace plinian::window {

class ComparisonOverlay {
 public:
  /// Takes over what was developed, and asks for what is to be. how: that tells developments apart.
  void take_picture(Studio& studio, const std::string& how);
  /// shown: the picture that is compared, or null. picture: [points] where it is.
  void show(Studio& studio, const PaneRect& pane, const PaneRect& picture, const DevelopedPtr& shown);
  /// Whether the mouse has hold of the line.
  bool is_held() const { return wiping_; }

 private:
  void show_wipe(Studio& studio, const PaneRect& picture);

  PictureTexture texture_;
  ViewPicturePtr asked_;
  std::string asked_how_;
  bool wiping_ = false;
};

}  // namespace plinian::window
