// What the pane beneath the picture shows: the console or the node editor.
#pragma once

#include "host/window/studio.h"

namespace plinian::window {

/// The row of tabs at the head of the pane; leaves the cursor behind them, on their line.
void show_bottom_tabs(Studio& studio);

}  // namespace plinian::window
