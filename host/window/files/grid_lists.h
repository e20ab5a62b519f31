// Which grids the .vdb files have that a scene reads, listed beside the window by the process that parses
// such files (list_vdb). What was listed is kept until the file changes.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/media/vdb_reader.h"
#include "host/nodes/volume_store.h"
#include "host/window/platform/newest_worker.h"

namespace plinian::window {

struct GridList {
  std::string path;                // that was asked for
  std::vector<VdbGridInfo> grids;  // of a sequence those of its first, middle and last file, each once
  std::string problem;             // why there are none, one line
};

class GridLists {
 public:
  /// wake: called on a thread of its own when a list is there; must not block.
  explicit GridLists(std::function<void()> wake);
  ~GridLists();

  /// The grids of a file or sequence, or null until they are listed. To be called while they are wanted:
  /// looks now and then whether the file has changed.
  std::shared_ptr<const GridList> of(const std::string& path);
  /// Files that were parsed, ever.
  int reads() const { return reads_; }

 private:
  struct Kept {
    nodes::FileStamp stamp;
    std::vector<VdbGridInfo> grids;
    std::string problem;
  };
  GridList list(const std::string& path);
  const Kept& read(const std::string& path);

  std::string asked_;
  std::chrono::steady_clock::time_point when_{};
  std::map<std::string, Kept> kept_;  // the worker's
  std::atomic<int> reads_{0};
  std::atomic<bool> stopping_{false};
  NewestWorker<std::string, GridList> worker_;  // last: it uses the rest
};

/// What a grid is, in a few words: "float fog volume", "vec3s".
std::string kind_text(const VdbGridInfo& grid);
/// How large it is in voxels: "128 x 200 x 128", or "empty".
std::string extent_text(const VdbGridInfo& grid);

}  // namespace plinian::window
