// Asks, keeps, and looks whether a file is another one by now.
#include "host/window/files/grid_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/media/frame_sequence.h"

namespace plinian::window {

namespace {

constexpr std::size_t most_kept = 64;  // files

// Of a sequence those files that are likely to differ: what burns may not do so at the beginning.
std::vector<std::string> files_of(const std::string& path) {
  const auto pattern = FramePattern::parse(path);
  // A file may be called like a pattern.
  if (!pattern || nodes::stamp_of(path) != nodes::FileStamp()) return {path};
  const std::vector<int> frames = pattern->frames_on_disk();
  std::vector<std::string> files;
  for (const std::size_t at : {std::size_t(0), frames.size() / 2, frames.size() - 1})
    if (at < frames.size()) files.push_back(pattern->path(frames[at]));
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace

GridLists::GridLists(std::function<void()> wake)
    : worker_([this](const std::string& path) { return list(path); }, std::move(wake)) {}

GridLists::~GridLists() {
  stopping_ = true;
}

std::shared_ptr<const GridList> GridLists::of(const std::string& path) {
  if (path.empty()) return nullptr;
  const auto now = std::chrono::steady_clock::now();
  if (path != asked_ || now - when_ > std::chrono::seconds(2)) {
    asked_ = path;
    when_ = now;
    worker_.ask(path);
  }
  const auto answer = worker_.answer();
  return answer && answer->path == path ? answer : nullptr;
}

const GridLists::Kept& GridLists::read(const std::string& path) {
  const nodes::FileStamp stamp = nodes::stamp_of(path);
  if (const auto found = kept_.find(path); found != kept_.end() && found->second.stamp == stamp)
    return found->second;
  if (kept_.size() >= most_kept) kept_.clear();
  Kept kept{stamp, {}, ""};
  ++reads_;
  try {
    VdbOptions options;
    options.progress = [this](double) { return !stopping_; };
    kept.grids = list_vdb(path, options).grids;
  } catch (const std::exception& error) {
    kept.problem = error.what();
  }
  return kept_[path] = std::move(kept);
}

GridList GridLists::list(const std::string& path) {
  GridList list{path, {}, ""};
  const std::vector<std::string> files = files_of(path);
  if (files.empty()) list.problem = path + ": no file of that sequence is there";
  for (const std::string& file : files) {
    const Kept& kept = read(file);
    if (list.problem.empty()) list.problem = kept.problem;
    for (const VdbGridInfo& grid : kept.grids)
      if (std::none_of(list.grids.begin(), list.grids.end(),
                       [&](const VdbGridInfo& known) { return known.name == grid.name; }))
        list.grids.push_back(grid);
  }
  return list;
}

std::string kind_text(const VdbGridInfo& grid) {
  const bool told = !grid.grid_class.empty() && grid.grid_class != "unknown";
  return told ? grid.value_type + " " + grid.grid_class : grid.value_type;
}

std::string extent_text(const VdbGridInfo& grid) {
  if (grid.dims[0] <= 0) return grid.active_voxels == 0 && grid.error.empty() ? "empty" : "";
  return fmt::format("{} x {} x {}", grid.dims[0], grid.dims[1], grid.dims[2]);
}

}  // namespace plinian::window
