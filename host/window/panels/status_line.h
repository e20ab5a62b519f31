// The line beneath everything: what runs, what went wrong, what is shown.
#pragma once

#include <string>

#include "host/window/drawing/pane_rect.h"
#include "host/window/studio.h"

namespace plinian::window {

/// Of a picture: "quick", "pass 3 of 32 at most", "at rest, 4 passes"; of one that shows nothing, what is
/// done meanwhile. awaits: that, as "reading smoke.vdb"; empty: nothing.
std::string state_of(const ViewPicture& picture, const std::string& awaits);

void show_status(Studio& studio, const PaneRect& pane);

}  // namespace plinian::window
