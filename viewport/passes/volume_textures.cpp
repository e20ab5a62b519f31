#include "viewport/passes/volume_textures.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace plinian::passes {
namespace {

constexpr int stride = BrickVolume::brick_stride;

/// Bricks along each axis, near a cube, with as few empty places as such a box allows.
ivec3 choose_atlas(std::size_t bricks, int most) {
  ivec3 best(0);
  std::size_t best_places = SIZE_MAX;
  const int side = std::max(1, int(std::cbrt(double(bricks))));
  for (int x = std::max(1, side - side / 4); x <= std::min(side + side / 4 + 1, most); ++x)
    for (int y = x; y <= std::min(side + side / 4 + 1, most); ++y) {
      const std::size_t layers = (bricks + std::size_t(x) * y - 1) / (std::size_t(x) * y);
      const std::size_t places = layers * x * y;
      if (layers > std::size_t(most) || places >= best_places) continue;
      best = {x, y, int(layers)};
      best_places = places;
    }
  return best;
}

BrickEntry placed(BrickEntry entry, ivec3 atlas) {
  if (!(entry.x & BrickVolume::occupied_bit)) return entry;
  const std::uint32_t brick = entry.x & ~BrickVolume::occupied_bit;
  const std::uint32_t x = brick % atlas.x, y = brick / atlas.x % atlas.y, z = brick / (atlas.x * atlas.y);
  return {BrickVolume::occupied_bit | x | (y << 10) | (z << 20),
          glm::floatBitsToUint(glm::unpackHalf2x16(entry.y).y) | (entry.y & 0xFFu)};
}

gl::TexelBuffer upload_entries(const std::vector<BrickEntry>& entries) {
  const BrickEntry none(0u);
  return gl::make_texel_buffer(GL_RG32UI, std::max<std::size_t>(entries.size(), 1), sizeof(BrickEntry),
                               entries.empty() ? &none : entries.data());
}

/// Bricks into the atlas, one layer of them after the other through a small staging copy.
gl::Texture upload_bricks(const std::vector<std::uint16_t>& bricks, ivec3 atlas) {
  gl::Texture texture = gl::make_texture_3d(GL_R16, atlas * stride, true);
  const ivec3 texels = atlas * stride;
  std::vector<std::uint16_t> layer(std::size_t(texels.x) * texels.y * stride);
  const std::size_t count = bricks.size() / BrickVolume::brick_voxels;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  for (int z = 0; z < atlas.z; ++z) {
    std::fill(layer.begin(), layer.end(), std::uint16_t(0));
    for (int y = 0; y < atlas.y; ++y)
      for (int x = 0; x < atlas.x; ++x) {
        const std::size_t brick = (std::size_t(z) * atlas.y + y) * atlas.x + x;
        if (brick >= count) continue;
        const std::uint16_t* from = bricks.data() + brick * BrickVolume::brick_voxels;
        for (int k = 0; k < stride; ++k)
          for (int j = 0; j < stride; ++j, from += stride)
            std::memcpy(&layer[(std::size_t(k) * texels.y + y * stride + j) * texels.x + x * stride], from,
                        stride * sizeof(std::uint16_t));
      }
    glTextureSubImage3D(texture.name(), 0, 0, 0, z * stride, texels.x, texels.y, stride, GL_RED,
                        GL_UNSIGNED_SHORT, layer.data());
  }
  return texture;
}

}  // namespace

VolumeTextures upload_volume(const BrickVolume& volume) {
  GLint limit = 2048;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
  VolumeTextures textures;
  const ivec3 atlas = choose_atlas(volume.brick_count(), std::min(limit / stride, 1023));
  if (atlas.z == 0)
    throw std::runtime_error("the volume has " + std::to_string(volume.brick_count()) +
                             " bricks, more than this GPU's 3D textures hold; render it with --renderer cpu");
  textures.atlas_bricks = atlas;
  std::vector<BrickEntry> root = volume.root, nodes = volume.nodes;
  if (volume.levels == 0) {
    for (BrickEntry& entry : root) entry = placed(entry, atlas);
  } else {
    // Only the last level names bricks; the levels above name nodes. Nodes of the last level are those that
    // no chain of `levels` steps leaves, so walk down from the root.
    std::vector<std::uint32_t> level;
    for (const BrickEntry& entry : root)
      if (entry.x & BrickVolume::occupied_bit) level.push_back(entry.x & ~BrickVolume::occupied_bit);
    for (int depth = 1; depth < volume.levels; ++depth) {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t node : level)
        for (int i = 0; i < 512; ++i)
          if (nodes[node * std::size_t(512) + i].x & BrickVolume::occupied_bit)
            next.push_back(nodes[node * std::size_t(512) + i].x & ~BrickVolume::occupied_bit);
      level = std::move(next);
    }
    for (const std::uint32_t node : level)
      for (int i = 0; i < 512; ++i) {
        BrickEntry& entry = nodes[node * std::size_t(512) + i];
        entry = placed(entry, atlas);
      }
  }
  textures.root = upload_entries(root);
  textures.nodes = upload_entries(nodes);
  textures.density = upload_bricks(volume.density, atlas);
  const std::size_t layer = std::size_t(atlas.x) * atlas.y;
  textures.hot_layers = int((volume.hot_brick_count() + layer - 1) / layer);
  const ivec3 hot(atlas.x, atlas.y, textures.hot_layers);
  if (textures.hot_layers > 0) textures.temperature = upload_bricks(volume.temperature, hot);
  const auto texels = [](ivec3 bricks) {
    return std::size_t(bricks.x) * bricks.y * bricks.z * BrickVolume::brick_voxels;
  };
  textures.bytes = (volume.root.size() + volume.nodes.size()) * sizeof(BrickEntry) +
                   (texels(atlas) + texels(hot)) * sizeof(std::uint16_t);
  gl::check_errors("the upload of a volume");
  return textures;
}

}  // namespace plinian::passes
