// The folders beside a file browser's list, and bookmarks that come and go.
#pragma once

#include <filesystem>
#include <optional>

#include "core/shared/glue.h"
#include "host/window/files/bookmarks.h"
#include "host/window/files/places.h"

namespace plinian::window {

class Trace;

class PlaceList {
 public:
  explicit PlaceList(std::filesystem::path bookmarks) : bookmarks_(std::move(bookmarks)) {}

  /// As of places_of.
  void begin(std::filesystem::path scene, std::vector<std::string> recent);
  /// here: the folder that is looked at. size: [points]. The folder that was clicked.
  std::optional<std::filesystem::path> show(Trace& trace, const std::filesystem::path& here, vec2 size);

 private:
  enum class Click { none, place, cross };
  Click show_place(Trace& trace, const Place& place, const std::filesystem::path& here, bool has_cross);
  void gather();

  Bookmarks bookmarks_;
  std::filesystem::path scene_;
  std::vector<std::string> recent_;
  Places places_;
};

}  // namespace plinian::window
