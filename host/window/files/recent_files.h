// What was opened lately, newest first, kept in the user's state folder, a path a line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plinian::window {

class RecentFiles {
 public:
  /// file: made when it is needed; empty: nothing is kept.
  explicit RecentFiles(std::filesystem::path file);

  /// Goes to the top; what is over a dozen is forgotten. Other programs that run may have added to the file:
  /// it is read first. A file that cannot be written is no reason to stop.
  void add(const std::string& path);
  /// Those that are there; sequences always are.
  std::vector<std::string> all() const;
  void clear();

 private:
  std::vector<std::string> read() const;
  void write(const std::vector<std::string>& paths) const;

  std::filesystem::path file_;
};

}  // namespace plinian::window
