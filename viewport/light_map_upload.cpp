// Piece by piece; what has not changed stays where it is.
#include "viewport/light_map_upload.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <stdexcept>

namespace plinian {

namespace {

constexpr std::size_t piece = 65536;  // [texels] 1 MiB

}  // namespace

void LightMapUpload::begin(const LightMapCopyPtr& copy) {
  next_ = copy;
  next_batches_.clear();
  batch_ = done_ = 0;
}

void LightMapUpload::take_over() {
  // Buffers whose texels are the same came with the batches before.
  for (std::size_t i = 0; i < next_batches_.size(); ++i)
    if (!next_batches_[i].buffer.buffer) next_batches_[i].buffer = std::move(batches_[i].buffer);
  batches_ = std::move(next_batches_);
  next_batches_.clear();
  shown_ = std::move(next_);
  next_ = nullptr;
  maps_.clear();
  for (std::size_t i = 0; i < batches_.size(); ++i)
    for (int l = 0; l < shown_->batches[i].lights; ++l)
      maps_.push_back({batches_[i].buffer.texture.name(), batches_[i].block.name(), l,
                       shown_->batches[i].glsl, shown_->batches[i].version});
}

bool LightMapUpload::upload(const LightMapCopyPtr& copy, std::chrono::microseconds budget) {
  if (!copy) {
    *this = LightMapUpload();
    return false;
  }
  if (copy == shown_) {
    begin(nullptr);
    return false;
  }
  if (copy != next_) begin(copy);
  const auto end = std::chrono::steady_clock::now() + budget;
  for (; batch_ < next_->batches.size(); ++batch_, done_ = 0) {
    const LightMapCopy::Batch& from = next_->batches[batch_];
    if (next_batches_.size() == batch_) {
      Batch to;
      to.texels = from.texels;
      to.block = gl::make_buffer(from.block.size(), from.block.data());
      const bool is_there = batch_ < batches_.size() && batches_[batch_].texels == from.texels;
      try {
        if (!is_there)
          to.buffer = gl::make_texel_buffer(GL_RGBA32UI, from.texels->size(), sizeof(uvec4), nullptr);
      } catch (const std::runtime_error&) {
        // More than this GPU takes: lights go without maps.
        *this = LightMapUpload();
        shown_ = copy;
        return false;
      }
      if (is_there) done_ = from.texels->size();
      next_batches_.push_back(std::move(to));
    }
    for (; done_ < from.texels->size(); done_ = std::min(done_ + piece, from.texels->size())) {
      if (std::chrono::steady_clock::now() >= end) return true;
      const std::size_t count = std::min(piece, from.texels->size() - done_);
      glNamedBufferSubData(next_batches_[batch_].buffer.buffer.name(), GLintptr(done_ * sizeof(uvec4)),
                           GLsizeiptr(count * sizeof(uvec4)), from.texels->data() + done_);
    }
  }
  take_over();
  return false;
}

}  // namespace plinian
