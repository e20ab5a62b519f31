// The looks as small pictures along the picture's right edge.
#pragma once

#include <map>
#include <memory>

#include "host/window/drawing/pane_rect.h"
#include "host/window/studio.h"
#include "host/window/view/picture_texture.h"

namespace plinian::window {

/// How pictures that are to be seen at once stand in a room.
struct PictureGrid {
  int columns = 1;
  float height = 0.0f;  // [points] of a picture
};
/// The columns that leave the pictures largest. room: [points]. aspect: width over height. under: [points]
/// beneath each. gap: [points] between columns, and beside them. narrowest: [points] of a column. tallest:
/// [points] that a picture may have; it has 16 at least, whether that fits or not.
PictureGrid picture_grid(int count, vec2 room, float aspect, float under, float gap, float narrowest,
                         float tallest);

class LookGallery {
 public:
  /// pane: of the viewport. A click puts a look on the medium.
  void show(Studio& studio, const PaneRect& pane);

 private:
  std::map<std::string, std::unique_ptr<PictureTexture>> textures_;  // by name of the look
  std::string asked_;  // number of the picture and how it is seen, that looks were asked for last
};

/// Puts a look on the medium for looks, by a command.
void put_on(Studio& studio, const std::string& look);

}  // namespace plinian::window
