// A scene, a context and a framebuffer to draw to.
#pragma once

#include <epoxy/egl.h>
// epoxy's EGL must come before its GL.
#include <epoxy/gl.h>

#include <array>
#include <vector>

#include "host/draw/draw_driver.h"
#include "tests/host/sdk/plugin_session.h"
#include "viewport/gl/egl_context.h"
#include "viewport/gl/objects.h"

namespace plinian::draw {

inline void* gl_function(const char* name) {
  return reinterpret_cast<void*>(eglGetProcAddress(name));
}

struct DrawScene : sdk::PluginSession {
  static constexpr int size = 64;  // [pixels] of the framebuffer

  gl::EglContext context;
  GLuint framebuffer = 0;
  std::array<GLuint, 2> targets{};
  DrawView view;
  std::unique_ptr<DrawDriver> driver;
  std::set<graph::NodeId> hidden;
  float depth_beneath = 1.0f;  // where the picture stands

  DrawScene() {
    glCreateRenderbuffers(2, targets.data());
    glNamedRenderbufferStorage(targets[0], GL_RGBA8, size, size);
    glNamedRenderbufferStorage(targets[1], GL_DEPTH_COMPONENT24, size, size);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferRenderbuffer(framebuffer, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, targets[0]);
    glNamedFramebufferRenderbuffer(framebuffer, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, targets[1]);
    view.viewport = view.gate = ivec4(0, 0, size, size);
    view.framebuffer = framebuffer;
    // The square [-2, 2]^2 of the plane z = 0 fills the picture.
    view.clip_from_view = glm::ortho(-2.0, 2.0, -2.0, 2.0, -10.0, 10.0);
    driver = std::make_unique<DrawDriver>(session, plugins, gl_function);
  }
  ~DrawScene() {
    driver.reset();
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, targets.data());
  }

  std::optional<dmat4> place(graph::NodeId node) const {
    return hidden.contains(node) ? std::nullopt : std::optional(dmat4(1.0));
  }
  /// Until workers have prepared everything.
  void prepare() {
    while (driver->prepare()) session.evaluator().finish();
  }
  /// As it would come on the screen once everything is there.
  std::vector<std::array<unsigned char, 4>> picture() {
    prepare();
    while (driver->upload(std::chrono::seconds(1))) {
    }
    return drawn();
  }
  /// As it comes on the screen now.
  std::vector<std::array<unsigned char, 4>> drawn() {
    const std::array<float, 4> black{};
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, black.data());
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &depth_beneath);
    driver->draw(view, [this](graph::NodeId node) { return place(node); });
    std::vector<std::array<unsigned char, 4>> pixels(size * size);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
};

}  // namespace plinian::draw
