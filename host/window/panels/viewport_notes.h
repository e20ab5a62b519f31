// What the viewport says about its picture, written over it.
#pragma once

#include "host/window/drawing/pane_rect.h"
#include "host/window/panels/picture_places.h"
#include "host/window/studio.h"

namespace plinian::window {

/// Why it is not up to date, what went wrong, and how far the next one is. shown: that is up, or null.
void show_notes(Studio& studio, const PicturePlaces& places, const PaneRect& pane, const DevelopedPtr& shown);

/// What the picture that is up cost.
void show_figures(Studio& studio, const PaneRect& pane);

/// Figures and colours of the error of maps, where that is what is seen.
void show_map_error(const Studio& studio, const DevelopedPtr& shown, const PaneRect& pane);

}  // namespace plinian::window
