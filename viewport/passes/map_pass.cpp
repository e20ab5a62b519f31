#include "viewport/passes/map_pass.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace plinian::passes {
namespace {

struct EncodeBlock {
  ivec4 ints;
  vec4 floats;
};
constexpr int group_size = 16, tile_size = 256;

}  // namespace

bool MapPass::build(const SceneBlocks& blocks, const FlatScene& scene, int map, const gl::TexelBuffer& texels,
                    const std::function<bool()>& go_on) {
  gl::Program& program = programs_[blocks.defines()];
  if (!program) program = gl::make_compute_program("viewport/passes/map_pass.comp", blocks.defines());
  const shared::EncodeControls& e = scene.encode;
  const EncodeBlock block{{e.adaptive, e.veil_proof, e.end_zero, e.refine_steps},
                          {e.kmin_transmittance, e.threshold, e.inverse_weighting, e.step}};
  if (!controls_) controls_ = gl::make_buffer(sizeof block, nullptr);
  gl::update_buffer(controls_, sizeof block, &block);
  blocks.bind(0);
  glBindBufferBase(GL_UNIFORM_BUFFER, 3, controls_.name());
  glBindImageTexture(0, texels.texture.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  glUseProgram(program.name());
  glProgramUniform1i(program.name(), 0, map);
  const int size = scene.layout.resolution;
  for (int y = 0; y < size; y += tile_size)
    for (int x = 0; x < size; x += tile_size) {
      if (go_on && !go_on()) return false;
      glProgramUniform2i(program.name(), 1, x, y);
      // All rows of groups, as spread_group() in scene_access.glsl asks; those outside the map end at once.
      const unsigned columns = unsigned(std::min(size - x, tile_size) + group_size - 1) / group_size;
      glDispatchCompute(columns, tile_size / group_size, 1);
      if (go_on) glFinish();
    }
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  return true;
}

}  // namespace plinian::passes
