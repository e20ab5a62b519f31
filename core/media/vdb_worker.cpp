// plinian-vdb-worker: parses, lists or writes one .vdb file for the program that started it (vdb_process.h).
//
// It reads a request from its standard input and answers on its standard output (vdb_protocol.h). Everything
// that OpenVDB does wrong with a malformed file happens in here, under the limits that the request sets.
#include <fcntl.h>
#include <malloc.h>
#include <openvdb/openvdb.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <thread>

#include "core/media/vdb_worker_file.h"
#include "core/media/vdb_worker_pipe.h"
#include "core/media/vdb_worker_read.h"
#include "core/media/vdb_worker_write.h"

namespace plinian::vdb {
namespace {

/// Threads take address space, which is limited, and reading is one thread's work for the most part.
unsigned thread_count() {
  return std::clamp(std::thread::hardware_concurrency(), 1u, 4u);
}

void set_limits(const nlohmann::json& request) {
  const auto limit = [](auto resource, std::uint64_t amount) {
    const rlimit value{amount, amount};
    ::setrlimit(resource, &value);  // where it is refused, a harder limit is in force already
  };
  limit(RLIMIT_CORE, 0);
  // The parent watches the clock; this is for the case that it is killed itself.
  const double seconds = request.at("time_limit_s").get<double>() * thread_count();
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::clamp(seconds, 1.0, 1e8)) + 2);
#ifndef __SANITIZE_ADDRESS__  // which maps terabytes that it never touches
  limit(RLIMIT_AS, request.at("memory_limit_bytes").get<std::uint64_t>() + worker_base_bytes);
#endif
  std::set_new_handler([] { std::_Exit(exit_out_of_memory); });
}

void run(Inlet& inlet, const Outlet& outlet) {
  const nlohmann::json request = inlet.request();
  if (request.at("protocol").get<std::uint32_t>() != protocol_version)
    throw BadFile("plinian-vdb-worker is of another version than the program; install both together");
  set_limits(request);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, thread_count());
  openvdb::initialize();
  const std::string task = request.at("task").get<std::string>();
  if (task == "read")
    read_file(request, outlet);
  else if (task == "list")
    list_file(request, outlet);
  else if (task == "write")
    write_file(request, inlet, outlet);
  else
    throw BadFile("an unknown task");
}

}  // namespace
}  // namespace plinian::vdb

int main() {
  using namespace plinian::vdb;
  if (::isatty(0)) {
    std::fputs("plinian-vdb-worker reads .vdb files for plinian; it is not for use by hand\n", stderr);
    return 2;
  }
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::mallopt(M_ARENA_MAX, 2);  // as for threads
  ::setenv("OPENVDB_DISABLE_DELAYED_LOAD", "1", 1);
  // What libraries print must not run into the answers; what else the parent had open is not ours.
  ::dup2(1, 3);
  ::dup2(2, 1);
  ::close_range(4, ~0u, 0);
  Inlet inlet(0);
  const Outlet outlet(3);
  try {
    run(inlet, outlet);
  } catch (const std::exception& error) {
    outlet.failure(error.what());
  }
}
