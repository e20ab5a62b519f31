// Textures of a framebuffer. They are filled from memory: a blit that scales and turns would have llvmpipe
// compile for some 40 to 90 ms first.
#include "host/window/drawing/canvas.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

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
  if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
  framebuffer_ = 0;
  for (gl::Texture* texture : {&colour_, &depth_, &radiance_, &distances_}) *texture = gl::Texture();
  size_ = frame_size_ = ivec2(0);
  developed_ = nullptr;
  beneath_ = nullptr;
  colours_ = {};
  depths_ = {};
}

void Canvas::settle(ivec2 size, ivec2 frame_size) {
  if (framebuffer_ == 0) glCreateFramebuffers(1, &framebuffer_);
  if (size != size_) {
    colour_ = make_texture_2d(GL_RGBA8, size, GL_LINEAR);
    // However plug-ins blend, the window does not shine through.
    glTextureParameteri(colour_.name(), GL_TEXTURE_SWIZZLE_A, GL_ONE);
    depth_ = make_texture_2d(GL_DEPTH_COMPONENT32F, size, GL_NEAREST);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, colour_.name(), 0);
    glNamedFramebufferTexture(framebuffer_, GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    size_ = size;
    developed_ = nullptr;
    beneath_ = nullptr;
  }
  if (frame_size != frame_size_) {
    radiance_ = make_texture_2d(GL_RGB32F, frame_size, GL_LINEAR);
    distances_ = make_texture_2d(GL_R32F, frame_size, GL_NEAREST);
    frame_size_ = frame_size;
    beneath_ = nullptr;
  }
}

void Canvas::begin(const DevelopedPtr& developed, const ViewMatrices& matrices) {
  const ViewPicturePtr& shown = developed->picture;
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
  if (developed != developed_) colours_ = colour_buffer_of(*developed, size);
  developed_ = developed;
  glTextureSubImage2D(colour_.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, colours_.data());
}

void Canvas::filter(vec2 place, bool squares) {
  // Pixel for pixel where it is as large as its place.
  const GLint wanted = ivec2(glm::round(place)) == size_ ? GL_NEAREST : GL_LINEAR;
  glTextureParameteri(colour_.name(), GL_TEXTURE_MIN_FILTER, wanted);
  glTextureParameteri(colour_.name(), GL_TEXTURE_MAG_FILTER, squares ? GL_NEAREST : wanted);
}

std::vector<std::uint8_t> colour_buffer_of(const Developed& developed, ivec2 size) {
  const ivec2 from(developed.width, developed.height);
  std::vector<std::uint8_t> colours(4 * std::size_t(size.x) * std::size_t(size.y), 255);
  // The two pixels that one lies between along an axis, and 256 times the share of the second.
  struct Between {
    int first, second, share;
  };
  const auto between = [](int at, int count, int source) {
    const double place = std::clamp((at + 0.5) * source / count - 0.5, 0.0, double(source - 1));
    const int first = int(place);
    return Between{first, std::min(first + 1, source - 1), int(std::lround((place - first) * 256.0))};
  };
  std::vector<Between> columns;
  for (int x = 0; x < size.x; ++x) columns.push_back(between(x, size.x, from.x));
  for (int y = 0; y < size.y; ++y) {
    const Between rows = between(size.y - 1 - y, size.y, from.y);
    const std::uint8_t* upper = developed.bytes.data() + 3 * std::size_t(rows.first) * std::size_t(from.x);
    const std::uint8_t* lower = developed.bytes.data() + 3 * std::size_t(rows.second) * std::size_t(from.x);
    std::uint8_t* to = colours.data() + 4 * std::size_t(y) * std::size_t(size.x);
    for (const Between& column : columns) {
      const int a = 3 * column.first, b = 3 * column.second;
      for (int c = 0; c < 3; ++c) {
        const int above = upper[a + c] * (256 - column.share) + upper[b + c] * column.share;
        const int below = lower[a + c] * (256 - column.share) + lower[b + c] * column.share;
        to[c] = std::uint8_t((above * (256 - rows.share) + below * rows.share + 32768) >> 16);
      }
      to += 4;
    }
  }
  return colours;
}

}  // namespace plinian::window
