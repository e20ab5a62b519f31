// Move-only GL objects, made by direct state access. They must be destroyed while their context is current.
#pragma once

#include <cstddef>
#include <utility>

#include "core/shared/glue.h"

namespace plinian::gl {

using Name = unsigned int;

enum class Kind { buffer, texture, program };

/// Owns a name of one kind; 0 is none.
template <Kind kind>
class Object {
 public:
  Object() = default;
  explicit Object(Name name) : name_(name) {}
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Object();
  Name name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  Name name_ = 0;
};

using Buffer = Object<Kind::buffer>;
using Texture = Object<Kind::texture>;
using Program = Object<Kind::program>;

/// A buffer of `bytes` that is rewritten now and then; data may be null.
Buffer make_buffer(std::size_t bytes, const void* data);
/// Replaces the first `bytes` of a buffer.
void update_buffer(const Buffer& buffer, std::size_t bytes, const void* data);

/// Textures without mip levels, clamped at the edge; `format` is a sized internal format, `linear` turns
/// filtering on.
Texture make_texture_3d(unsigned format, ivec3 size, bool linear);
Texture make_texture_array(unsigned format, ivec3 size_and_layers);

/// A buffer that shaders read as a texture or write as an image: a row of texels without filtering. What
/// llvmpipe fetches from it costs a third of a texture's texels, which it asks for their level one by one.
struct TexelBuffer {
  Buffer buffer;
  Texture texture;
};
/// `format` is a sized internal format; data may be null. Throws std::runtime_error where the GPU's limit is
/// lower.
TexelBuffer make_texel_buffer(unsigned format, std::size_t texels, std::size_t bytes_per_texel,
                              const void* data);

/// Throws std::runtime_error with what GL reports, if anything.
void check_errors(const char* where);

}  // namespace plinian::gl
