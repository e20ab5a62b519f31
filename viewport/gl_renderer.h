// The interactive renderer: OpenGL 4.5 compute shaders, on a context of its own (headless) or on one it is
// given.
#pragma once

#include <memory>

#include "core/scene/renderer.h"

namespace plinian {

/// Makes a renderer with a headless context of its own. Throws std::runtime_error, in one line, where there
/// is no OpenGL 4.5. Use it from one thread at a time.
std::unique_ptr<Renderer> make_gl_renderer();

/// A renderer on the context that is current now and stays current in every call (a window's).
std::unique_ptr<Renderer> make_gl_renderer_on_current_context();

}  // namespace plinian
