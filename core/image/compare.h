// One picture judged against another: every figure at once, limits to pass or fail by, and the figures as
// JSON.
#pragma once

#include <string>
#include <vector>

#include "core/image/flip.h"
#include "core/image/image.h"
#include "core/image/metrics.h"

namespace plinian {

struct FlipAt {
  float exposure = 0.0f;  // [stops]
  FlipResult flip;
};

struct CompareResult {
  int width = 0, height = 0;  // [pixels]
  PixelMetrics pixels;        // in linear radiance
  double ssim = 1.0;          // [-]
  std::vector<FlipAt> flips;  // in the order of the exposures asked for
  std::vector<float> error;   // [radiance] largest absolute difference of a channel, per pixel, top
                              // row first; not-a-number where either picture is not finite
  std::size_t bad_a = 0, bad_reference = 0;  // pixels that are not finite; left out of every figure
  std::vector<std::string> notes;            // what a reader has to know to trust the figures
};

/// Throws ImageError where the sizes differ or a picture has no colour.
CompareResult compare_images(const Image& a, const Image& reference,
                             const std::vector<float>& flip_exposures = {0.0f, 3.0f});

/// A figure and the value that it must keep to.
struct Limit {
  std::string key;
  double value = 0.0;
};

/// "psnr=35,ssim=0.97,flip=0.1". Figures under the limit fail for psnr [dB], psnr_mask [dB] and ssim; figures
/// over it fail for flip and flip3 (mean FLIP at 0 and +3 stops), max_error, mse and mean (how far the ratio
/// of the means is from 1). Throws ImageError that names an unknown key or a value that is no number.
std::vector<Limit> parse_limits(const std::string& text);

/// One line per limit that the comparison does not keep to. A figure that does not exist (psnr_mask without
/// alpha) fails, and with any limit at all so do pixels that are not finite.
std::vector<std::string> failed_limits(const CompareResult& result, const std::vector<Limit>& limits);

/// The figures as one JSON object. A PSNR without bound is null; `identical` tells it from one that is
/// missing. `failures`: the lines of failed_limits.
std::string compare_json(const CompareResult& result, const std::vector<std::string>& failures = {});

}  // namespace plinian
