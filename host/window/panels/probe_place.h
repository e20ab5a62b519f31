// Where the probe's card lies: where it hides least of the smoke, and never the pixel that it is about; where
// it would hide much of a small picture, beneath that, in place of the console.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "host/window/drawing/pane_rect.h"

namespace plinian::window {

struct ProbeCard {
  PaneRect place;     // [points]
  bool wide = false;  // its plots stand side by side, not one over the other
};

/// Whether it is to lie beneath the picture. pane: of the picture, bottom: beneath it [points]
bool is_better_beneath(const PaneRect& pane, const PaneRect& bottom, float scale);

/// Those that there is room for: upright in the corners where they leave half of the room free, wide along
/// its lower and upper edge. scale: of the interface [-]. At least one.
std::vector<ProbeCard> probe_cards(const PaneRect& room, float scale);

/// The index of the card that hides least. pixel: [points] that is to be seen with `reach` around it. smoke:
/// alpha [-] at a point of the screen. now: where the card lies; it stays where another place is hardly
/// better.
std::size_t least_hiding(const std::vector<ProbeCard>& cards, vec2 pixel, float reach,
                         const std::function<float(vec2)>& smoke, std::optional<std::size_t> now);

/// Whether a card leaves a point free, with `reach` around it.
bool leaves_free(const PaneRect& card, vec2 pixel, float reach);

}  // namespace plinian::window
