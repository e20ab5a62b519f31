// The shapes of the procedural media, and the numbers that steer them.
#pragma once

#include <memory>

#include "core/media/procedural/field.h"

namespace plinian::procedural {

/// What every kind is made from. The meaning, range and default of each shape parameter stand in
/// procedural.cpp, where a kind also says which of them it has.
struct ShapeSettings {
  int resolution = 256;       // [voxels]
  std::uint32_t seed = 1;     // [-]
  float billow_size = 1.0f;   // [-] lobes over their usual size
  float displacement = 1.0f;  // [-] how far lobes stand out, over the usual
  float sharpness = 1.0f;     // [-] steepness of the edge, over the usual
  float spread = 1.0f;        // [-] sideways extent over the usual
  float lean = 1.0f;          // [-] lean over the usual
  float veils = 1.0f;         // [-] density of the thin veils over the usual
  float heat = 1.0f;          // [-] temperatures over the usual
};

/// What the kinds share: lobes that fill the unit cube, and a body of nearly constant density with a steep
/// edge.
class BillowShape : public Shape {
 protected:
  explicit BillowShape(const ShapeSettings& settings) : settings_(settings) {}

  /// The least lobe that the resolution can show [object]. Smaller ones would only alias.
  float least_radius() const { return 1.3f / static_cast<float>(settings_.resolution); }
  /// Half the width of the body's edge [object]: two voxels on either side, of which 2.4 make up the steep
  /// part from 10 to 90%. Less, and trilinear lookups in a very dense medium show stairs where light grazes
  /// it.
  float edge(float voxel) const { return 1.7f * voxel / settings_.sharpness; }
  /// `usual`, as the settings would have it.
  Growth styled(Growth usual) const;
  /// Grows the generations on the founders, and scales the first two to fit the unit cube on the way.
  void raise_family(const std::vector<Growth>& usual, const LobeScale& scale);
  /// Density of the body, its thickness drifting by `variation` [-] over wavelengths down to about 0.04.
  void fill_body(const BlockField& field, float variation, float* density) const;
  /// Fades from 1 to 0 within `width` [object] of the faces of the unit cube, the ground aside: a warp or a
  /// veil that is multiplied by it leaves nothing cut off there.
  static float room(vec3 position, float width);

  ShapeSettings settings_;
  Fit fit_;
};

std::unique_ptr<Shape> make_ash(const ShapeSettings& settings);
std::unique_ptr<Shape> make_cloud(const ShapeSettings& settings);
std::unique_ptr<Shape> make_sandstorm(const ShapeSettings& settings);
std::unique_ptr<Shape> make_explosion(const ShapeSettings& settings);

}  // namespace plinian::procedural
