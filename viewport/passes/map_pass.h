// Builds transmittance maps on the GPU.
#pragma once

#include <functional>

#include "core/integrate/flat_scene.h"
#include "viewport/passes/program_cache.h"
#include "viewport/passes/scene_blocks.h"

namespace plinian::passes {

class MapPass {
 public:
  /// Builds map number `map` of the scene that `blocks` holds into its layer of `texels`, in tiles short
  /// enough for a GPU's watchdog. `go_on` is asked between tiles; returns false where it said no.
  bool build(const SceneBlocks& blocks, const FlatScene& scene, int map, const gl::TexelBuffer& texels,
             const std::function<bool()>& go_on);
  /// To be called behind the last pass of a picture: see ProgramCache.
  void end_picture() { programs_.end_picture(); }

 private:
  ProgramCache programs_{"viewport/passes/map_pass.comp"};
  gl::Buffer controls_;
};

}  // namespace plinian::passes
