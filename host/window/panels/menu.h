// The menu bar, the strip of controls over the picture, and the line beneath everything.
#pragma once

#include "host/window/panels/widgets.h"
#include "host/window/studio.h"

namespace plinian::window {

void show_menu(Studio& studio);
void show_view_strip(Studio& studio, const PaneRect& pane);
void show_status(Studio& studio, const PaneRect& pane);

}  // namespace plinian::window
