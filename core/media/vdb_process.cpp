// The parent's side of the .vdb worker: finding, starting, feeding, listening, stopping. See vdb_process.h.
#include "core/media/vdb_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "core/files/companion.h"

extern char** environ;

namespace plinian::vdb {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string("cannot start the .vdb reader: ") + what + ": " +
                           std::strerror(errno));
}

class Descriptor {
 public:
  Descriptor() = default;
  /// Takes fd over, moved clear of the standard ones so that dup2 in the child cannot hit it.
  explicit Descriptor(int fd) : fd_(fd) {
    if (fd_ < 0 || fd_ > 2) return;
    const int moved = ::fcntl(fd_, F_DUPFD_CLOEXEC, 3);
    ::close(fd_);
    fd_ = moved;
  }
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() { close(); }
  void close() {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  }
  int get() const { return fd_; }
  bool open() const { return fd_ >= 0; }

 private:
  int fd_ = -1;
};

/// A running worker; killed and reaped on destruction.
class Process {
 public:
  Process(const std::string& program, int standard_in, int standard_out, int standard_error) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&actions, standard_in, 0);
    posix_spawn_file_actions_adddup2(&actions, standard_out, 1);
    posix_spawn_file_actions_adddup2(&actions, standard_error, 2);
    // A program that ignores or blocks signals would otherwise hand that on.
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    char* const arguments[] = {const_cast<char*>(program.c_str()), nullptr};
    const int error = posix_spawn(&pid_, program.c_str(), &actions, &attributes, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) {
      errno = error;
      fail(program.c_str());
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    kill();
    wait();
  }
  void kill() {
    if (pid_ > 0) ::kill(pid_, SIGKILL);
  }
  /// Whether it has ended by now; its status is then known.
  bool ended() { return pid_ < 0 || reap(WNOHANG); }
  void wait() {
    if (pid_ > 0) reap(0);
  }
  int status() const { return status_; }

 private:
  bool reap(int flags) {
    pid_t got;
    do {
      got = ::waitpid(pid_, &status_, flags);
    } while (got < 0 && errno == EINTR);
    if (got == 0) return false;
    // ECHILD: the host program ignores SIGCHLD and the kernel has reaped it; what it said has to do.
    if (got < 0) status_ = 0;
    pid_ = -1;
    return true;
  }
  pid_t pid_ = -1;
  int status_ = 0;
};

/// Splits what arrives into messages.
class Inbox {
 public:
  explicit Inbox(const WorkerJob& job) : job_(job), buffer_(2 * max_blocks_bytes) {}

  /// Reads once; returns false at the end of the stream.
  bool read(int fd) {
    if (filled_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
    const ssize_t got = ::read(fd, buffer_.data() + filled_, buffer_.size() - filled_);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) return true;
    if (got <= 0) return false;
    filled_ += static_cast<std::size_t>(got);
    deliver();
    return true;
  }

 private:
  void deliver() {
    std::size_t at = 0;
    MessageHeader header;
    while (filled_ - at >= sizeof header) {
      std::memcpy(&header, buffer_.data() + at, sizeof header);
      check(header);
      if (filled_ - at - sizeof header < header.bytes) break;
      ended_ = header.kind == MessageKind::result || header.kind == MessageKind::failure;
      job_.on_message(header.kind, std::span(buffer_).subspan(at + sizeof header, header.bytes));
      at += sizeof header + header.bytes;
    }
    std::memmove(buffer_.data(), buffer_.data() + at, filled_ - at);
    filled_ -= at;
  }
  void check(const MessageHeader& header) const {
    std::size_t most = 0;
    switch (header.kind) {
      case MessageKind::blocks:
        most = max_blocks_bytes;
        break;
      case MessageKind::progress:
        most = sizeof(float);
        break;
      case MessageKind::result:
      case MessageKind::failure:
        most = max_json_bytes;
        break;
      default:
        throw std::runtime_error("the reader sent nonsense");
    }
    if (ended_ || header.bytes > most) throw std::runtime_error("the reader sent nonsense");
  }

  const WorkerJob& job_;
  std::vector<std::byte> buffer_;
  std::size_t filled_ = 0;
  bool ended_ = false;
};

