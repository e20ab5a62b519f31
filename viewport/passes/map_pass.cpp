#include "viewport/passes/map_pass.h"

#include <epoxy/gl.h>

namespace plinian::passes {
namespace {

struct EncodeBlock {
  ivec4 ints;
  vec4 floats;
};

}  // namespace

bool MapPass::build(const SceneBlocks& blocks, const FlatScene& scene, int map, const gl::TexelBuffer& texels,
                    const std::function<bool()>& go_on) {
  PacedProgram& paced = programs_.get(blocks.defines());
  const gl::Program& program = paced.program;
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
  const ivec2 size(scene.layout.resolution);
  if (!run_tiles(paced, 1, ivec2(0), size, go_on)) return false;
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  return true;
}

}  // namespace plinian::passes
