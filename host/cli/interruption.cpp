// Handlers of signals, on the thread that the program began with: that is where commands compute.
#include "host/cli/interruption.h"

#include <signal.h>
#include <unistd.h>

#include <cstring>
#include <string_view>

#include "host/cli/command.h"
#include "host/sdk/inside_plugin.h"

namespace plinian::cli {

namespace {

constexpr int patience = 5;  // [s] for a plug-in that does not listen, after SIGTERM

std::atomic<bool> raised{false}, ends_by_itself{false};
std::atomic<int> waited{0};  // [s] for a plug-in
// They are set by signal handlers.
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void put(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

void on_interrupt(int signal) {
  raised = true;
  if (signal == SIGTERM) ends_by_itself = true;
  ::signal(signal, SIG_DFL);
  alarm(1);
}

void on_second(int) {
  const sdk::InsidePlugin* inside = sdk::InsidePlugin::current();
  alarm(1);
  if (!inside) {
    waited = 0;
    return;
  }
  const int seconds = ++waited;
  const bool ends = ends_by_itself && seconds >= patience;
  if (seconds != 1 && !ends) return;
  if (isatty(STDERR_FILENO)) put("\r\033[K");  // over a progress bar
  put(ends ? "plinian: error: ended at work" : "plinian: still at work");
  inside->write_to(STDERR_FILENO);
  if (ends) {
    put(", which does not ask whether it is cancelled\n");
    _exit(exit_cancelled);
  }
  put(ends_by_itself ? ", which ends with the program in a few seconds\n"
                     : "; Ctrl-C again ends the program at once\n");
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_flags = SA_RESTART;
  action.sa_handler = on_second;
  sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return raised;
}

const std::atomic<bool>& interrupt_flag() {
  return raised;
}

}  // namespace plinian::cli
