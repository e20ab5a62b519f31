// Folders that the user wants to come back to, kept in the configuration folder, a path a line.
#pragma once

#include <filesystem>
#include <vector>

namespace plinian::window {

class Bookmarks {
 public:
  /// file: made when it is needed; empty: they last as long as the program.
  explicit Bookmarks(std::filesystem::path file);

  /// In the order in which they were added.
  const std::vector<std::filesystem::path>& all() const { return folders_; }
  bool has(const std::filesystem::path& folder) const;
  /// Another program that runs may have changed the file: it is read first. Twice is once.
  void add(const std::filesystem::path& folder);
  void remove(const std::filesystem::path& folder);
  /// Reads what other programs have changed.
  void refresh();

 private:
  void keep();

  std::filesystem::path file_;
  std::vector<std::filesystem::path> folders_;
};

}  // namespace plinian::window
