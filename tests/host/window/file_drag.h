// Drags files onto a window as a file manager does: the source's side of the XDND protocol, version 5.
#pragma once

#include <X11/Xlib.h>

#include <string>

#include "core/shared/glue.h"

namespace plinian {

/// A `text/uri-list` is dropped on a window. at: [pixels] of the screen. Throws std::runtime_error where the
/// window does not take it, or does not end it within a minute.
void drop_uris(Display* display, Window target, const std::string& uris, ivec2 at);

}  // namespace plinian
