// The ray probe: a pixel is chosen in the picture, its curves stand on a card beside it.
#pragma once

#include "host/window/panels/picture_places.h"
#include "host/window/panels/probe_place.h"
#include "host/window/studio.h"

namespace plinian::window {

class ProbePanel {
 public:
  /// Takes the mouse in the picture, or at the same place of the one that it is compared with, while the
  /// probe is on. shown: [points] where the picture is; free: the mouse is in the viewport, and nobody
  /// else's. Marks the pixel.
  void choose(Studio& studio, const PicturePlaces& places, const PaneRect& shown, bool free);
  /// The curves, on a card over the picture, unless they are beneath it. room: [points] of the pane, that
  /// nobody else writes in; taken: what of it is better left free, too. frame: of the picture that is shown,
  /// or null.
  void show(Studio& studio, const PaneRect& room, const PaneRect& taken, const Frame* frame);
  /// ... in the pane there.
  void show_beneath(Studio& studio, const PaneRect& pane);
  /// Whether the mouse is choosing.
  bool is_held() const { return held_; }

 private:
  // What the card's place depends on.
  struct Asked {
    std::optional<vec2> place;
    vec2 room{0.0f}, room_size{0.0f}, taken{0.0f}, shown{0.0f}, shown_size{0.0f};
    bool operator==(const Asked&) const = default;
  };
  void settle_card(const Studio& studio, const PaneRect& room, const PaneRect& taken, const Frame* frame);
  void drag_card(Studio& studio);
  void show_found(Studio& studio, float header);
  void show_header(Studio& studio, const Inspection& found, float left);
  void show_curves(Studio& studio, const Inspection& found);
  void show_view_ray(Studio& studio, const Inspection& inspection, vec2 size);
  void show_light_ray(const Inspection& inspection, vec2 size);

  bool held_ = false;
  vec2 way_{0.0f};  // [points] from where it holds to the picture
  PaneRect shown_;  // [points] where the picture is
  std::weak_ptr<const Inspection> told_;
  ProbeCard card_;
  std::optional<std::size_t> index_;  // of it, among those that there is room for
  Asked asked_;
  std::optional<vec2> grabbed_;  // [points] from the card's corner to the mouse that drags it
};

}  // namespace plinian::window
