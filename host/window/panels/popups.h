// What opens over the panels: the question about unsaved changes, what was left behind, the list of hotkeys,
// what a job says.
#pragma once

#include "host/window/studio.h"

namespace plinian::window {

void show_unsaved_question(Studio& studio);
/// Offers what programs that ended without order left behind.
void show_recovery(Studio& studio);
void show_hotkey_list(Studio& studio);
void show_job(Studio& studio);

}  // namespace plinian::window
