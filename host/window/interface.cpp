// One thread, one loop: look, draw, act.
#include "host/window/interface.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>

#include "host/window/platform/theme.h"

namespace plinian::window {

Interface::Interface(MainWindow& window, Studio& studio) : window_(window), studio_(studio) {
  studio_.draw_meanwhile = [this] { draw_meanwhile(); };
}

Interface::~Interface() {
  studio_.draw_meanwhile = nullptr;
}

// How long nothing need be done where nobody does anything. [s]
double Interface::patience() const {
  if (redraws_ > 0 || studio_.has_work()) return 0.0;
  if (studio_.is_hand_on() || studio_.feed.is_computing()) return 0.015;
  return studio_.renderer.status().is_busy ? 0.1 : 1.0;
}

// The time from one look at the user's doings to the next is what a stall is.
void Interface::note_work(bool waited) {
  const auto now = std::chrono::steady_clock::now();
  if (!waited) {
    const double ms = std::chrono::duration<double, std::milli>(now - work_began_).count();
    if (ms > longest_work_ms_) {
      longest_work_ms_ = ms;
      studio_.trace.note(fmt::format("stall {:.1f}", ms));
    }
  }
  work_began_ = now;
}

void Interface::turn() {
  note_work(false);
  const bool was_computing = studio_.feed.is_computing();
  const bool was_hand_on = studio_.is_hand_on();
  const double most = patience();
  const bool events = window_.wait(most);
  note_work(true);
  // What ended a wait without being an event is news of a picture.
  if (events) redraws_ = 2;
  take_input();
  if (studio_.feed.update()) redraws_ = std::max(redraws_, 2);
  if (was_computing != studio_.feed.is_computing() || was_hand_on != studio_.is_hand_on() || most > 0.05)
    redraws_ = std::max(redraws_, 1);
  studio_.update_picture();
  if (redraws_ > 0 || studio_.renderer.status().is_busy || most == 0.0) {
    draw();
    --redraws_;
  }
  if (studio_.has_work()) {
    studio_.work_off();
    redraws_ = 2;
  }
}

void Interface::draw_meanwhile() {
  note_work(false);
  window_.wait(0.0);
  note_work(true);
  for (const Chord& chord : window_.take_keys())
    if (studio_.hotkeys.action(chord) == Action::cancel) studio_.act(Action::cancel);
  studio_.update_picture();
  draw();
}

void Interface::take_input() {
  for (const Chord& chord : window_.take_keys()) {
    // Keys that are typed into a field are the field's.
    if (ImGui::GetIO().WantTextInput) continue;
    if (const auto action = studio_.hotkeys.action(chord)) studio_.act(*action);
  }
  for (const std::string& path : window_.take_dropped()) studio_.open(path);
  if (window_.take_close_request()) studio_.unless_unsaved([this] { studio_.quit = true; });
}

void Interface::draw() {
  window_.begin_frame();
  ImGui::BeginDisabled(!studio_.job.what.empty());
  show_panels();
  ImGui::EndDisabled();
  window_.end_frame(vec3(0.09f));
}

void Interface::show_panels() {
  const ivec2 room = window_.size();
  const float line = ImGui::GetFrameHeight();
  const Panes panes = lay_out(sizes_, vec2(room), line, line, line, scaled(1), false);
  viewport_.show(studio_, panes.picture, window_.pixel_ratio());
}

}  // namespace plinian::window
