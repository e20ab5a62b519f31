#include "host/cli/input_lines.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "host/cli/interruption.h"

namespace plinian::cli {

std::optional<std::string> InputLines::next() {
  for (;;) {
    if (interrupted()) return std::nullopt;
    if (const std::size_t end = waiting_.find('\n', searched_); end != std::string::npos) {
      std::string line = waiting_.substr(0, end);
      waiting_.erase(0, end + 1);
      searched_ = 0;
      return line;
    }
    searched_ = waiting_.size();
    if (ended_ || waiting_.size() > longest_) {
      searched_ = 0;
      if (waiting_.empty()) return std::nullopt;
      return std::exchange(waiting_, {});
    }
    // A read is begun anew after a signal, so that it would not hear of one.
    constexpr int pause_ms = 100;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, pause_ms) <= 0) continue;
    char buffer[1 << 16];
    const ssize_t count = read(STDIN_FILENO, buffer, sizeof buffer);
    if (count > 0) waiting_.append(buffer, std::size_t(count));
    ended_ = count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN);
  }
}

}  // namespace plinian::cli
