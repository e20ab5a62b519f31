// A BrickVolume as the shaders see it: the index tree, and the bricks side by side in an atlas.
#pragma once

#include "core/media/brick_volume.h"
#include "viewport/gl/objects.h"

namespace plinian::passes {

struct VolumeTextures {
  gl::TexelBuffer root;     // RG32UI, x fastest; bricks are named by their place in the atlas
  gl::TexelBuffer nodes;    // RG32UI, 512 entries a node
  gl::Texture density;      // R16, filtered
  gl::Texture temperature;  // R16, filtered; only as many layers as hot bricks need
  ivec3 atlas_bricks{0};    // [bricks]
  int hot_layers = 0;       // [bricks]
  std::size_t bytes = 0;
};

/// Uploads a volume, a layer of bricks at a time. Throws std::runtime_error where it exceeds what the GPU's
/// textures hold.
VolumeTextures upload_volume(const BrickVolume& volume);

}  // namespace plinian::passes
