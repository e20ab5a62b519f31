// An OpenGL 4.5 core context without a window, on EGL: a graphics device (NVIDIA) or the surfaceless platform
// (llvmpipe).
#pragma once

#include <memory>
#include <string>

namespace plinian::gl {

/// Owns the context; current on the thread that made it until make_current() is called elsewhere. Move-only.
class EglContext {
 public:
  /// Throws std::runtime_error, in one line, where no OpenGL 4.5 is to be had.
  EglContext();
  ~EglContext();
  EglContext(EglContext&&) noexcept;
  EglContext& operator=(EglContext&&) noexcept;

  void make_current() const;
  /// False where the context has gone.
  bool try_make_current() const;
  void release_current() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// GL_RENDERER and GL_VERSION of the current context, for reports.
std::string describe_current_context();

}  // namespace plinian::gl
