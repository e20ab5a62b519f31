// The pixel under the pointer, read out in the lower left corner.
#pragma once

#include "host/window/panels/picture_places.h"
#include "host/window/studio.h"

namespace plinian::window {

class PixelLines {
 public:
  /// picture: [points] where the one that is shown lies. hovered: the mouse is in the viewport. Over the
  /// other one, side by side, the same place of both is read.
  void show(Studio& studio, const DevelopedPtr& shown, const PicturePlaces& places, const PaneRect& picture,
            const PaneRect& pane, bool hovered);
  /// What it takes of the pane's lower edge beyond a line while pictures are, or may be, compared. [points]
  static float more_height(const Studio& studio);

 private:
  std::string told_;
};

}  // namespace plinian::window
