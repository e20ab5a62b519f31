// Read by the line, written at once.
#include "host/window/files/line_file.h"

#include <fstream>

#include "core/files/atomic_file.h"

namespace plinian::window {

namespace fs = std::filesystem;

std::vector<std::string> read_lines(const fs::path& file) {
  std::vector<std::string> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

bool write_lines(const fs::path& file, const std::vector<std::string>& lines) {
  if (file.empty()) return false;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  try {
    write_file(file.string(), std::string_view(text));
    return true;
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace plinian::window
