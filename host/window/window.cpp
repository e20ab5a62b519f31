// Puts window, studio and interface together.
#include "host/window/window.h"

#include <chrono>
#include <optional>
#include <string>

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

namespace {

// The window and what is drawn in it: made anew where its OpenGL context is lost. The scene, and what renders
// it, is the studio's and stays.
class Face {
 public:
  Face(Studio& studio, ivec2 size) : studio_(studio) { make(size); }

  void turn() {
    interface_->turn();
    if (window_->is_context_lost()) make_again();
  }
  void hide() { window_->hide(); }

 private:
  void make(ivec2 size) {
    window_.emplace("Plinian", size);
    interface_.emplace(*window_, studio_);
  }
  void make_again() {
    constexpr int most = 3;
    constexpr auto soon = std::chrono::minutes(1);
    const auto now = std::chrono::steady_clock::now();
    losses_ = now - lost_ < soon ? losses_ + 1 : 1;
    lost_ = now;
    const ivec2 size = window_->size();
    interface_.reset();
    window_.reset();
    try {
      if (losses_ > most)
        throw NoDisplay(
            "the window's OpenGL context was lost again and again; what was not saved is offered at "
            "the next start");
      make(size);
    } catch (const NoDisplay&) {
      studio_.files.leave_unsaved();
      throw;
    }
    studio_.console.add(LineKind::warning, "the window's OpenGL context was lost, and has been made anew");
    studio_.trace.note("window again");
  }

  Studio& studio_;
  std::optional<MainWindow> window_;
  std::optional<Interface> interface_;
  int losses_ = 0;  // in a row
  std::chrono::steady_clock::time_point lost_{};
};

}  // namespace

void run_window(const WindowOptions& options) {
  const Desktop desktop;
  Studio studio(Desktop::wake, options.trace);
  Face face(studio, options.size);
  studio.files.autosave_seconds = options.autosave_seconds;
  if (!options.input.empty()) studio.files.begin_with(options.input);
  while (!studio.quit) {
    face.turn();
    if (options.interrupted && *options.interrupted) {
      studio.files.leave_unsaved();
      break;
    }
  }
  if (studio.quit) studio.files.forget_unsaved();
  face.hide();
  end_work(studio.session(), options.on_no_end);
}

}  // namespace plinian::window
