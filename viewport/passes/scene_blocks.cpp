#include "viewport/passes/scene_blocks.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <stdexcept>

#include "core/media/blackbody.h"

namespace plinian::passes {
namespace {

/// Chooses fetch(m) among fetch(0) to fetch(count - 1).
std::string choice_of_medium(std::size_t count) {
  std::string text;
  for (std::size_t m = 0; m + 1 < count; ++m)
    text += "m == " + std::to_string(m) + " ? fetch(" + std::to_string(m) + ") : ";
  return text + "fetch(" + std::to_string(count - 1) + ")";
}

}  // namespace

SceneBlocks::SceneBlocks()
    : media_(gl::make_buffer(sizeof(MediumData) * max_media, nullptr)),
      lights_(gl::make_buffer(sizeof(LightData) * max_lights, nullptr)),
      maps_(gl::make_buffer(sizeof(MapData) * max_maps, nullptr)),
      blackbody_(gl::make_texture_3d(GL_RGBA32F, {shared::blackbody_entries, 1, 1}, false)),
      no_entries_(gl::make_texel_buffer(GL_RG32UI, 1, 8, nullptr)),
      no_values_(gl::make_texture_3d(GL_R16, {1, 1, 1}, true)) {
  glTextureSubImage3D(blackbody_.name(), 0, 0, 0, 0, shared::blackbody_entries, 1, 1, GL_RGBA, GL_FLOAT,
                      blackbody_table().data());
}

void SceneBlocks::update(const FlatScene& scene, const std::vector<const VolumeTextures*>& volumes) {
  if (scene.lights.size() > max_lights || scene.maps.size() > max_maps)
    throw std::runtime_error("one march holds " + std::to_string(max_lights) + " lights");
  volumes_ = volumes;
  std::vector<MediumData> media = scene.media;
  for (std::size_t m = 0; m < media.size(); ++m)
    if (volumes[m]) {
      media[m].atlas_scale = 1.0f / vec3(volumes[m]->atlas_bricks * BrickVolume::brick_stride);
      media[m].hot_layers = volumes[m]->hot_layers;
    }
  const bool deep = std::any_of(media.begin(), media.end(), [](const MediumData& m) { return m.levels > 0; });
  gl::update_buffer(media_, media.size() * sizeof(MediumData), media.data());
  if (!scene.lights.empty())
    gl::update_buffer(lights_, scene.lights.size() * sizeof(LightData), scene.lights.data());
  if (!scene.maps.empty()) gl::update_buffer(maps_, scene.maps.size() * sizeof(MapData), scene.maps.data());
  defines_ = {{"MEDIA_COUNT", std::to_string(scene.media.size())},
              {"OF_MEDIUM(fetch)", choice_of_medium(scene.media.size())},
              {"LIGHT_COUNT", std::to_string(scene.lights.size())},
              {"MAP_COUNT", std::to_string(scene.maps.size())},
              {"GROUP_COUNT", std::to_string(scene.group_count)},
              {"MAP_COEFFICIENTS", std::to_string(scene.layout.coefficients)},
              {"MAP_WEIGHTING", std::to_string(scene.layout.weighting)},
              {"GREY_EXTINCTION", gl::flag(scene.grey)},
              {"ANALYTIC_MEDIA", gl::flag(scene.analytic)},
              {"SEVERAL_MEDIA", gl::flag(scene.media.size() > 1)},
              {"DEEP_TREES", gl::flag(deep)}};
}

void SceneBlocks::bind(gl::Name maps) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, media_.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, lights_.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 2, maps_.name());
  const unsigned count = unsigned(volumes_.size());
  glBindTextureUnit(0, maps);
  glBindTextureUnit(1, blackbody_.name());
  for (unsigned m = 0; m < count; ++m) {
    const VolumeTextures* v = volumes_[m];
    const auto name = [](const gl::Texture& texture, const gl::Texture& otherwise) {
      return texture ? texture.name() : otherwise.name();
    };
    glBindTextureUnit(2 + m, v ? v->root.texture.name() : no_entries_.texture.name());
    glBindTextureUnit(2 + count + m, v ? v->nodes.texture.name() : no_entries_.texture.name());
    glBindTextureUnit(2 + 2 * count + m, v ? v->density.name() : no_values_.name());
    glBindTextureUnit(2 + 3 * count + m, v ? name(v->temperature, no_values_) : no_values_.name());
  }
}

}  // namespace plinian::passes
