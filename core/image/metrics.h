// How far one picture is from another, in linear radiance: MSE, PSNR, SSIM, the largest error, the mean's
// ratio. FLIP, which asks what an eye sees, has a file of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/image/image.h"

namespace plinian {

/// Two pictures of one size made fit for measuring: a pixel that is not finite in either is zero in both and
/// marked, so that it is counted once and poisons nothing.
struct PicturePair {
  int width = 0, height = 0;                 // [pixels]
  std::vector<vec3> a, reference;            // linear Rec.709 radiance, top row first
  std::vector<std::uint8_t> valid;           // 1 where both are finite, else 0
  std::vector<std::uint8_t> mask;            // 1 where the reference's alpha > 0.01; empty if it has no alpha
  std::size_t bad_a = 0, bad_reference = 0;  // pixels of each with a colour that is not finite
};

/// Throws ImageError, naming both sizes, where they differ, and where a picture has no colour.
PicturePair pair_pictures(const Image& a, const Image& reference);

/// What a PSNR's peak is: the larger of 1 and the reference's 99.9th percentile. The percentile is that of
/// the values of R, G and B of all valid pixels pooled, by nearest rank: the smallest value that at
/// least 99.9% of them do not exceed. A handful of very bright pixels so neither flatters nor ruins the
/// figure.
double peak_of(const PicturePair& pictures);

/// 10 log10(peak^2 / mse) [dB]; +infinity where mse is 0.
double psnr_of(double mse, double peak);

struct PixelMetrics {
  double mse = 0.0;   // [radiance^2] mean over valid pixels and R, G, B
  double peak = 1.0;  // [radiance] peak_of
  double psnr = 0.0;  // [dB]
  std::optional<double>
      psnr_mask;                // [dB] over valid pixels under the mask, same peak; none without such pixels
  std::size_t mask_pixels = 0;  // valid pixels under the mask
  double max_error = 0.0;       // [radiance] largest absolute difference of a channel
  ivec2 max_error_at{0};        // [pixels] where; x right, y down
  std::optional<double>
      mean_ratio;  // [-] mean of a over mean of the reference, R, G, B; none where that is 0
};
PixelMetrics pixel_metrics(const PicturePair& pictures);

/// Mean structural similarity [Wang, Bovik, Sheikh, Simoncelli 2004] of linear luminance (0.2126, 0.7152,
/// 0.0722): 11 x 11 Gaussian window of sigma 1.5, K1 = 0.01, K2 = 0.03, L = peak, biased (weighted)
/// variances; over valid pixels whose window lies in the picture. A picture under 11 pixels wide or high is
/// measured at all its pixels with the window cut and renormalised. Returns [-] in [-1, 1], 1 for equal
/// pictures.
double ssim(const PicturePair& pictures, double peak);

}  // namespace plinian
