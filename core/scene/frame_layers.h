// From sums over passes to a Frame: what the two map-based renderers share.
#pragma once

#include <vector>

#include "core/scene/frame.h"
#include "core/scene/pixel_box.h"
#include "core/scene/snapshot.h"

namespace plinian {

/// What passes add up, per pixel.
struct FrameSums {
  FrameSums(const SceneSnapshot& scene, std::size_t light_count);
  std::vector<vec3> transmittance;        // [-]
  std::vector<vec3> ambient;              // [-] in-scattered share of L_a
  std::vector<vec3> emission;             // [radiance]
  std::vector<float> depth;               // [world] of the first pass in the sums, 1e30 where there is none
  std::vector<std::vector<vec3>> lights;  // [radiance]
};

/// Sets transmittance and depth (w) of `box` to a plane of it, row after row; outside, `passes` passes met
/// nothing. `width` [pixels] is that of the picture.
void set_media_plane(FrameSums& sums, int width, PixelBox box, const std::vector<vec4>& plane, int passes);

/// Adds a plane of `box` alone, row after row, to a layer of pictures of `width` pixels; w is left out.
void add_plane(std::vector<vec3>& layer, int width, PixelBox box, const std::vector<vec4>& plane);

/// The first pass gives a picture at once: it is coarse, and its error is the same each time. As soon as a
/// finer one follows, the sums start again without it.
inline bool starts_sums(int pass) {
  return pass <= 1;
}
/// How many of the passes done are in the sums.
inline int passes_that_count(int done) {
  return done > 1 ? done - 1 : done;
}

/// Means over so many passes, the ambient light's colour, the background behind, and their sum.
Frame resolve(FrameSums sums, const SceneSnapshot& scene, int passes);

/// A picture without any medium: the background.
Frame empty_frame(const SceneSnapshot& scene);

/// Processor time of this process over all threads [ms]: what a busy machine does not stretch.
double processor_milliseconds();

}  // namespace plinian
