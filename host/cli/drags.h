// How a drag in the window feels, measured: the window's own renderer is driven as a hand drives it, and its
// quick pictures are held against the pictures at rest of the same scenes; then the hand lets go, and what
// comes is held against the reference. Left out is what follows a picture: developing it and drawing the
// interface.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scene/snapshot.h"

namespace plinian::cli {

struct DragOptions {
  std::string renderer = "gl";
  Quality rest;                // what the scene is let go in; its drags have the scene's own
  double seconds = 4.0;        // of each drag
  double rest_seconds = 10.0;  // that a picture may take to come to rest; 0: none is let go
  int samples = 20;            // quick pictures of each drag that are held against the picture at rest
  std::string folder;          // where those pictures go, as PNG; empty: nowhere
};

/// Drags the density of all media up to twice and back, the first light around the vertical and back, and the
/// camera likewise. Returns
///  - "drags", for "density", "key" and "camera": asked, dropped, pictures, per_second, latency_ms (median,
///    p95, worst) from the question for a scene to its picture, within_150_ms [-], ssim (median, p5, worst)
///    of linear luminance against the picture at rest, ssim_over_0.9 [-], size [pixels] of most pictures,
///    map_resolution [texels] likewise, changes: how often either changed, map_ms and view_ms (medians), and
///    map_builds;
///  - "rest": psnr_after_s [dB] against the reference after 1, 2, 5 and 10 seconds (null: nothing yet),
///    at_rest_s (null: not within rest_seconds), passes, the pictures that came, and pop: ssim and psnr of
///    the first of them against the last before letting go; null where no time is given to it;
///  - "take_hold_ms": median and worst time to the first picture of a drag that begins while a picture of the
///    quality `rest` is refined.
/// Throws RenderCancelled where `progress` returns false, and what rendering throws.
nlohmann::ordered_json measure_drags(const SceneSnapshot& scene, const DragOptions& options,
                                     const std::function<bool(double)>& progress);

/// That report as a table.
std::string drags_table(const nlohmann::ordered_json& report);

}  // namespace plinian::cli
