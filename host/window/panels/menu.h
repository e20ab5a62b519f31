// The menu bar.
#pragma once

#include "host/window/studio.h"

namespace plinian::window {

void show_menu(Studio& studio);

}  // namespace plinian::window
