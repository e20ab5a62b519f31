// Reads buffers back.
#include "viewport/light_map_copy.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "viewport/gl_renderer.h"

namespace plinian {

namespace {

std::vector<std::byte> bytes_of(GLuint buffer) {
  GLint64 size = 0;
  glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &size);
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  if (size > 0) glGetNamedBufferSubData(buffer, 0, GLsizeiptr(size), bytes.data());
  return bytes;
}

std::shared_ptr<const std::vector<uvec4>> texels_of(GLuint buffer_texture) {
  GLint buffer = 0;
  glGetTextureLevelParameteriv(buffer_texture, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
  GLint64 size = 0;
  glGetNamedBufferParameteri64v(GLuint(buffer), GL_BUFFER_SIZE, &size);
  auto texels = std::make_shared<std::vector<uvec4>>(std::size_t(size) / sizeof(uvec4));
  if (!texels->empty())
    glGetNamedBufferSubData(GLuint(buffer), 0, GLsizeiptr(texels->size() * sizeof(uvec4)), texels->data());
  return texels;
}

}  // namespace

LightMapCopyPtr copy_light_maps(Renderer& renderer, const LightMapCopyPtr& before) {
  const std::vector<GlLightMap> maps = light_maps(renderer);
  if (maps.empty()) return nullptr;
  auto copy = std::make_shared<LightMapCopy>();
  bool changed = !before;
  unsigned texels = 0;  // GL name of the batch under way
  for (const GlLightMap& map : maps) {
    if (map.texels == texels) {
      ++copy->batches.back().lights;
      continue;
    }
    texels = map.texels;
    const std::size_t i = copy->batches.size();
    const LightMapCopy::Batch* old = before && i < before->batches.size() ? &before->batches[i] : nullptr;
    LightMapCopy::Batch batch;
    batch.version = map.version;
    batch.glsl = map.glsl;
    batch.lights = 1;
    batch.block = bytes_of(map.block);
    batch.texels = old && old->version == map.version ? old->texels : texels_of(map.texels);
    changed = changed || !old || old->texels != batch.texels || old->glsl != batch.glsl ||
              old->block != batch.block;
    copy->batches.push_back(std::move(batch));
  }
  changed = changed || before->batches.size() != copy->batches.size();
  for (std::size_t i = 0; !changed && i < copy->batches.size(); ++i)
    changed = before->batches[i].lights != copy->batches[i].lights;
  if (!changed) return before;
  // What a lost context hands out is nothing.
  if (glGetError() != GL_NO_ERROR) return nullptr;
  return copy;
}

}  // namespace plinian
