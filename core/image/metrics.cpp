#include "core/image/metrics.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plinian {
namespace {

bool finite(vec3 v) {
  return std::isfinite(v.r) && std::isfinite(v.g) && std::isfinite(v.b);
}

std::string size_of(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

double luminance(vec3 v) {
  return 0.2126 * v.r + 0.7152 * v.g + 0.0722 * v.b;
}

constexpr int ssim_radius = 5;

std::array<double, 2 * ssim_radius + 1> ssim_window() {
  std::array<double, 2 * ssim_radius + 1> window;
  double sum = 0.0;
  for (int i = -ssim_radius; i <= ssim_radius; ++i)
    sum += window[i + ssim_radius] = std::exp(-i * i / (2.0 * 1.5 * 1.5));
  for (double& weight : window) weight /= sum;
  return window;
}

// First and second moments of two luminances under a window.
struct Moments {
  double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  void add(const Moments& m, double weight) {
    a += weight * m.a, b += weight * m.b;
    aa += weight * m.aa, bb += weight * m.bb, ab += weight * m.ab;
  }
};

double similarity(const Moments& m, double c1, double c2) {
  const double variance_a = m.aa - m.a * m.a, variance_b = m.bb - m.b * m.b, covariance = m.ab - m.a * m.b;
  return (2.0 * m.a * m.b + c1) * (2.0 * covariance + c2) /
         ((m.a * m.a + m.b * m.b + c1) * (variance_a + variance_b + c2));
}

}  // namespace

PicturePair pair_pictures(const Image& a, const Image& reference) {
  if (a.width != reference.width || a.height != reference.height)
    throw ImageError("the pictures differ in size: " + size_of(a) + " and " + size_of(reference) +
                     "; render or crop them to one size");
  const Colour colour_a = colour_of(a), colour_reference = colour_of(reference);
  const Channel* alpha = reference.find("A");
  PicturePair pair;
  pair.width = a.width;
  pair.height = a.height;
  const std::size_t pixels = a.pixel_count();
  pair.a.assign(pixels, vec3(0.0f));
  pair.reference.assign(pixels, vec3(0.0f));
  pair.valid.assign(pixels, 0);
  if (alpha) pair.mask.assign(pixels, 0);
  for (std::size_t i = 0; i < pixels; ++i) {
    const vec3 va = colour_a[i], vr = colour_reference[i];
    const bool finite_a = finite(va), finite_reference = finite(vr);
    pair.bad_a += !finite_a;
    pair.bad_reference += !finite_reference;
    if (alpha) pair.mask[i] = alpha->values[i] > 0.01f;
    if (!finite_a || !finite_reference) continue;
    pair.a[i] = va;
    pair.reference[i] = vr;
    pair.valid[i] = 1;
  }
  return pair;
}

double peak_of(const PicturePair& pictures) {
  std::vector<float> values;
  values.reserve(3 * pictures.reference.size());
  for (std::size_t i = 0; i < pictures.reference.size(); ++i)
    if (pictures.valid[i])
      for (int c = 0; c < 3; ++c) values.push_back(pictures.reference[i][c]);
  if (values.empty()) return 1.0;
  // ceil(0.999 n) in whole numbers: 0.999 has no exact double.
  const std::size_t rank = (values.size() * 999 + 999) / 1000;
  const auto at = values.begin() + std::ptrdiff_t(rank - 1);
  std::nth_element(values.begin(), at, values.end());
  return std::max(1.0, double(*at));
}

double psnr_of(double mse, double peak) {
  return mse > 0.0 ? 10.0 * std::log10(peak * peak / mse) : std::numeric_limits<double>::infinity();
}

PixelMetrics pixel_metrics(const PicturePair& pictures) {
  PixelMetrics metrics;
  metrics.peak = peak_of(pictures);
  double squares = 0.0, mask_squares = 0.0, sum_a = 0.0, sum_reference = 0.0;
  std::size_t valid = 0;
  for (std::size_t i = 0; i < pictures.valid.size(); ++i) {
    if (!pictures.valid[i]) continue;
    ++valid;
    double pixel_squares = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double va = pictures.a[i][c], vr = pictures.reference[i][c], difference = std::abs(va - vr);
      pixel_squares += difference * difference;
      sum_a += va;
      sum_reference += vr;
      if (difference > metrics.max_error) {
        metrics.max_error = difference;
        metrics.max_error_at =
            ivec2(int(i % std::size_t(pictures.width)), int(i / std::size_t(pictures.width)));
      }
    }
    squares += pixel_squares;
    if (!pictures.mask.empty() && pictures.mask[i]) {
      ++metrics.mask_pixels;
      mask_squares += pixel_squares;
    }
  }
  if (valid) metrics.mse = squares / (3.0 * double(valid));
  metrics.psnr = psnr_of(metrics.mse, metrics.peak);
  if (metrics.mask_pixels)
    metrics.psnr_mask = psnr_of(mask_squares / (3.0 * double(metrics.mask_pixels)), metrics.peak);
  if (sum_reference != 0.0) metrics.mean_ratio = sum_a / sum_reference;
  return metrics;
}

double ssim(const PicturePair& pictures, double peak) {
  const int width = pictures.width, height = pictures.height;
  const auto window = ssim_window();
  const double c1 = 0.01 * peak * 0.01 * peak, c2 = 0.03 * peak * 0.03 * peak;
  const bool fits = width > 2 * ssim_radius && height > 2 * ssim_radius;
  const int border = fits ? ssim_radius : 0;
  std::vector<double> row_sum(std::size_t(height), 0.0);
  std::vector<std::size_t> row_count(std::size_t(height), 0);
  tbb::parallel_for(
      tbb::blocked_range<int>(border, height - border), [&](const tbb::blocked_range<int>& rows) {
        std::vector<Moments> columns(static_cast<std::size_t>(width));
        for (int y = rows.begin(); y != rows.end(); ++y) {
          std::fill(columns.begin(), columns.end(), Moments{});
          double vertical = 0.0;  // 1 inside; less where the window is cut
          for (int v = std::max(y - ssim_radius, 0); v <= std::min(y + ssim_radius, height - 1); ++v) {
            const double weight = window[std::size_t(v - y + ssim_radius)];
            vertical += weight;
            for (int x = 0; x < width; ++x) {
              const std::size_t i = std::size_t(v) * std::size_t(width) + std::size_t(x);
              const double la = luminance(pictures.a[i]), lr = luminance(pictures.reference[i]);
              columns[std::size_t(x)].add({la, lr, la * la, lr * lr, la * lr}, weight);
            }
          }
          for (int x = border; x < width - border; ++x) {
            if (!pictures.valid[std::size_t(y) * std::size_t(width) + std::size_t(x)]) continue;
            Moments moments;
            double horizontal = 0.0;
            for (int u = std::max(x - ssim_radius, 0); u <= std::min(x + ssim_radius, width - 1); ++u) {
              const double weight = window[std::size_t(u - x + ssim_radius)];
              horizontal += weight;
              moments.add(columns[std::size_t(u)], weight);
            }
            Moments mean;
            mean.add(moments, 1.0 / (vertical * horizontal));
            row_sum[std::size_t(y)] += similarity(mean, c1, c2);
            ++row_count[std::size_t(y)];
          }
        }
      });
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t y = 0; y < row_sum.size(); ++y) sum += row_sum[y], count += row_count[y];
  return count ? sum / double(count) : 1.0;
}

}  // namespace plinian
