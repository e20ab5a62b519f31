// The line beneath everything: what runs, what went wrong, what is shown.
#pragma once

#include "host/window/drawing/pane_rect.h"
#include "host/window/studio.h"

namespace plinian::window {

void show_status(Studio& studio, const PaneRect& pane);

}  // namespace plinian::window
