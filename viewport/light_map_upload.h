// Copied light maps on another context, brought there in slices.
#pragma once

#include <chrono>
#include <vector>

#include "viewport/gl/objects.h"
#include "viewport/gl_renderer.h"
#include "viewport/light_map_copy.h"

namespace plinian {

/// Everything with the same context current, the destruction too.
class LightMapUpload {
 public:
  /// Goes on uploading for about that long. Another copy than the last call's begins anew; null lets go of
  /// everything. Returns whether anything is left to be uploaded; until then the maps before are good.
  bool upload(const LightMapCopyPtr& copy, std::chrono::microseconds budget);
  /// As light_maps() tells them, for this context: one for each light of the scene that was copied. Empty
  /// where there are none, or more than this GPU takes.
  const std::vector<GlLightMap>& maps() const { return maps_; }
  /// That the maps are of.
  const LightMapCopyPtr& shown() const { return shown_; }

 private:
  struct Batch {
    std::shared_ptr<const std::vector<uvec4>> texels;  // that are there
    gl::TexelBuffer buffer;
    gl::Buffer block;
  };
  void begin(const LightMapCopyPtr& copy);
  void take_over();

  LightMapCopyPtr shown_, next_;
  std::vector<Batch> batches_, next_batches_;  // of those
  std::size_t batch_ = 0, done_ = 0;           // batch under way, and its texels that are there
  std::vector<GlLightMap> maps_;
};

}  // namespace plinian
