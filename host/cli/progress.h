// A plain progress bar on a terminal.
#pragma once

#include <chrono>
#include <string>

namespace plinian::cli {

/// Draws one line on standard error where that is a terminal and notes are not silenced; else nothing.
/// Leaves an empty line behind when it goes.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// share: [-] of the work, in [0, 1]. Returns false once the user has interrupted.
  bool operator()(double share);
  /// What stands behind the bar beside the times: "3 of at most 32 passes".
  void set_detail(std::string detail) { detail_ = std::move(detail); }

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_, detail_;
  bool visible_;
  bool drawn_ = false;
  Clock::time_point start_, last_{};
};

}  // namespace plinian::cli
