// Entries of the menus that no key does, for the palette.
#pragma once

#include "host/window/palette/entries.h"

namespace plinian::window {

std::vector<PaletteEntry> menu_entries();

}  // namespace plinian::window
