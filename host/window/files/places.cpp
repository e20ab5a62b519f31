// Gathers and labels.
#include "host/window/files/places.h"

#include <algorithm>
#include <cstdlib>
#include <map>

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_recent = 6;

std::string name_of(const fs::path& folder) {
  return folder.has_filename() ? folder.filename().string() : folder.string();
}

// "sim" twice is "shot1/sim" and "shot2/sim".
void label(std::vector<Place>& places) {
  std::map<std::string, int> count;
  for (const Place& place : places) ++count[name_of(place.folder)];
  for (Place& place : places) {
    const std::string name = name_of(place.folder);
    const bool alone = count[name] == 1 || !place.folder.parent_path().has_filename();
    place.label = alone ? name : name_of(place.folder.parent_path()) + "/" + name;
  }
}

}  // namespace

Places places_of(const fs::path& scene, const std::vector<std::string>& recent,
                 const std::vector<fs::path>& bookmarks) {
  Places places;
  const auto has = [](const std::vector<Place>& list, const fs::path& folder) {
    return std::any_of(list.begin(), list.end(), [&](const Place& p) { return p.folder == folder; });
  };
  const auto add = [&](const char* name, const fs::path& folder) {
    if (folder.is_absolute() && !has(places.fixed, folder)) places.fixed.push_back({name, folder});
  };
  const char* home = std::getenv("HOME");
  std::error_code error;
  add("Home", home ? fs::path(home) : fs::path());
  add("Scene", scene);
  add("Working folder", fs::current_path(error));
  for (const std::string& path : recent) {
    const fs::path folder = fs::path(path).parent_path();
    if (places.recent.size() == most_recent) break;
    if (folder.is_absolute() && !has(places.fixed, folder) && !has(places.recent, folder))
      places.recent.push_back({"", folder});
  }
  for (const fs::path& folder : bookmarks) places.bookmarks.push_back({"", folder});
  label(places.recent);
  label(places.bookmarks);
  return places;
}

}  // namespace plinian::window
