// Where the boxes of the node editor stand, over sessions.
//
// They are the interface's memory, not the scene's: to move a box changes no picture, so it is no edit, makes
// no scene unsaved and takes no step of undo away from what does. They are kept by the path of the scene and
// the names of its nodes, in the user's state folder:
//
//   scene /shows/ash/shot.plinian
//   key 240 -18
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/shared/glue.h"

namespace plinian::window {

using PlacesByName = std::map<std::string, vec2>;  // [points of the canvas]

class NodePlaces {
 public:
  /// file: made when it is needed; empty: nothing is kept.
  explicit NodePlaces(std::filesystem::path file);

  /// Those of a scene; none for one that is not known. A file that cannot be read holds nothing.
  PlacesByName of(const std::string& scene) const;
  /// The scene goes to the top; what is over forty scenes is forgotten. A file that cannot be written is no
  /// reason to stop.
  void keep(const std::string& scene, const PlacesByName& places);

 private:
  struct Entry {
    std::string scene;  // absolute path
    PlacesByName places;
  };
  std::vector<Entry> read() const;

  std::filesystem::path file_;
};

}  // namespace plinian::window
