// A rectangle of a picture's pixels.
#pragma once

#include "core/shared/glue.h"

namespace plinian {

struct PixelBox {
  ivec2 first{0}, size{0};  // [pixels]
  bool empty() const { return size.x <= 0 || size.y <= 0; }
};

}  // namespace plinian
