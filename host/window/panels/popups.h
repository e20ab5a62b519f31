// What opens over the panels: the question about unsaved changes, the list of hotkeys, what a job says.
#pragma once

#include "host/window/studio.h"

namespace plinian::window {

void show_unsaved_question(Studio& studio);
void show_hotkey_list(Studio& studio);
void show_job(Studio& studio);

}  // namespace plinian::window
