// Runs what was asked for, and tells the console.
#include "host/window/commands/command_queue.h"

#include <fmt/format.h>

#include <utility>

#include "core/scene/scene_loader.h"

namespace plinian::window {

CommandQueue::CommandQueue(graph::Session& session, ConsoleLog& console, Trace& trace)
    : session_(session), console_(console), trace_(trace) {
  session_.on_echo = [this](const std::string& line) {
    if (!muted) console_.echo(line, merge_key_);
    say_the_rest();
  };
  session_.on_warning = [this](const std::string& line) { say(LineKind::warning, line); };
  session_.on_note = [this](const std::string& line) { say(LineKind::note, line); };
  session_.on_progress = [this](double share) { return tell_progress(share); };
}

CommandQueue::~CommandQueue() {
  session_.on_echo = session_.on_warning = session_.on_note = nullptr;
  session_.on_progress = nullptr;
}

// What a command has to say stands behind it.
void CommandQueue::say(LineKind kind, const std::string& line) {
  if (is_running_)
    said_.push_back({kind, line});
  else
    console_.add(kind, line);
}

void CommandQueue::say_the_rest() {
  for (const ConsoleLine& line : std::exchange(said_, {})) console_.add(line.kind, line.text);
}

void CommandQueue::run(const std::string& line, const std::string& merge_key, bool typed) {
  later([=, this] { run_now(line, merge_key, typed); });
}

bool CommandQueue::run_now(const std::string& line, const std::string& merge_key, bool typed) {
  bool done = false;
  merge_key_ = merge_key;
  const double begin = trace_.milliseconds();
  // One that is part of a job is cancelled with it.
  const bool alone = job.what.empty();
  if (alone) {
    job = {};
    line_ = line;
    began_ = std::chrono::steady_clock::now();
  }
  is_running_ = true;
  try {
    for (const std::string& answer : session_.execute(line, merge_key))
      if (typed) console_.add(LineKind::answer, answer);
    done = true;
  } catch (const SceneLoadCancelled&) {
    say_the_rest();
    console_.add(LineKind::note, line + ": cancelled");
  } catch (const std::exception& error) {
    if (typed) console_.add(LineKind::command, line);
    say_the_rest();
    console_.add(LineKind::error, error.what());
  }
  is_running_ = false;
  say_the_rest();
  merge_key_.clear();
  if (alone) job = {};
  if (done && ran) ran(line);
  if (trace_.is_on()) trace_.note(fmt::format("ran {} ({:.1f} ms)", line, trace_.milliseconds() - begin));
  return done;
}

void CommandQueue::end_drag() {
  later([this] { session_.history().end_merge(); });
}

void CommandQueue::work_off() {
  // What a task asks for comes after what was asked before.
  std::vector<std::function<void()>> now = std::exchange(tasks_, {});
  for (const std::function<void()>& task : now) task();
}

std::string CommandQueue::new_merge_key(const std::string& what) {
  return fmt::format("{} {}", what, ++drags_);
}

bool CommandQueue::tell_progress(double share) {
  job.share = share;
  const auto now = std::chrono::steady_clock::now();
  // What is done in a moment is not worth a box over the picture.
  if (job.what.empty() && now - began_ > std::chrono::milliseconds(150)) job.what = line_;
  if (draw_meanwhile && now - drawn_meanwhile_ > std::chrono::milliseconds(30)) {
    draw_meanwhile();
    drawn_meanwhile_ = std::chrono::steady_clock::now();
  }
  return !job.cancelled;
}

}  // namespace plinian::window
