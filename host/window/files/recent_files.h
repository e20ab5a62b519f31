// What was opened lately, newest first, kept in the user's state folder, a path a line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/window/files/recent_lines.h"

namespace plinian::window {

class RecentFiles {
 public:
  /// file: as of RecentLines.
  explicit RecentFiles(std::filesystem::path file);

  /// Goes to the top; what is over a dozen is forgotten.
  void add(const std::string& path);
  /// Those that are there; sequences always are.
  std::vector<std::string> all() const;
  void clear() { lines_.clear(); }

 private:
  RecentLines lines_;
};

}  // namespace plinian::window
