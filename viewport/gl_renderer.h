// The interactive renderer: OpenGL 4.5 compute shaders, on a context of its own (headless) or on one it is
// given.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/renderer.h"

namespace plinian {

/// Makes a renderer with a headless context of its own. Throws std::runtime_error, in one line, where there
/// is no OpenGL 4.5. Use it from one thread at a time.
std::unique_ptr<Renderer> make_gl_renderer();

/// How shaders of somebody else's look up how much of a light arrives at a place. They take `glsl` behind
/// their version line, which declares `vec3 plinian_light(int light, vec3 place)` [-, world], the uniform
/// sampler `plinian_map_texels` for the texture and the uniform block `PlinianLights` for the buffer.
struct GlLightMap {
  unsigned texels = 0;                      // GL name of a buffer texture
  unsigned block = 0;                       // GL name of a uniform buffer
  int light = 0;                            // its number for plinian_light()
  std::shared_ptr<const std::string> glsl;  // the same for maps of one layout
  std::uint64_t version = 0;                // of the texels: as long as it is the same, they are
};

/// The maps of the picture that a GL renderer made last, one for each light of its scene, in order; empty
/// where it had no maps. On the renderer's context or one that shares with it, and good until its next
/// picture.
std::vector<GlLightMap> light_maps(Renderer& renderer);

/// A renderer on the context that is current now and stays current in every call (a window's).
std::unique_ptr<Renderer> make_gl_renderer_on_current_context();

}  // namespace plinian
