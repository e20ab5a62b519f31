// The snapshots as a strip of thumbnails along the picture's lower edge, from the right: axes and scale are
// on the left.
#pragma once

#include <map>
#include <memory>

#include "host/window/drawing/pane_rect.h"
#include "host/window/studio.h"
#include "host/window/view/picture_texture.h"

namespace plinian::window {

/// Over the line that reads out the pixel [points]; 0 where none is shown.
float snapshot_strip_height(const Studio& studio);

class SnapshotStrip {
 public:
  /// pane: of the viewport. A click compares with a snapshot, a menu offers the rest.
  void show(Studio& studio, const PaneRect& pane);
  /// Where it was shown last; of no size where it was not. [points]
  const PaneRect& place() const { return place_; }

 private:
  PaneRect place_;
  std::map<std::string, std::unique_ptr<PictureTexture>> textures_;  // by name
};

}  // namespace plinian::window
