// A few words that were used lately, newest first, kept in a file, one a line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plinian::window {

class RecentLines {
 public:
  /// file: made when it is needed; empty: nothing is kept. most: lines; what is over it is forgotten.
  RecentLines(std::filesystem::path file, std::size_t most);

  /// Goes to the top. Other programs that run may have added to the file: it is read first. A file that
  /// cannot be written is no reason to stop.
  void add(const std::string& line);
  std::vector<std::string> all() const;
  void clear() { write({}); }

 private:
  void write(const std::vector<std::string>& lines) const;

  std::filesystem::path file_;
  std::size_t most_;
};

}  // namespace plinian::window