/// What goes to the worker: the request, then whatever more_input gives.
class Outbox {
 public:
  explicit Outbox(const WorkerJob& job) : job_(job) {
    append_message(pending_, MessageKind::request, job.request.data(), job.request.size());
  }
  /// Sends what fits; returns false when all is sent or nobody listens any more.
  bool send(int fd) {
    if (sent_ == pending_.size()) {
      pending_.clear();
      sent_ = 0;
      if (!job_.more_input || !job_.more_input(pending_)) return false;
    }
    const ssize_t put =
        ::send(fd, pending_.data() + sent_, pending_.size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (put < 0) return errno == EINTR || errno == EAGAIN;
    sent_ += static_cast<std::size_t>(put);
    return true;
  }

 private:
  const WorkerJob& job_;
  std::vector<std::byte> pending_;
  std::size_t sent_ = 0;
};

/// Keeps the start of what the worker writes to its standard error.
bool read_noise(int fd, std::string& noise) {
  char text[4096];
  const ssize_t got = ::read(fd, text, sizeof text);
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return true;
  if (got <= 0) return false;
  if (noise.size() < sizeof text) noise.append(text, static_cast<std::size_t>(got));
  return true;
}

std::string first_line(const std::string& noise) {
  std::string line = noise.substr(0, std::min<std::size_t>(noise.find('\n'), 400));
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return line;
}

}  // namespace

WorkerEnd run_worker(const WorkerJob& job) {
  int pair[2], out[2], err[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) fail("no socket");
  Descriptor input(pair[0]), child_input(pair[1]);
  if (::pipe2(out, O_CLOEXEC) != 0) fail("no pipe");
  Descriptor output(out[0]), child_output(out[1]);
  if (::pipe2(err, O_CLOEXEC) != 0) fail("no pipe");
  Descriptor errors(err[0]), child_errors(err[1]);
  ::fcntl(output.get(), F_SETPIPE_SZ, 1 << 20);  // fewer turns per megabyte; where it is refused, more

  Process process(worker_path(), child_input.get(), child_output.get(), child_errors.get());
  child_input.close();
  child_output.close();
  child_errors.close();

  Inbox inbox(job);
  Outbox outbox(job);
  WorkerEnd end;
  Clock::time_point now = Clock::now();
  Clock::time_point deadline =
      now + std::chrono::duration_cast<Clock::duration>(Seconds(std::min(job.time_limit_s, 1e8)));
  const auto watch = [&] {
    // Time in which this process itself stood still (stopped at a terminal, asleep) is not the worker's.
    const Clock::time_point before = std::exchange(now, Clock::now());
    if (now - before > std::chrono::seconds(3)) deadline += now - before;
    if (job.keep_going && !job.keep_going()) end.kind = WorkerEnd::Kind::cancelled;
    if (now > deadline) end.kind = WorkerEnd::Kind::out_of_time;
    return end.kind == WorkerEnd::Kind::finished;
  };
  // The errors' pipe is drained along the way, but only the output's end means that the worker is done: a
  // grandchild, or a library that keeps descriptors, must not hold us up.
  while (output.open() && watch()) {
    pollfd polls[3] = {{output.get(), POLLIN, 0}, {errors.get(), POLLIN, 0}, {input.get(), POLLOUT, 0}};
    const int ready = ::poll(polls, 3, 50);
    if (ready < 0 && errno != EINTR) fail("poll");
    if (ready <= 0) continue;
    if (polls[2].revents != 0 && !outbox.send(input.get())) {
      ::shutdown(input.get(), SHUT_WR);
      input.close();
    }
    if (polls[1].revents != 0 && !read_noise(errors.get(), end.noise)) errors.close();
    if (polls[0].revents != 0 && !inbox.read(output.get())) output.close();
  }
  for (int nap_us = 100; end.kind == WorkerEnd::Kind::finished && !process.ended() && watch();
       nap_us = std::min(2 * nap_us, 10000))
    std::this_thread::sleep_for(std::chrono::microseconds(nap_us));
  if (end.kind != WorkerEnd::Kind::finished) process.kill();
  process.wait();
  if (errors.open()) {
    ::fcntl(errors.get(), F_SETFL, O_NONBLOCK);
    read_noise(errors.get(), end.noise);
  }
  end.noise = first_line(end.noise);

  if (end.kind != WorkerEnd::Kind::finished) return end;
  const int status = process.status();
  if (WIFSIGNALED(status)) {
    end.code = WTERMSIG(status);
    end.kind =
        end.code == SIGXCPU || end.code == SIGALRM ? WorkerEnd::Kind::out_of_time : WorkerEnd::Kind::crashed;
  } else if (WIFEXITED(status) && WEXITSTATUS(status) != 0) {
    end.code = WEXITSTATUS(status);
    end.kind = end.code == exit_out_of_memory ? WorkerEnd::Kind::out_of_memory : WorkerEnd::Kind::exited;
  }
  return end;
}

std::string worker_path() {
  return companion_path({"plinian-vdb-worker", "PLINIAN_VDB_WORKER", "the .vdb reader"});
}

}  // namespace plinian::vdb
