// Errands for the .vdb worker. See vdb_task.h.
#include "core/media/vdb_task.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/media/vdb_process.h"

namespace plinian::vdb {
namespace {

std::string sentence(const WorkerEnd& end, const Limits& limits) {
  switch (end.kind) {
    case WorkerEnd::Kind::out_of_time:
      return fmt::format(
          "reading was stopped after {:.3g} s; the file may be damaged, else --vdb-time-limit allows more",
          limits.seconds);
    case WorkerEnd::Kind::out_of_memory:
      return fmt::format(
          "reading takes more than the {} MiB that it may; the file may be damaged, else --vdb-memory-limit "
          "allows more",
          limits.memory_bytes >> 20);
    case WorkerEnd::Kind::crashed:
      return fmt::format("the file is damaged: the reader crashed on it (signal {})", end.code);
    default:
      return fmt::format("the reader failed (status {}){}{}", end.code, end.noise.empty() ? "" : ": ",
                         end.noise);
  }
}

}  // namespace

Limits limits_for(std::uint64_t file_bytes, const VdbOptions& options) {
  if (options.time_limit_s < 0.0 || !std::isfinite(options.time_limit_s))
    throw VdbError("--vdb-time-limit: it is a number of seconds, 0 for automatic");
  Limits limits{options.time_limit_s, options.memory_limit_bytes, 0};
  if (limits.seconds == 0.0) limits.seconds = 10.0 + double(file_bytes) / 4e6;
  if (limits.memory_bytes == 0) {
    // A tree takes up to 35 times its bytes on disk (an internal node's masks against its table), with
    // doubles twice that; compressed voxels seldom more than 20 times.
    const std::uint64_t wanted = (384ull << 20) + 96 * file_bytes;
    const std::uint64_t machine = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                                  static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    limits.memory_bytes = std::min(wanted, std::max<std::uint64_t>(1ull << 30, machine / 4 * 3));
  }
  limits.voxel_bytes = limits.memory_bytes / 2;
  return limits;
}

nlohmann::json run_task(const Task& task) {
  nlohmann::json request = task.request;
  request["protocol"] = protocol_version;
  request["path"] = std::vector<std::uint8_t>(task.path.begin(), task.path.end());
  request["time_limit_s"] = task.limits.seconds;
  request["memory_limit_bytes"] = task.limits.memory_bytes;
  request["voxel_limit_bytes"] = task.limits.voxel_bytes;

  WorkerJob job;
  job.request = request.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  job.time_limit_s = task.limits.seconds;
  job.more_input = task.more_input;
  double share = 0.0;
  if (task.progress) job.keep_going = [&] { return task.progress(share); };
  std::string result, failure;
  job.on_message = [&](MessageKind kind, std::span<const std::byte> payload) {
    if (kind == MessageKind::blocks && task.on_blocks) {
      task.on_blocks(payload);
    } else if (kind == MessageKind::progress && payload.size() == sizeof(float)) {
      float value;
      std::memcpy(&value, payload.data(), sizeof value);
      if (value > share && value <= 1.0f) share = value;
    } else if (kind == MessageKind::result || kind == MessageKind::failure) {
      (kind == MessageKind::result ? result : failure)
          .assign(reinterpret_cast<const char*>(payload.data()), payload.size());
    } else {
      throw std::runtime_error("the reader sent nonsense");
    }
  };
  WorkerEnd end;
  try {
    end = run_worker(job);
    if (end.kind == WorkerEnd::Kind::finished && failure.empty()) return nlohmann::json::parse(result);
  } catch (const nlohmann::json::exception&) {
    throw VdbError(task.path + ": the file is damaged: the reader sent nonsense");
  } catch (const VdbError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw VdbError(task.path + ": " + error.what());
  }
  if (end.kind == WorkerEnd::Kind::cancelled) throw VdbCancelled();
  if (end.kind == WorkerEnd::Kind::finished) {
    // Whatever the failure quotes from the file must not reach a terminal raw.
    for (char& c : failure)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    throw VdbError(task.path + ": " + failure.substr(0, 4000));
  }
  throw VdbError(task.path + ": " + sentence(end, task.limits));
}

}  // namespace plinian::vdb
