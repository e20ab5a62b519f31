// Runs the .vdb worker, a small program of its own that is the only one of ours to link OpenVDB, and holds it
// to limits on time and memory.
//
// Why a program and not a fork: OpenVDB may crash, hang or take all memory on a malformed file, so it has to
// run elsewhere; a forked child of a process with threads may only call async-signal-safe functions until it
// execs (POSIX fork), and parsing allocates. Executing ourselves again would need a hook in every program
// that links this library: tests, a Python module, a DCC. A worker also keeps OpenVDB, TBB's allocator and
// Boost out of hosts that carry other versions of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/media/vdb_protocol.h"

namespace plinian::vdb {

struct WorkerJob {
  std::string request;         // JSON
  double time_limit_s = 10.0;  // [s] of wall clock until the worker is killed
  /// Appends the next framed message for the worker; returns false, appending nothing, when there are no
  /// more.
  std::function<bool(std::vector<std::byte>&)> more_input;
  /// Called for every message of the worker. May throw: the worker is killed and the exception passed on.
  std::function<void(MessageKind, std::span<const std::byte>)> on_message;
  /// Asked 20 times a second or more; returning false kills the worker.
  std::function<bool()> keep_going;
};

struct WorkerEnd {
  enum class Kind { finished, cancelled, out_of_time, out_of_memory, crashed, exited };
  Kind kind = Kind::finished;
  int code = 0;       // the signal of a crash, the status of an exit
  std::string noise;  // first line of what it wrote to its standard error, made printable
};

/// Starts a worker, talks to it and reaps it; on every way out no process, descriptor or file is left behind.
/// Throws std::runtime_error where the worker cannot be found or started, or breaks the protocol.
WorkerEnd run_worker(const WorkerJob& job);

/// The worker program, plinian-vdb-worker or what $PLINIAN_VDB_WORKER names: see companion_path. Throws
/// std::runtime_error.
std::string worker_path();

}  // namespace plinian::vdb
