#include "viewport/gl/objects.h"

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

namespace plinian::gl {

template <>
Object<Kind::buffer>::~Object() {
  if (name_) glDeleteBuffers(1, &name_);
}
template <>
Object<Kind::texture>::~Object() {
  if (name_) glDeleteTextures(1, &name_);
}
template <>
Object<Kind::program>::~Object() {
  if (name_) glDeleteProgram(name_);
}

Buffer make_buffer(std::size_t bytes, const void* data) {
  Name name = 0;
  glCreateBuffers(1, &name);
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_STORAGE_BIT);
  return Buffer(name);
}

void update_buffer(const Buffer& buffer, std::size_t bytes, const void* data) {
  glNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(bytes), data);
}

namespace {

Texture make_texture(unsigned target, unsigned format, ivec3 size, bool linear) {
  Name name = 0;
  glCreateTextures(target, 1, &name);
  glTextureStorage3D(name, 1, format, size.x, size.y, size.z);
  const GLint filter = linear ? GL_LINEAR : GL_NEAREST;
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(name, axis, GL_CLAMP_TO_EDGE);
  return Texture(name);
}

}  // namespace

Texture make_texture_3d(unsigned format, ivec3 size, bool linear) {
  return make_texture(GL_TEXTURE_3D, format, size, linear);
}

Texture make_texture_array(unsigned format, ivec3 size_and_layers) {
  return make_texture(GL_TEXTURE_2D_ARRAY, format, size_and_layers, false);
}

TexelBuffer make_texel_buffer(unsigned format, std::size_t texels, std::size_t bytes_per_texel,
                              const void* data) {
  GLint limit = 65536;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  if (texels > std::size_t(limit))
    throw std::runtime_error("a buffer of " + std::to_string(texels) + " texels is more than this GPU's " +
                             std::to_string(limit));
  TexelBuffer made;
  made.buffer = make_buffer(texels * bytes_per_texel, data);
  Name name = 0;
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &name);
  made.texture = Texture(name);
  glTextureBuffer(name, format, made.buffer.name());
  return made;
}

void check_errors(const char* where) {
  std::string errors;
  while (const GLenum error = glGetError()) {
    errors += error == GL_OUT_OF_MEMORY ? " out of memory" : " error " + std::to_string(error);
    if (error == GL_CONTEXT_LOST) break;
  }
  if (!errors.empty()) throw std::runtime_error(std::string("OpenGL:") + errors + " in " + where);
}

}  // namespace plinian::gl
