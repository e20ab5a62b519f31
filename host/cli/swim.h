// What swims: how the error of a picture against the reference changes from one frame to the next while the
// camera goes round or the key light turns. An error that stays where it is looks like a slightly different
// cloud; one that comes and goes is seen.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/scene/snapshot.h"

namespace plinian::cli {

/// The world turned about the vertical axis through `pivot`. degrees: to the right, seen from above.
dmat4 turn(double degrees, const dvec3& pivot);

/// Who takes part in a measurement.
struct BenchQuality {
  std::string renderer, name;  // as in bench's report
  Quality quality;
};

struct SwimOptions {
  int frames = 4;                    // of each movement, >= 2
  double degrees = 1.0;              // from one frame to the next
  int passes = 1;                    // of each frame
  double reference_tolerance = 0.0;  // 0: the reference's own
};

/// Renders both movements with every quality and with the reference. Returns, per renderer and quality, for
/// "orbit" and "key_turn": frames and steps, and the worst of each: psnr [dB] of a frame, psnr_step [dB] of
/// the change of the error from one frame to the next, largest_step [radiance] of any pixel's change, and
/// step_over_error [-], the ratio of the two root mean squares: 1.41 where errors of successive frames have
/// nothing to do with each other, near 0 where they stay. Pixels count where either reference's alpha is over
/// 0.01. Throws RenderCancelled where `progress` returns false.
nlohmann::ordered_json measure_swim(const SceneSnapshot& scene, const std::vector<BenchQuality>& qualities,
                                    const SwimOptions& options, const std::function<bool(double)>& progress);

}  // namespace plinian::cli
