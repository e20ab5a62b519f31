// What a folder holds, as a file browser lists it: folders first, sequences of files as one line each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plinian::window {

struct FileEntry {
  std::string name;   // as it is opened: "smoke.####.vdb" for a sequence
  std::string label;  // as it is listed: "smoke.####.vdb  1-48"
  bool is_folder = false;
};

/// extensions: with their dots; empty for all files. Hidden files are left out. A folder that cannot be read
/// has no entries; why stands in `problem` where it is given.
std::vector<FileEntry> list_files(const std::filesystem::path& folder,
                                  const std::vector<std::string>& extensions, std::string* problem = nullptr);

}  // namespace plinian::window
