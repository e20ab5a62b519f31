// Whether a pixel is on what an override draws that has no hit function: it is drawn around that pixel alone,
// and looked at.
#pragma once

#include <functional>
#include <optional>

#include "host/draw/draw_driver.h"
#include "viewport/gl/objects.h"

namespace plinian::window {

/// Everything with the window's context current, the destruction too.
class Touch {
 public:
  Touch() = default;
  ~Touch();
  Touch(const Touch&) = delete;
  Touch& operator=(const Touch&) = delete;

  /// The depth [0, 1] in the depth buffer of what `draw` draws within four points of a pixel (from the lower
  /// left), of what is nearest to it there; none where that is nothing. view: of the whole picture; draw is
  /// given the one to draw with. What writes no depth has 1.
  std::optional<float> depth_at(const draw::DrawView& view, vec2 pixel,
                                const std::function<void(const draw::DrawView&)>& draw);

 private:
  unsigned framebuffer_ = 0;  // GL
  gl::Texture colour_, depth_;
  int side_ = 0;  // [pixels]
};

}  // namespace plinian::window
