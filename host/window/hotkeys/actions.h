// What actions do.
#pragma once

#include "host/window/hotkeys/hotkeys.h"

namespace plinian::window {

class Studio;

/// Does what a key stands for; play and the steps of the time are the timeline's.
void act(Studio& studio, Action action);

/// Takes the snapshot that was asked for before there was a picture for it. To be called once a turn; returns
/// whether it was.
bool keep_wished_picture(Studio& studio);

/// Whether an action leaves the scene as it is and asks it nothing: what can be done while a job runs.
bool is_of_the_view(Action action);

}  // namespace plinian::window
