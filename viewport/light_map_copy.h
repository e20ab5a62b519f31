// The light maps of a picture in memory: what takes them from the renderer's context to one that shares
// nothing with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/renderer.h"

namespace plinian {

/// Immutable, and good for any thread.
struct LightMapCopy {
  /// Lights whose maps lie in one buffer.
  struct Batch {
    std::shared_ptr<const std::vector<uvec4>> texels;  // of a buffer texture, GL_RGBA32UI
    std::uint64_t version = 0;                         // of the texels, see GlLightMap
    std::vector<std::byte> block;                      // of a uniform buffer
    std::shared_ptr<const std::string> glsl;           // see GlLightMap
    int lights = 0;                                    // how many, in the order of the scene
  };
  std::vector<Batch> batches;
};
using LightMapCopyPtr = std::shared_ptr<const LightMapCopy>;

/// What light_maps(renderer) has, read back with the renderer's context current, as it is after a picture;
/// null where there is none. before: an earlier copy of the same renderer's or null; what has not been built
/// anew is taken from it, and where nothing has changed it is the answer itself.
LightMapCopyPtr copy_light_maps(Renderer& renderer, const LightMapCopyPtr& before);

}  // namespace plinian
