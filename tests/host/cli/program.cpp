#include "tests/host/cli/program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>

namespace plinian {

int Ended::error_lines() const {
  return int(std::count(err.begin(), err.end(), '\n'));
}

std::string program_path() {
  return PLINIAN_PROGRAM;
}

Ended plinian_program(const std::vector<std::string>& arguments, const RunOptions& options) {
  int out[2], err[2];
  if (pipe2(out, O_CLOEXEC) != 0 || pipe2(err, O_CLOEXEC) != 0) throw std::runtime_error("no pipes");
  std::vector<std::string> words = {PLINIAN_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  // Opened here: another user may not be let into the folder that it lies in.
  const int program = open(PLINIAN_PROGRAM, O_RDONLY | O_CLOEXEC);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    dup2(out[1], STDOUT_FILENO);
    dup2(err[1], STDERR_FILENO);
    if (options.user != 0 && (setgid(options.user) != 0 || setuid(options.user) != 0)) _exit(126);
    if (chdir(options.folder.c_str()) != 0) _exit(126);
    setenv("XDG_CONFIG_HOME", "/nonexistent", 1);
    setenv("XDG_STATE_HOME", "/nonexistent", 1);
    unsetenv("DISPLAY");  // no window opens because somebody has one
    unsetenv("WAYLAND_DISPLAY");
    for (const auto& [name, value] : options.environment) setenv(name.c_str(), value.c_str(), 1);
    fexecve(program, argv.data(), environ);
    _exit(127);
  }
  close(program);
  close(out[1]);
  close(err[1]);

  Ended ended;
  auto start = std::chrono::steady_clock::now();
  bool counting = options.signal_after_text.empty();
  bool signalled = options.signal_after_s <= 0.0;
  pollfd pipes[2] = {{out[0], POLLIN, 0}, {err[0], POLLIN, 0}};
  std::string* texts[2] = {&ended.out, &ended.err};
  int left = 2;
  while (left > 0) {
    poll(pipes, 2, 20);
    if (!counting && (ended.err + ended.out).find(options.signal_after_text) != std::string::npos) {
      start = std::chrono::steady_clock::now();
      counting = true;
    }
    if (counting && !signalled &&
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() >
            options.signal_after_s) {
      kill(child, options.signal);
      signalled = true;
    }
    for (int i = 0; i < 2; ++i) {
      if (pipes[i].fd < 0 || pipes[i].revents == 0) continue;
      char buffer[4096];
      const ssize_t size = read(pipes[i].fd, buffer, sizeof buffer);
      if (size > 0) {
        texts[i]->append(buffer, std::size_t(size));
      } else {
        close(pipes[i].fd);
        pipes[i].fd = -1;
        --left;
      }
    }
  }
  int status = 0;
  rusage used = {};
  wait4(child, &status, 0, &used);
  ended.peak_memory = used.ru_maxrss;
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ended;
}

}  // namespace plinian
