// Folders that a file browser offers beside its list.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plinian::window {

struct Place {
  std::string label;  // "Home", or the folder's name; with the one above it where two are called alike
  std::filesystem::path folder;
};

struct Places {
  std::vector<Place> fixed;      // home, the working folder, the scene's
  std::vector<Place> recent;     // of files that were used lately, newest first
  std::vector<Place> bookmarks;  // the user's own, all of them
};

/// scene: the folder of the scene that is open; empty for none. recent: files or sequences. No folder stands
/// twice among `fixed` and `recent`.
Places places_of(const std::filesystem::path& scene, const std::vector<std::string>& recent,
                 const std::vector<std::filesystem::path>& bookmarks);

}  // namespace plinian::window
