// Puts window, studio and interface together.
#include "host/window/window.h"

#include "host/window/interface.h"

namespace plinian::window {

bool can_open_window() {
  return has_display();
}

void run_window(const WindowOptions& options) {
  MainWindow window("Plinian", options.size);
  Studio studio(MainWindow::wake, options.trace);
  Interface interface(window, studio);
  studio.files.autosave_seconds = options.autosave_seconds;
  if (!options.input.empty()) studio.files.begin_with(options.input);
  while (!studio.quit) {
    interface.turn();
    if (options.interrupted && *options.interrupted) {
      studio.files.leave_unsaved();
      break;
    }
  }
}

}  // namespace plinian::window
