// Uploads.
#include "host/window/view/picture_texture.h"

#include <epoxy/gl.h>

namespace plinian::window {

PictureTexture::~PictureTexture() {
  forget();
}

void PictureTexture::forget() {
  if (name_ != 0) glDeleteTextures(1, &name_);
  name_ = 0;
  size_ = ivec2(0);
  shown_ = nullptr;
}

void PictureTexture::filter(vec2 place, bool squares) {
  if (name_ == 0) return;
  // Pixel for pixel where it is as large as its place.
  const int wanted = ivec2(glm::round(place)) == size_ ? GL_NEAREST : GL_LINEAR;
  glTextureParameteri(name_, GL_TEXTURE_MIN_FILTER, wanted);
  glTextureParameteri(name_, GL_TEXTURE_MAG_FILTER, squares ? GL_NEAREST : wanted);
}

void PictureTexture::show(const DevelopedPtr& developed) {
  if (!developed || developed == shown_) return;
  shown_ = developed;
  const ivec2 size(developed->width, developed->height);
  if (size != size_) {
    if (name_ != 0) glDeleteTextures(1, &name_);
    glCreateTextures(GL_TEXTURE_2D, 1, &name_);
    glTextureStorage2D(name_, 1, GL_RGB8, size.x, size.y);
    glTextureParameteri(name_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    size_ = size;
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(name_, 0, 0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, developed->bytes.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

}  // namespace plinian::window
