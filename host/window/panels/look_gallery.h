// The looks as a column of small pictures along the picture's right edge.
#pragma once

#include <map>
#include <memory>

#include "host/window/panels/layout.h"
#include "host/window/studio.h"
#include "host/window/view/picture_texture.h"

namespace plinian::window {

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
