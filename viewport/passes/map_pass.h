// Builds transmittance maps on the GPU.
#pragma once

#include <functional>
#include <map>

#include "core/integrate/flat_scene.h"
#include "viewport/gl/shader.h"
#include "viewport/passes/paced_tiles.h"
#include "viewport/passes/scene_blocks.h"

namespace plinian::passes {

class MapPass {
 public:
  /// Builds map number `map` of the scene that `blocks` holds into its layer of `texels`, in tiles short
  /// enough for a GPU's watchdog. `go_on` is asked between tiles; returns false where it said no.
  bool build(const SceneBlocks& blocks, const FlatScene& scene, int map, const gl::TexelBuffer& texels,
             const std::function<bool()>& go_on);

 private:
  std::map<gl::Defines, PacedProgram> programs_;
  gl::Buffer controls_;
};

}  // namespace plinian::passes
