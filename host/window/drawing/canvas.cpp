// Textures of a framebuffer.
#include "host/window/drawing/canvas.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace plinian::window {

namespace {

gl::Texture make_texture_2d(GLenum format, ivec2 size, GLint filter) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  glTextureStorage2D(name, 1, format, size.x, size.y);
  for (const GLenum way : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTextureParameteri(name, way, filter);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTextureParameteri(name, axis, GL_CLAMP_TO_EDGE);
  return gl::Texture(name);
}

// Rows from the top become rows from the bottom.
template <class T>
void upload_turned(const gl::Texture& texture, ivec2 size, GLenum format, const std::vector<T>& rows) {
  std::vector<T> turned(rows.size());
  const auto width = std::ptrdiff_t(size.x);
  for (int y = 0; y < size.y; ++y)
    std::copy_n(rows.begin() + y * width, width, turned.begin() + (size.y - 1 - y) * width);
  glTextureSubImage2D(texture.name(), 0, 0, 0, size.x, size.y, format, GL_FLOAT, turned.data());
}

}  // namespace

Canvas::~Canvas() {
  clear();
}

void Canvas::clear() {
  for (unsigned* framebuffer : {&framebuffer_, &source_}) {
    if (*framebuffer != 0) glDeleteFramebuffers(1, framebuffer);
    *framebuffer = 0;
  }
  for (gl::Texture* texture : {&colour_, &depth_, &radiance_, &distances_}) *texture = gl::Texture();
  size_ = frame_size_ = ivec2(0);
  beneath_ = nullptr;
  depths_ = {};
}

void Canvas::settle(ivec2 size, ivec2 frame_size) {
  if (framebuffer_ == 0) {
    glCreateFramebuffers(1, &framebuffer_);
    glCreateFramebuffers(1, &source_);
  }
  if (size != size_) {
    colour_ = make_texture_2d(GL_RGBA8, size, GL_LINEAR);
    // However plug-ins blend, the window does not shine through.
    glTextureParameteri(colour_.name(), GL_TEXTURE_SWIZZLE_A, GL_ONE);
    depth_ = make_texture_2d(GL_DEPTH_COMPONENT32F, size, GL_NEAREST);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, colour_.name(), 0);
    glNamedFramebufferTexture(framebuffer_, GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    size_ = size;
    beneath_ = nullptr;
  }
  if (frame_size != frame_size_) {
    radiance_ = make_texture_2d(GL_RGB32F, frame_size, GL_LINEAR);
    distances_ = make_texture_2d(GL_R32F, frame_size, GL_NEAREST);
    frame_size_ = frame_size;
    beneath_ = nullptr;
  }
}

void Canvas::begin(const PictureTexture& picture, const ViewMatrices& matrices) {
  const ViewPicturePtr& shown = picture.shown()->picture;
  const Frame& frame = shown->frame;
  const ivec2 size(shown->scene.width, shown->scene.height), frame_size(frame.width, frame.height);
  settle(size, frame_size);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (shown != beneath_) {
    upload_turned(radiance_, frame_size, GL_RGB, frame.beauty);
    upload_turned(distances_, frame_size, GL_RED, frame.depth);
    depths_ = depth_buffer_of(frame, shown->scene, matrices, size);
    beneath_ = shown;
  }
  glTextureSubImage2D(depth_.name(), 0, 0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depths_.data());
  // The picture's texture begins with its top row.
  glNamedFramebufferTexture(source_, GL_COLOR_ATTACHMENT0, picture.name(), 0);
  glBlitNamedFramebuffer(source_, framebuffer_, 0, 0, frame_size.x, frame_size.y, 0, size.y, size.x, 0,
                         GL_COLOR_BUFFER_BIT, frame_size == size ? GL_NEAREST : GL_LINEAR);
  glNamedFramebufferTexture(source_, GL_COLOR_ATTACHMENT0, 0, 0);  // it may go
}

void Canvas::filter(vec2 place) {
  // Pixel for pixel where it is as large as its place.
  const GLint wanted = ivec2(glm::round(place)) == size_ ? GL_NEAREST : GL_LINEAR;
  for (const GLenum way : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTextureParameteri(colour_.name(), way, wanted);
}

}  // namespace plinian::window
