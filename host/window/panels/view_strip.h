// The strip of controls over the picture: how it is looked at.
#pragma once

#include "host/window/panels/layout.h"
#include "host/window/studio.h"

namespace plinian::window {

void show_view_strip(Studio& studio, const PaneRect& pane);

}  // namespace plinian::window
