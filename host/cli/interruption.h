// Ctrl-C and a polite kill: work is asked to stop, and a plug-in that does not listen is named and left.
#pragma once

#include <atomic>

namespace plinian::cli {

/// From now on Ctrl-C (SIGINT) and a polite kill (SIGTERM) raise a flag; a second one ends the program as
/// usual. While the work that goes on is a plug-in's, a line on standard error says so after a second; after
/// SIGTERM, which nobody may be there to repeat, the program ends itself (status 130) once the plug-in has
/// gone on for five. Work of the program itself is waited for. Uses SIGALRM.
void catch_interrupts();
bool interrupted();
const std::atomic<bool>& interrupt_flag();

}  // namespace plinian::cli
