// The other picture in the viewport, and how far the two are apart.
#pragma once

#include "host/window/panels/picture_places.h"
#include "host/window/studio.h"
#include "host/window/view/picture_texture.h"

namespace plinian::window {

class ComparisonOverlay {
 public:
  /// Takes over what was developed, and asks for what is to be. shown: the picture that is compared, or null.
  void take_picture(Studio& studio, const DevelopedPtr& shown);
  /// free: the mouse is in the viewport, also while it is down, and nobody else's.
  void show(Studio& studio, const PicturePlaces& places, double pixel_ratio, bool free);
  /// What there is to read of it, over everything else that is drawn in the pane.
  void show_lines(const Studio& studio, const PaneRect& pane, const PicturePlaces& places,
                  const DevelopedPtr& shown);
  /// Whether the mouse has hold of the line.
  bool is_held() const { return hold_ != Hold::nothing; }
  /// Where its lines end that stand in the pane's upper right corner. [points]
  float bottom() const { return bottom_; }

 private:
  enum class Hold { nothing, line, forward_grip, backward_grip };
  void show_wipe(Studio& studio, const PicturePlaces& places, bool free);
  CompareMode shown_mode(const Comparison& comparison) const;
  void draw_whole(const PaneRect& place, const PaneRect& room) const;

  PictureTexture texture_;
  std::weak_ptr<const ViewPicture> asked_;
  std::string asked_how_;
  Hold hold_ = Hold::nothing;
  float bottom_ = 0.0f;
  vec2 grabbed_{0.0f};  // [points] from the line's middle to the mouse
};

struct ComparisonLine {
  std::string text;
  bool is_rough = false;  // of a quick picture
};

/// What there is to say of the comparison: figures, what was matched, what stands in the way.
std::vector<ComparisonLine> comparison_lines(const Studio& studio, const DevelopedPtr& shown);

}  // namespace plinian::window
