// The flat scene in uniform blocks and on texture units, as viewport/passes/scene_access.glsl declares them.
#pragma once

#include <vector>

#include "core/integrate/flat_scene.h"
#include "viewport/gl/shader.h"
#include "viewport/passes/volume_textures.h"

namespace plinian::passes {

class SceneBlocks {
 public:
  SceneBlocks();
  /// Uploads the blocks of a scene; volumes: one per medium, null for analytic shapes.
  void update(const FlatScene& scene, const std::vector<const VolumeTextures*>& volumes);
  /// Binds blocks and textures; maps may be 0 where a pass reads none.
  void bind(gl::Name maps) const;
  /// What scene_access.glsl wants defined for this scene: a program is made for each distinct set.
  const gl::Defines& defines() const { return defines_; }

 private:
  gl::Buffer media_, lights_, maps_;
  gl::Texture blackbody_;
  gl::TexelBuffer no_entries_;  // these stand in where a medium has no volume
  gl::Texture no_values_;
  std::vector<const VolumeTextures*> volumes_;
  gl::Defines defines_;
};

}  // namespace plinian::passes
