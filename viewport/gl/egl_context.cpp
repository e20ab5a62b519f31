#include "viewport/gl/egl_context.h"

#include <epoxy/egl.h>
// epoxy's EGL must come before its GL.
#include <epoxy/gl.h>

#include <array>
#include <stdexcept>
#include <vector>

namespace plinian::gl {
namespace {

/// Displays to try, best first: graphics devices, then the platform that needs none. A device that is only a
/// software rasteriser is left to the surfaceless platform.
std::vector<EGLDisplay> candidate_displays() {
  std::vector<EGLDisplay> displays;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, 16> found{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(found.size()), found.data(), &count))
      for (EGLint i = 0; i < count; ++i) {
        const char* extensions = eglQueryDeviceStringEXT(found[i], EGL_EXTENSIONS);
        if (extensions && std::string(extensions).find("software") != std::string::npos) continue;
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, found[i], nullptr));
      }
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return displays;
}

}  // namespace

struct EglContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

EglContext::EglContext() : state_(std::make_unique<State>()) {
  for (const EGLDisplay display : candidate_displays()) {
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) continue;
    if (!eglBindAPI(EGL_OPENGL_API)) continue;
    constexpr EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                            EGL_DONT_CARE, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (!eglChooseConfig(display, config_attributes, &config, 1, &configs) || configs == 0) continue;
    // Without the last pair a reset of the GPU is never told of; a driver that does not know it goes without.
    EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   4,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   5,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                   EGL_LOSE_CONTEXT_ON_RESET,
                                   EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
    if (context == EGL_NO_CONTEXT) {
      context_attributes[6] = EGL_NONE;
      context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
    }
    if (context == EGL_NO_CONTEXT) continue;
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
      eglDestroyContext(display, context);
      continue;
    }
    state_->display = display;
    state_->context = context;
    return;
  }
  throw std::runtime_error(
      "no OpenGL 4.5 through EGL here; install a driver (the package libgl1-mesa-dri has one for the CPU) or "
      "use "
      "--renderer cpu");
}

EglContext::~EglContext() {
  if (!state_ || state_->context == EGL_NO_CONTEXT) return;
  if (eglGetCurrentContext() == state_->context) release_current();
  eglDestroyContext(state_->display, state_->context);
}

EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;

bool EglContext::try_make_current() const {
  return eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context) == EGL_TRUE;
}

void EglContext::make_current() const {
  if (!try_make_current())
    throw std::runtime_error("the OpenGL context cannot be made current on this thread");
}

void EglContext::release_current() const {
  eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

std::string describe_current_context() {
  return std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) + ", OpenGL " +
         reinterpret_cast<const char*>(glGetString(GL_VERSION));
}

}  // namespace plinian::gl
