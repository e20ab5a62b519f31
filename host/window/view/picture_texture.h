// A developed picture as a texture of the window's OpenGL context.
#pragma once

#include <cstdint>

#include "host/window/view/developer.h"

namespace plinian::window {

class PictureTexture {
 public:
  PictureTexture() = default;
  /// With the context current.
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  /// There is no picture any more. With the context current.
  void forget();
  /// Uploads the picture, unless it is the one that is there.
  void show(const DevelopedPtr& developed);
  /// To be drawn that large [pixels of the screen]. squares: pixels that come out larger are seen as such.
  void filter(vec2 place, bool squares = false);
  unsigned name() const { return name_; }
  const DevelopedPtr& shown() const { return shown_; }

 private:
  unsigned name_ = 0;  // GL
  ivec2 size_{0};
  DevelopedPtr shown_;
};

}  // namespace plinian::window
