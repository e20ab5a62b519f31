// From sums over passes to a Frame: what the two map-based renderers share.
#pragma once

#include <vector>

#include "core/scene/frame.h"
#include "core/scene/pixel_box.h"
#include "core/scene/snapshot.h"

namespace plinian {

/// What passes add up, per pixel, each times its weight (core/shared/pass_weight.h).
struct FrameSums {
  FrameSums(const SceneSnapshot& scene, std::size_t light_count);
  std::vector<vec3> transmittance;        // [-]
  std::vector<vec3> ambient;              // [-] in-scattered share of L_a
  std::vector<vec3> emission;             // [radiance]
  std::vector<float> depth;               // [world] of the first pass, 1e30 where there is none
  std::vector<std::vector<vec3>> lights;  // [radiance]
};

/// Sets transmittance and depth (w) of `box` to a plane of it, row after row; outside, passes of `weight`
/// met nothing. `width` [pixels] is that of the picture.
void set_media_plane(FrameSums& sums, int width, PixelBox box, const std::vector<vec4>& plane, float weight);

/// Adds a plane of `box` alone, row after row, to a layer of pictures of `width` pixels; w is left out.
void add_plane(std::vector<vec3>& layer, int width, PixelBox box, const std::vector<vec4>& plane);

/// Adds further passes to what the first ones gathered; the depth stays that of the first.
void add_passes(FrameSums& sums, const FrameSums& more);

/// Means over passes of so much weight together, the ambient light's colour, the background behind, and their
/// sum.
Frame resolve(FrameSums sums, const SceneSnapshot& scene, float weight);

/// A picture without any medium: the background.
Frame empty_frame(const SceneSnapshot& scene);

/// Processor time of this process over all threads [ms]: what a busy machine does not stretch.
double processor_milliseconds();

}  // namespace plinian
