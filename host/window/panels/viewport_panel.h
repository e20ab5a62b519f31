// The picture, what is written over it, and the hand in it.
#pragma once

#include "host/window/drawing/drawings.h"
#include "host/window/drawing/pane_rect.h"
#include "host/window/handles/viewport_handles.h"
#include "host/window/overlay/overlay.h"
#include "host/window/panels/comparison_overlay.h"
#include "host/window/panels/look_gallery.h"
#include "host/window/panels/picture_places.h"
#include "host/window/panels/pixel_lines.h"
#include "host/window/panels/probe_panel.h"
#include "host/window/panels/snapshot_strip.h"
#include "host/window/panels/viewport_hand.h"
#include "host/window/panels/zoom_hand.h"
#include "host/window/studio.h"
#include "host/window/view/picture_texture.h"

namespace plinian::window {

class ViewportPanel {
 public:
  void show(Studio& studio, Drawings& drawings, const PaneRect& pane, double pixel_ratio);
  /// What the probe found, in a pane beneath; after show.
  void show_probe(Studio& studio, const PaneRect& pane) { probe_.show_beneath(studio, pane); }

 private:
  vec2 settle_size(Studio& studio, const PaneRect& pane, double pixel_ratio) const;
  void take_picture(Studio& studio);
  void show_image(Drawings& drawings, const PicturePlaces& places, const PaneRect& shown, float pixel_ratio);

  PictureTexture texture_;
  ComparisonOverlay comparison_;
  SnapshotStrip snapshots_;
  LookGallery looks_;
  ViewportHand hand_;
  Overlay overlay_;
  ViewportHandles handles_;
  ProbePanel probe_;
  ZoomHand zoom_;
  PixelLines pixel_;
  std::weak_ptr<const ViewPicture> asked_picture_;
  std::string asked_development_;
};

}  // namespace plinian::window
