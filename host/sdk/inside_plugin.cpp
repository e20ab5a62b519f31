// The marks of threads, and what a signal handler makes of them. Nothing here allocates once a plug-in runs.
#include "host/sdk/inside_plugin.h"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <memory>

namespace plinian::sdk {

namespace {

thread_local const InsidePlugin* innermost = nullptr;
bool telling = false;

// A stack for the handler of one thread: who has overrun its own can still say so.
class HandlerStack {
 public:
  HandlerStack() {
    stack_t stack{};
    stack.ss_sp = memory_.get();
    stack.ss_size = size;
    sigaltstack(&stack, nullptr);
  }
  ~HandlerStack() {
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
  }

 private:
  static constexpr std::size_t size = 64 << 10;  // [bytes]
  std::unique_ptr<char[]> memory_ = std::make_unique<char[]>(size);
};

void put(int descriptor, const char* text) {
  [[maybe_unused]] const ssize_t written = ::write(descriptor, text, std::strlen(text));
}

const char* name_of(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "segmentation fault (SIGSEGV)";
    case SIGBUS:
      return "bus error (SIGBUS)";
    case SIGFPE:
      return "arithmetic error (SIGFPE)";
    case SIGILL:
      return "illegal instruction (SIGILL)";
    default:
      return "aborted (SIGABRT)";
  }
}

// The action is back at its default when this runs, and ends the program once it returns.
void on_crash(int signal) {
  put(STDERR_FILENO, "plinian: error: ");
  put(STDERR_FILENO, name_of(signal));
  if (innermost)
    innermost->write_to(STDERR_FILENO);
  else
    put(STDERR_FILENO, " in the program itself");
  put(STDERR_FILENO, "\n");
  ::raise(signal);
}

// What a plug-in has no right to do must not pass for an end of the program's own.
void on_exit() {
  if (!innermost) return;
  put(STDERR_FILENO, "plinian: error: the program was ended by a call of exit");
  innermost->write_to(STDERR_FILENO);
  put(STDERR_FILENO, "\n");
  ::_exit(1);
}

}  // namespace

InsidePlugin::InsidePlugin(const std::string& owner, const char* doing, const char* subject, const char* part)
    : owner_(owner.c_str()), doing_(doing), subject_(subject), part_(part), outer_(innermost) {
  if (telling) static thread_local const HandlerStack stack;
  innermost = this;
}

InsidePlugin::InsidePlugin(const InsidePlugin* other)
    : owner_(other ? other->owner_ : ""),
      doing_(other ? other->doing_ : ""),
      subject_(other ? other->subject_ : ""),
      part_(other ? other->part_ : ""),
      outer_(innermost) {
  innermost = this;
}

InsidePlugin::~InsidePlugin() {
  innermost = outer_;
}

const InsidePlugin* InsidePlugin::current() {
  return innermost;
}

void InsidePlugin::write_to(int descriptor) const {
  put(descriptor, " in ");
  put(descriptor, *owner_ ? owner_ : "the program itself");
  if (!*doing_) return;
  put(descriptor, " while ");
  put(descriptor, doing_);
  if (!*subject_) return;
  put(descriptor, " ");
  put(descriptor, subject_);
  if (!*part_) return;
  put(descriptor, ".");
  put(descriptor, part_);
}

void tell_of_crashes() {
  telling = true;
  std::atexit(on_exit);
  static const HandlerStack stack;
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = SA_RESETHAND | SA_ONSTACK | SA_NODEFER;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(signal, &action, nullptr);
}

}  // namespace plinian::sdk
