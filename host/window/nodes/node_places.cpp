// Reads, changes, writes.
#include "host/window/nodes/node_places.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/files/atomic_file.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

std::string absolute(const std::string& scene) {
  return fs::absolute(scene).lexically_normal().string();
}

}  // namespace

NodePlaces::NodePlaces(fs::path file) : file_(std::move(file)) {}

std::vector<NodePlaces::Entry> NodePlaces::read() const {
  constexpr std::string_view begins = "scene ";
  std::vector<Entry> entries;
  std::ifstream file(file_);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(begins) && line.find('/') != line.npos) {
      entries.push_back({line.substr(begins.size()), {}});
      continue;
    }
    std::istringstream words(line);
    std::string name;
    vec2 place;
    if (!entries.empty() && words >> name >> place.x >> place.y && std::isfinite(place.x + place.y))
      entries.back().places[name] = place;
  }
  return entries;
}

PlacesByName NodePlaces::of(const std::string& scene) const {
  if (scene.empty()) return {};
  for (Entry& entry : read())
    if (entry.scene == absolute(scene)) return std::move(entry.places);
  return {};
}

void NodePlaces::keep(const std::string& scene, const PlacesByName& places) {
  if (file_.empty() || scene.empty() || scene.find('\n') != scene.npos) return;
  constexpr std::size_t most = 40;
  std::vector<Entry> entries = read();
  std::erase_if(entries, [&](const Entry& entry) { return entry.scene == absolute(scene); });
  entries.insert(entries.begin(), {absolute(scene), places});
  if (entries.size() > most) entries.resize(most);
  std::string text;
  for (const Entry& entry : entries) {
    text += "scene " + entry.scene + "\n";
    for (const auto& [name, place] : entry.places)
      text += fmt::format("{} {:.0f} {:.0f}\n", name, place.x, place.y);
  }
  std::error_code ignored;
  fs::create_directories(file_.parent_path(), ignored);
  try {
    write_file(file_.string(), std::string_view(text));
  } catch (const FileError&) {
    // Places are a convenience.
  }
}

}  // namespace plinian::window
