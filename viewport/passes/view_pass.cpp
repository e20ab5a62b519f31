#include "viewport/passes/view_pass.h"

#include <epoxy/gl.h>

namespace plinian::passes {
namespace {

struct ViewBlock {
  vec4 origin, forward, right, up, controls;
  ivec4 frame;
  ivec2 end;
};

}  // namespace

PlaneLayout plane_layout(const FlatScene& flat, const SceneSnapshot& scene) {
  PlaneLayout layout;
  if (scene.ambient != vec3(0.0f)) layout.ambient = layout.count++;
  if (flat.emissive) layout.emission = layout.count++;
  layout.first_light = layout.count;
  layout.count += int(flat.lights.size());
  return layout;
}

bool ViewPass::render(const SceneBlocks& blocks, const FlatScene& flat, const SceneSnapshot& scene,
                      const gl::TexelBuffer& maps, int pass, bool first, PixelBox box,
                      const gl::Texture& sums, const std::function<bool()>& go_on) {
  gl::Defines defines = blocks.defines();
  const PlaneLayout layout = plane_layout(flat, scene);
  defines.insert(defines.end(), {{"PLANE_AMBIENT", std::to_string(layout.ambient)},
                                 {"PLANE_EMISSION", std::to_string(layout.emission)},
                                 {"PLANE_LIGHTS", std::to_string(layout.first_light)},
                                 {"EMISSIVE_MEDIA", gl::flag(flat.emissive)},
                                 {"VARIED_LIGHT", gl::flag(flat.varied_light)},
                                 {"LIGHT_MARCH", gl::flag(flat.view.light == LightLookup::march)},
                                 {"LIGHT_ERROR", gl::flag(flat.view.light == LightLookup::error)},
                                 {"LIGHT_MARCH_STEP", std::to_string(flat.view.march_step)},
                                 {"LIGHT_MARCH_DEPTH", std::to_string(flat.view.march_depth)}});
  PacedProgram& paced = programs_.get(defines);
  const gl::Program& program = paced.program;
  const CameraRays rays = camera_rays(scene.camera, scene.width, scene.height);
  const ivec2 end = box.first + box.size;
  const ViewBlock block{vec4(rays.origin, scene.camera.near_clip),
                        vec4(rays.forward, 0.0f),
                        vec4(rays.right, 0.0f),
                        vec4(rays.up, 0.0f),
                        vec4(flat.view.quantum, flat.view.step, flat.view.cutoff, 0.0f),
                        ivec4(scene.width, scene.height, pass, first),
                        end};
  if (!view_) view_ = gl::make_buffer(sizeof block, nullptr);
  gl::update_buffer(view_, sizeof block, &block);
  blocks.bind(maps.texture.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 3, view_.name());
  glBindImageTexture(0, sums.name(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_RGBA32F);
  glUseProgram(program.name());
  if (!run_tiles(paced, 0, box.first, end, go_on)) return false;
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  return true;
}

}  // namespace plinian::passes
