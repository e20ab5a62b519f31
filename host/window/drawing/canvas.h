// A framebuffer that begins as the picture that is shown, with its depth, for plug-ins to draw on.
#pragma once

#include "host/window/drawing/view_matrices.h"
#include "host/window/view/developer.h"
#include "viewport/gl/objects.h"

namespace plinian::window {

/// Everything with the window's context current, the destruction too.
class Canvas {
 public:
  Canvas() = default;
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Takes the size at rest of a picture, however small it was rendered, its colours and depths.
  void begin(const DevelopedPtr& developed, const ViewMatrices& matrices);
  /// Lets go of everything.
  void clear();

  ivec2 size() const { return size_; }  // [pixels]; 0 before it begins
  unsigned framebuffer() const { return framebuffer_; }
  /// What is on it, the bottom row first.
  unsigned texture() const { return colour_.name(); }
  /// The picture beneath, the bottom row first and as large as it was rendered: linear radiance, and
  /// distances [world], infinite where there is nothing.
  unsigned radiance() const { return radiance_.name(); }
  unsigned distances() const { return distances_.name(); }
  /// As PictureTexture's.
  void filter(vec2 place, bool squares);

 private:
  void settle(ivec2 size, ivec2 frame_size);

  unsigned framebuffer_ = 0;  // GL
  gl::Texture colour_, depth_, radiance_, distances_;
  ivec2 size_{0}, frame_size_{0};      // [pixels]
  DevelopedPtr developed_;             // that the colours are of
  ViewPicturePtr beneath_;             // that radiance, distances and depths are of
  std::vector<std::uint8_t> colours_;  // see colour_buffer_of()
  std::vector<float> depths_;          // see depth_buffer_of()
};

/// A developed picture as r g b a of another size [pixels], 0 to 255, the bottom row first; between the
/// pixels where the sizes differ.
std::vector<std::uint8_t> colour_buffer_of(const Developed& developed, ivec2 size);

}  // namespace plinian::window
