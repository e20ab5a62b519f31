// Where the panes are: a column on either side, a strip beneath, the picture in the middle.
#pragma once

#include <optional>
#include <string>

#include "host/window/drawing/pane_rect.h"

namespace plinian::window {

/// Where the probe's card was dragged to.
struct ProbeSpot {
  vec2 share{0.0f};  // [-] of what the window leaves beside the card
  vec2 size{0.0f};   // [points] at a scale of 1: as large as it was
  bool operator==(const ProbeSpot&) const = default;
};

/// How large the side panes are; what the window leaves, the picture has.
struct PaneSizes {
  float left = 230.0f, right = 350.0f;  // [points] at a scale of 1
  float bottom = 170.0f;                // [points] at a scale of 1: beneath the picture, whatever it shows
  float outliner = 0.62f;               // [-] share of the left column
  bool shows_nodes = false;             // beneath the picture, in place of the console
  std::optional<ProbeSpot> probe;       // none: where it hides least
};

struct Panes {
  PaneRect menu, outliner, lights, picture, attributes, timeline, bottom, status;
};

/// room: [points] of the window. The picture keeps 200 points a side; what does not fit is narrowed. panels:
/// false leaves the picture alone.
Panes lay_out(const PaneSizes& sizes, vec2 room, float menu_height, float timeline_height,
              float status_height, float scale, bool panels);

/// As lines of text, and back; what is not understood is left as it is.
std::string text_of(const PaneSizes& sizes);
PaneSizes read_pane_sizes(const std::string& text);

}  // namespace plinian::window
