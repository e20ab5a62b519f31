// The strip of controls over the picture: how it is looked at. Two rows where one is too narrow, and a menu
// for what does not fit there either.
#pragma once

#include "host/window/drawing/pane_rect.h"
#include "host/window/studio.h"

namespace plinian::window {

/// What its rows take at that width. [points] Depends on which controls there are, never on what they say.
float view_strip_height(Studio& studio, float width);

void show_view_strip(Studio& studio, const PaneRect& pane);

}  // namespace plinian::window
