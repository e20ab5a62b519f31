// What is asked for while the interface is drawn, and done between two drawings: commands to the scene, and
// tasks.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/graph/commands/session.h"
#include "host/window/console/console_log.h"
#include "host/window/platform/trace.h"

namespace plinian::window {

/// What a running job says of itself, to be shown over the panels.
struct Job {
  std::string what;    // "reading smoke.vdb"; empty: none is running
  double share = 0.0;  // [0, 1]
  bool cancelled = false;
};

class CommandQueue {
 public:
  /// What the session says goes to the console, as long as the queue lives.
  CommandQueue(graph::Session& session, ConsoleLog& console, Trace& trace);
  ~CommandQueue();
  CommandQueue(const CommandQueue&) = delete;
  CommandQueue& operator=(const CommandQueue&) = delete;

  /// Runs a command after this turn. merge_key: those of one drag share it. typed: show what it answers.
  void run(const std::string& line, const std::string& merge_key = "", bool typed = false);
  /// ... at once; for tasks. Errors go to the console. Returns whether there was none.
  bool run_now(const std::string& line, const std::string& merge_key = "", bool typed = false);
  /// Ends a drag: what follows is another step of undo.
  void end_drag();
  void later(std::function<void()> task) { tasks_.push_back(std::move(task)); }
  /// Does what was asked for.
  void work_off();
  bool has_work() const { return !tasks_.empty(); }

  /// A key for the commands of a new drag.
  std::string new_merge_key(const std::string& what);

  Job job;
  /// Draws the interface while a job runs on its thread; set by the window.
  std::function<void()> draw_meanwhile;
  /// Tells how far the job is; false where it is to end.
  bool tell_progress(double share);
  /// Told of every command that has run and did not fail.
  std::function<void(const std::string& line)> ran;
  /// Commands are not echoed: they are told as one.
  bool muted = false;

 private:
  graph::Session& session_;
  ConsoleLog& console_;
  Trace& trace_;
  std::vector<std::function<void()>> tasks_;
  void say(LineKind kind, const std::string& line);
  void say_the_rest();

  std::string merge_key_;  // of the command that runs
  std::string line_;       // the command that runs by itself, and since when
  std::chrono::steady_clock::time_point began_{};
  std::vector<ConsoleLine> said_;  // by the command that runs: comes behind its echo
  bool is_running_ = false;
  std::uint64_t drags_ = 0;
  std::chrono::steady_clock::time_point drawn_meanwhile_{};
};

}  // namespace plinian::window
