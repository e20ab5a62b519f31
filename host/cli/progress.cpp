// Progress on a terminal.
#include "host/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "host/cli/console.h"
#include "host/cli/interruption.h"

namespace plinian::cli {

namespace {

std::string time_text(double seconds) {
  const int whole = int(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

}  // namespace

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), visible_(isatty(STDERR_FILENO) && !is_quiet()), start_(Clock::now()) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

bool ProgressBar::operator()(double share) {
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  // What is over in a blink needs no bar, and ten lines a second are enough.
  if (visible_ && elapsed > 0.3 && std::chrono::duration<double>(now - last_).count() > 0.1) {
    last_ = now;
    drawn_ = true;
    share = std::clamp(share, 0.0, 1.0);
    const int width = 30, full = int(share * width);
    std::string behind = detail_.empty() ? fmt::format("{:3.0f}%", share * 100.0) : detail_;
    behind += ", " + time_text(elapsed);
    if (interrupted())
      behind += ", ending (Ctrl-C again: at once)";
    else if (share > 0.01)
      behind += fmt::format(", {}{} left", detail_.empty() ? "" : "at most ",
                            time_text(elapsed * (1.0 - share) / share));
    std::fputs(fmt::format("\r{} [{}{}] {}\033[K", label_, std::string(std::size_t(full), '#'),
                           std::string(std::size_t(width - full), '.'), behind)
                   .c_str(),
               stderr);
    std::fflush(stderr);
  }
  return !interrupted();
}

}  // namespace plinian::cli
