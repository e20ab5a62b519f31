// Choosing a file, in the window.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/window/files/file_list.h"

namespace plinian::window {

class FileDialog {
 public:
  /// saves: the file need not exist. name: to begin with.
  void open(const std::string& title, const std::filesystem::path& folder, const std::string& name,
            std::vector<std::string> extensions, bool saves);
  /// The path that was chosen in this turn.
  std::optional<std::string> show();

 private:
  void go_to(const std::filesystem::path& folder);

  std::string title_;
  std::filesystem::path folder_;
  std::vector<std::string> extensions_;
  std::vector<FileEntry> entries_;
  std::string problem_;
  char path_[4096] = "", name_[1024] = "";
  bool saves_ = false, opens_ = false;
};

}  // namespace plinian::window
