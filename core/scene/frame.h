// What every renderer returns: the picture in layers, and what it cost.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/shared/glue.h"

namespace plinian {

struct LightLayer {
  std::string name;
  std::vector<vec3> radiance;
};

/// beauty = sum of lights + ambient + emission + background, to rounding. All planes have width * height
/// pixels, top row first, linear Rec.709 scene radiance.
struct Frame {
  int width = 0, height = 0;
  std::vector<vec3> beauty;
  std::vector<vec3> transmittance;  // [-] in [0, 1] per channel of the view ray
  std::vector<float>
      depth;  // [world] distance at which alpha (1 - mean transmittance) passes 0.5; inf if never
  std::vector<vec3> ambient, emission, background;
  std::vector<LightLayer> lights;  // in the order of the snapshot
};

/// Counters and times of the last render; a counter counts since the renderer was made.
struct RenderStats {
  std::int64_t map_builds = 0;  // transmittance maps built (one per light and colour group)
  std::int64_t volume_uploads = 0;
  std::size_t volume_bytes = 0;  // of the volumes where the renderer keeps them
  std::size_t map_bytes = 0;
  int passes = 0;                    // jittered passes in the picture
  std::optional<float> rest_change;  // [8-bit steps] estimated change still to come, where it was looked for
  double upload_ms = 0, map_ms = 0, view_ms = 0;  // wall clock of the last render's parts
  double map_cpu_ms = 0, view_cpu_ms = 0;         // processor time of the same, summed over threads
  std::vector<std::string> warnings;

  /// Forgets what was of the last picture; counters and what is kept for the next one stay.
  void begin_picture() {
    passes = 0;
    rest_change.reset();
    upload_ms = map_ms = view_ms = map_cpu_ms = view_cpu_ms = 0.0;
    warnings.clear();
  }
};

}  // namespace plinian
