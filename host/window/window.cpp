// Puts window, studio and interface together.
#include "host/window/window.h"

#include <chrono>

#include "host/window/interface.h"

namespace plinian::window {

bool can_open_window() {
  return has_display();
}

namespace {

constexpr auto patience =
    std::chrono::seconds(5);  // with a computation that does not ask whether it is cancelled

// Ends what workers compute.
void end_work(graph::Session& session, const std::function<void(const std::string&)>& on_no_end) {
  session.evaluator().cancel_all();
  if (session.evaluator().finish_within(patience) || !on_no_end) return;
  const graph::Node* node = session.evaluator().at_work();
  on_no_end((node ? node->name + " (" + node->type->name() + ")" : "a computation") +
            " goes on although the window is closed: it does not ask whether it is cancelled");
}

}  // namespace

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
  if (studio.quit) studio.files.forget_unsaved();
  window.hide();
  end_work(studio.session(), options.on_no_end);
}

}  // namespace plinian::window
