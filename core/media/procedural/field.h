// Turns a shape made of lobes into a sparse volume: an octree over the voxel blocks drops whole regions that
// are empty or solid and shortens the list of lobes on the way down, so no dense grid ever exists.
#pragma once

#include <functional>

#include "core/media/brick_volume.h"
#include "core/media/procedural/lobes.h"

namespace plinian::procedural {

/// What a shape is told about one block of 8^3 voxels, x fastest.
struct BlockField {
  static constexpr int count = 512;
  vec3 corner;     // [object] centre of the first voxel
  float voxel;     // [object] side of a voxel
  bool solid;      // the whole block lies deeper than the shape's solid_depth
  float x[count];  // [object] warped positions
  float y[count];
  float z[count];
  float hull[count];     // [object] distance to the union of the older generations, < 0 inside; exact between
                         // -solid_depth and hull_reach, a bound beyond
  float surface[count];  // [object] distance to the union of all lobes; exact between -solid_depth and
                         // surface_reach, a bound beyond

  vec3 position(int i) const { return corner + voxel * vec3(i & 7, (i >> 3) & 7, i >> 6); }
};

/// A medium's shape: where its lobes are and what the space around them holds.
class Shape {
 public:
  virtual ~Shape() = default;
  const LobeFamily& family() const { return family_; }

  /// Bends space before lobes are looked up, so that they are no perfect balls. Returns the offset [object],
  /// shorter than warp_reach.
  virtual vec3 warp(vec3 position) const = 0;
  /// Density [-] and temperature [K] of a block. `temperature` arrives zeroed; returns whether it was
  /// written.
  virtual bool shade(const BlockField& field, float* density, float* temperature) const = 0;

  float warp_reach = 0.0f;           // [object] longest warp offset
  float warp_wavelength = 0.02f;     // [object] shortest wavelength of the warp
  float hull_reach = 0.0f;           // [object] how far outside its hull the shape has anything
  float surface_reach = 0.01f;       // [object] how far outside its surface
  float solid_depth = 0.01f;         // [object] depth beyond which nothing depends on distance any more
  std::size_t hull_generations = 2;  // generations that make the hull

 protected:
  LobeFamily family_;
};

/// Called with a share of the work done in [0, 1]; returning false cancels.
using ShapeProgress = std::function<bool(double)>;

/// What a shape cost to make.
struct VoxeliseStats {
  bool cancelled = false;
  std::int64_t shaded_blocks = 0;  // blocks whose voxels were evaluated, solid ones included
  std::int64_t solid_blocks = 0;   // of them, those that needed no distances
  std::int64_t lobe_visits = 0;    // pairs of a block and a lobe whose distance to its voxels was taken
};

/// Evaluates a shape at the voxel centres of [0,1]^3.
VoxeliseStats voxelise(const Shape& shape, int resolution, BrickVolumeBuilder& builder,
                       const ShapeProgress& progress = {});

}  // namespace plinian::procedural
