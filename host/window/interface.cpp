// One thread, one loop: look, draw, act.
#include "host/window/interface.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/files/atomic_file.h"
#include "core/scene/resources.h"
#include "host/window/hotkeys/actions.h"
#include "host/window/panels/menu.h"
#include "host/window/panels/open_popups.h"
#include "host/window/panels/popups.h"
#include "host/window/panels/probe_place.h"
#include "host/window/panels/status_line.h"
#include "host/window/panels/typing.h"
#include "host/window/panels/view_strip.h"
#include "host/window/platform/theme.h"

namespace plinian::window {

namespace {

namespace fs = std::filesystem;

// What the interface remembers over sessions.
struct Kept {
  fs::path panes, hidden;  // empty where nothing can be kept
};

Kept kept_files() {
  const fs::path folder = user_config_folder();
  return folder.empty() ? Kept() : Kept{folder / "panes", folder / "hidden"};
}

std::string text_in(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Interface::Interface(MainWindow& window, Studio& studio)
    : window_(window),
      studio_(studio),
      drawings_(studio, MainWindow::gl_function),
      nodes_(studio.session()),
      file_dialog_(Desktop::wake) {
  const Kept files = kept_files();
  sizes_ = read_pane_sizes(text_in(files.panes));
  studio_.show_nodes = sizes_.shows_nodes;
  studio_.inspector.spot = sizes_.probe;
  studio_.overlay = read_overlay_choice(text_in(files.hidden));
  studio_.commands.draw_meanwhile = [this] { draw_meanwhile(); };
}

Interface::~Interface() {
  studio_.commands.draw_meanwhile = nullptr;
  const Kept files = kept_files();
  if (files.panes.empty()) return;
  std::error_code ignored;
  fs::create_directories(files.panes.parent_path(), ignored);
  std::ofstream(files.panes) << text_of(sizes_);
  std::ofstream(files.hidden) << text_of(studio_.overlay);
}

// How long nothing need be done where nobody does anything. [s]
double Interface::patience() const {
  if (studio_.commands.has_work()) return 0.0;
  if (redraws_ > 0) return std::max(0.0, earliness());
  if (studio_.is_hand_on() || studio_.feed.is_computing() || studio_.viewpoint.is_waiting() ||
      drawings_.is_busy() || attributes_.driven.is_waiting() || timeline_.is_playing())
    return 0.015;
  const double idle = studio_.renderer.status().is_busy ? 0.1 : 1.0;
  return std::min(idle, studio_.comparison.until_next_turn());
}

// Where the processor draws the interface too, that leaves two thirds of the time to the picture: how long it
// is until the next drawing. [s]
double Interface::earliness() const {
  constexpr double longest_ms = 30.0;
  const double wait_ms = std::min(2.0 * draw_ms_, longest_ms);
  const double since_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - drawn_).count();
  return (wait_ms - since_ms) / 1000.0;
}

// The time from one look at the user's doings to the next is what a stall is.
void Interface::note_work(bool waited) {
  const auto now = std::chrono::steady_clock::now();
  if (!waited) {
    const double ms = std::chrono::duration<double, std::milli>(now - work_began_).count();
    if (constexpr double worth_telling_ms = 50.0; ms > worth_telling_ms)
      studio_.trace.note(fmt::format("stall {:.1f}{}", ms, phases_));
  }
  phases_.clear();
  work_began_ = phase_began_ = now;
}

// What took its time since the last call, where it is worth telling.
void Interface::note_phase(const char* name) {
  if (!studio_.trace.is_on()) return;
  const auto now = std::chrono::steady_clock::now();
  const double ms = std::chrono::duration<double, std::milli>(now - std::exchange(phase_began_, now)).count();
  if (constexpr double worth_telling_ms = 5.0; ms > worth_telling_ms)
    phases_ += fmt::format(" {} {:.0f}", name, ms);
}

void Interface::turn() {
  note_work(false);
  const bool was_computing = studio_.feed.is_computing();
  const bool was_hand_on = studio_.is_hand_on();
  const double most = patience();
  const bool events = window_.wait(most);
  note_work(true);
  if (events) redraws_ = 2;
  take_input();
  note_phase("input");
  // First, because what it takes over from workers may be the feed's.
  if (drawings_.update()) redraws_ = std::max(redraws_, 2);
  note_phase("drawings");
  if (studio_.feed.update()) redraws_ = std::max(redraws_, 2);
  if (attributes_.driven.take_news()) redraws_ = std::max(redraws_, 1);
  note_phase("feed");
  if (was_computing != studio_.feed.is_computing() || was_hand_on != studio_.is_hand_on() || most > 0.05)
    redraws_ = std::max(redraws_, 1);
  studio_.viewpoint.update();
  studio_.is_playing = timeline_.is_playing();
  studio_.files.autosave_if_due(studio_.is_hand_on());
  note_phase("autosave");
  studio_.update_picture();
  if (keep_wished_picture(studio_)) redraws_ = std::max(redraws_, 2);
  // Behind what asks for the picture of this frame: only then can be said whether that is there.
  timeline_.play(studio_);
  studio_.update_playblast();
  note_phase("picture");
  const bool due = earliness() <= 0.0 || window_.take_urgent();
  if (due && (redraws_ > 0 || studio_.renderer.status().is_busy)) {
    draw();
    --redraws_;
    // A field has the keys that it asked for only with the picture after.
    if (is_typing_expected()) redraws_ = std::max(redraws_, 1);
    still_ = false;
  }
  if (studio_.commands.has_work()) {
    studio_.commands.work_off();
    redraws_ = 2;
    note_phase("commands");
  }
  if (!still_ && patience() >= 1.0) {
    still_ = true;
    studio_.trace.note("still");  // what is on the screen stays until something happens
  }
}

// Keys that are typed into a field are the field's, and those that answer a question the question's.
std::optional<Action> Interface::action_of(const Chord& chord) const {
  if (is_typing()) return std::nullopt;
  const std::optional<Action> action = studio_.hotkeys.action(chord);
  if (!is_popup_open()) return action;
  if (action == Action::cancel) close_menu();
  return std::nullopt;
}

// While a job runs, what is looked at goes on. Where nobody does anything, the job has the processor but for
// a look at how far it is.
void Interface::draw_meanwhile() {
  constexpr auto glance = std::chrono::milliseconds(150);
  note_work(false);
  if (window_.wait(0.0)) redraws_ = 2;
  note_work(true);
  tell_input();
  for (const Chord& chord : window_.take_keys())
    if (studio_.hotkeys.action(chord) == Action::cancel)
      window::act(studio_, Action::cancel);  // whoever has the keys
    else if (const auto action = action_of(chord); action && is_of_the_view(*action) && is_meant(chord))
      window::act(studio_, *action);
  note_keys();
  studio_.update_picture();
  if (is_typing_expected()) redraws_ = std::max(redraws_, 1);
  const bool is_due = redraws_ > 0 || std::chrono::steady_clock::now() - drawn_ > glance;
  if (!is_due || earliness() > 0.0) return;
  draw();
  --redraws_;
}

// Over a panel that takes nothing just now, whoever types letters means no hotkeys.
bool Interface::is_meant(const Chord& chord) const {
  if (chord.key.size() > 1 || chord.ctrl || chord.alt) return true;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const vec2 at = vec2(mouse.x, mouse.y) - picture_.begin;
  return at.x >= 0.0f && at.y >= 0.0f && at.x < picture_.size.x && at.y < picture_.size.y;
}

// Keys wait for a field that is about to take them.
void Interface::tell_input() {
  if (!is_typing_expected()) window_.tell_input();
  studio_.light_key_held = window_.is_held(studio_.hotkeys.chord(Action::light_hand));
  studio_.zoom_key_held = window_.is_held(studio_.hotkeys.chord(Action::zoom_hand));
  if (window_.has_input()) redraws_ = std::max(redraws_, 1);
}

void Interface::take_input() {
  tell_input();
  for (const Chord& chord : window_.take_keys()) {
    if (const auto action = action_of(chord); action && !nodes_.take(*action)) act(*action);
  }
  note_keys();
  for (const std::string& path : window_.take_dropped()) studio_.files.add(path);
  if (window_.take_close_request() || std::exchange(studio_.wants_quit, false))
    studio_.files.unless_unsaved([this] { studio_.quit = true; });
}

void Interface::note_keys() {
  if (const bool typing = is_typing(); std::exchange(typing_, typing) != typing)
    studio_.trace.note(typing ? "keys to a field" : "keys to the window");
}

// Where the mouse is seen, and which buttons are down (1 left, 2 right, 4 middle).
void Interface::note_mouse() {
  if (!studio_.trace.is_on()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const std::string mouse =
      fmt::format("mouse {:.0f} {:.0f} {}", io.MousePos.x, io.MousePos.y,
                  int(io.MouseDown[0]) + 2 * int(io.MouseDown[1]) + 4 * int(io.MouseDown[2]));
  if (mouse != std::exchange(mouse_, mouse)) studio_.trace.note(mouse);
}

void Interface::draw() {
  const auto begin = std::chrono::steady_clock::now();
  note_phase("wait");
  window_.begin_frame();
  note_phase("begin");
  forget_left_typing();
  note_mouse();
  show_panels();
  show_job(studio_);
  note_phase("panels");
  window_.end_frame(vec3(colour::pane));
  note_phase("show");
  drawn_ = std::chrono::steady_clock::now();
  draw_ms_ = std::chrono::duration<double, std::milli>(drawn_ - begin).count();
}

// Playing is the timeline's; the rest needs no panel.
void Interface::act(Action action) {
  switch (action) {
    case Action::play:
      return timeline_.toggle_play(studio_);
    case Action::next_frame:
      return timeline_.step(studio_, 1.0);
    case Action::previous_frame:
      return timeline_.step(studio_, -1.0);
    case Action::cancel:
      if (timeline_.is_playing()) timeline_.toggle_play(studio_);
      return window::act(studio_, action);
    default:
      return window::act(studio_, action);
  }
}

// Where two panes meet they can be dragged.
void Interface::show_splitters(const Panes& panes) {
  const auto splitter = [&](const char* id, vec2 begin, vec2 size, bool upright, float& value, float change) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    begin_pane(id, {begin, size}, false);
    ImGui::PopStyleVar(2);
    ImGui::GetWindowDrawList()->AddRectFilled({begin.x, begin.y}, {begin.x + size.x, begin.y + size.y},
                                              colour::gap);
    ImGui::InvisibleButton("##grip", {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive())
      ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    if (ImGui::IsItemActive()) {
      const ImVec2 delta = ImGui::GetIO().MouseDelta;
      value += (upright ? delta.x : delta.y) * change;
      studio_.keep_hand_on();
    }
    end_pane();
  };
  const float gap = scaled(3), top = panes.outliner.begin.y, scale = scaled(100) / 100.0f;
  const float column = panes.attributes.size.y;
  splitter("##split left", {panes.outliner.size.x, top}, {gap, column}, true, sizes_.left, 1.0f / scale);
  splitter("##split right", {panes.attributes.begin.x - gap, top}, {gap, column}, true, sizes_.right,
           -1.0f / scale);
  splitter("##split bottom", {panes.bottom.begin.x, panes.bottom.begin.y - gap}, {panes.bottom.size.x, gap},
           false, sizes_.bottom, -1.0f / scale);
  splitter("##split outliner", {0.0f, panes.lights.begin.y - gap}, {panes.outliner.size.x, gap}, false,
           sizes_.outliner, 1.0f / std::max(1.0f, column));
  sizes_ = read_pane_sizes(text_of(sizes_));  // within what is sensible
}

void Interface::show_dialogs() {
  const std::string& path = studio_.session().scene_path();
  const fs::path folder = path.empty() ? fs::path() : fs::path(path).parent_path();
  const auto ask = [&](bool& asked, FileQuestion question, std::function<void(const std::string&)> take) {
    question.folder = folder;
    if (std::exchange(asked, false)) file_dialog_.open(studio_, std::move(question), std::move(take));
  };
  ask(studio_.ask_open, {.title = "Open", .extensions = {".plinian", ".vdb", ".json", ".chan", ".exr"}},
      [this](const std::string& chosen) { studio_.files.open(chosen); });
  ask(studio_.ask_import, {.title = "Import a volume", .extensions = {".vdb"}},
      [this](const std::string& chosen) { studio_.files.add(chosen); });
  ask(studio_.ask_reference, {.title = "Load a reference", .extensions = {".exr", ".png"}},
      [this](const std::string& chosen) { studio_.run("loadReference " + graph::quote(chosen)); });
  ask(studio_.ask_plate, {.title = "Load a plate", .extensions = {".exr", ".png"}},
      [this](const std::string& chosen) { studio_.run("loadReference -plate " + graph::quote(chosen)); });
  ask(studio_.ask_save_as,
      {.title = "Save as",
       .name = path.empty() ? "scene.plinian" : fs::path(path).filename().string(),
       .extensions = {".plinian"},
       .saves = true},
      [this](const std::string& chosen) { studio_.files.save_as(chosen); });
  if (auto wish = std::exchange(studio_.ask_file, std::nullopt)) {
    if (wish->question.folder.empty()) wish->question.folder = folder;
    file_dialog_.open(studio_, std::move(wish->question), std::move(wish->take));
  }
  if (std::exchange(studio_.ask_playblast, false)) playblast_dialog_.open(studio_);
  if (!playblast_dialog_.show(studio_, file_dialog_)) file_dialog_.show(studio_);
  if (const auto chosen = palette_.show(studio_)) act(*chosen);
  if (auto field = palette_.take_field()) attributes_.seek(std::move(*field));
  show_unsaved_question(studio_);
  show_recovery(studio_);
  show_hotkey_list(studio_);
}

void Interface::settle_title() {
  const std::string& path = studio_.session().scene_path();
  const std::string title = (path.empty() ? "untitled" : fs::path(path).filename().string()) +
                            (studio_.session().history().is_modified() ? " *" : "") + " - Plinian";
  if (title == title_) return;
  title_ = title;
  window_.set_title(title);
}

void Interface::show_panels() {
  // While a job is in the middle of a step of undo, the picture can be looked at and nothing edited.
  const bool busy = !studio_.commands.job.what.empty();
  ImGui::BeginDisabled(busy);
  show_menu(studio_);
  ImGui::EndDisabled();
  const ivec2 room = window_.size();
  sizes_.shows_nodes = studio_.show_nodes;
  sizes_.probe = studio_.inspector.spot;
  const float line = ImGui::GetFrameHeight(), timeline = line + scaled(8);
  const Panes panes = lay_out(sizes_, vec2(room), line, timeline, line + scaled(2), scaled(100) / 100.0f,
                              studio_.show_panels);
  const float strip = view_strip_height(studio_, panes.picture.size.x);
  PaneRect above = panes.picture, picture = panes.picture;
  above.size.y = strip;
  picture.begin.y += strip;
  picture.size.y = std::max(1.0f, picture.size.y - strip);
  picture_ = picture;
  Inspector& inspector = studio_.inspector;
  inspector.is_docked = studio_.show_panels && !inspector.spot &&
                        is_better_beneath(picture, panes.bottom, scaled(100) / 100.0f);
  viewport_.show(studio_, drawings_, picture, window_.pixel_ratio());
  const bool shows_probe = inspector.is_beneath();
  ImGui::BeginDisabled(busy);
  show_view_strip(studio_, above);
  if (studio_.show_panels) {
    outliner_.show(studio_, panes.outliner);
    lights_.show(studio_, panes.lights, attributes_.driven);
    attributes_.show(studio_, panes.attributes);
    timeline_.show(studio_, panes.timeline);
    if (shows_probe) {
      viewport_.show_probe(studio_, panes.bottom);
    } else if (sizes_.shows_nodes) {
      nodes_.show(studio_, panes.bottom);
    } else {
      ImGui::EndDisabled();  // what is typed meanwhile waits its turn
      console_.show(studio_, panes.bottom);
      ImGui::BeginDisabled(busy);
    }
    show_splitters(panes);
  }
  if (!studio_.show_panels || !sizes_.shows_nodes || shows_probe) nodes_.hide();
  show_status(studio_, panes.status);
  show_dialogs();
  ImGui::EndDisabled();
  settle_title();
}

}  // namespace plinian::window
