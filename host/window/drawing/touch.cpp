// A few pixels, and where the picture lies around them.
#include "host/window/drawing/touch.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <vector>

namespace plinian::window {

namespace {

gl::Texture make_texture(GLenum format, int side) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  glTextureStorage2D(name, 1, format, side, side);
  return gl::Texture(name);
}

}  // namespace

Touch::~Touch() {
  if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
}

std::optional<float> Touch::depth_at(const draw::DrawView& view, vec2 pixel,
                                     const std::function<void(const draw::DrawView&)>& draw) {
  const int reach = int(std::ceil(4.0f * view.pixel_ratio)), side = 2 * reach + 1;
  if (framebuffer_ == 0) glCreateFramebuffers(1, &framebuffer_);
  if (side != side_) {
    colour_ = make_texture(GL_RGBA8, side);
    depth_ = make_texture(GL_DEPTH_COMPONENT32F, side);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, colour_.name(), 0);
    glNamedFramebufferTexture(framebuffer_, GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    side_ = side;
  }
  const std::array<float, 4> nothing{};
  const float far = 1.0f;
  glClearNamedFramebufferfv(framebuffer_, GL_COLOR, 0, nothing.data());
  glClearNamedFramebufferfv(framebuffer_, GL_DEPTH, 0, &far);
  draw::DrawView around = view;
  around.framebuffer = framebuffer_;
  around.viewport.x += reach - int(std::floor(pixel.x));
  around.viewport.y += reach - int(std::floor(pixel.y));
  around.gate.x += around.viewport.x - view.viewport.x;
  around.gate.y += around.viewport.y - view.viewport.y;
  draw(around);
  const std::size_t count = std::size_t(side) * std::size_t(side);
  std::vector<std::array<std::uint8_t, 4>> colours(count);
  std::vector<float> depths(count);
  glGetTextureImage(colour_.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(count * 4), colours.data());
  glGetTextureImage(depth_.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, GLsizei(count * sizeof(float)),
                    depths.data());
  std::optional<float> found;
  int nearest = reach * reach + 1;  // square of how far from the pixel
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::size_t i = std::size_t(y * side + x);
      const int away = (x - reach) * (x - reach) + (y - reach) * (y - reach);
      if (away >= nearest || (colours[i] == std::array<std::uint8_t, 4>{} && depths[i] == far)) continue;
      nearest = away;
      found = depths[i];
    }
  return found;
}

}  // namespace plinian::window
