#include "core/image/flip.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace plinian {
namespace {

// Linear Rec.709 to CIE XYZ, D65 [IEC 61966-2-1]; columns are the primaries. White is the sum of the columns.
const mat3 xyz_from_rgb(0.4124564f, 0.2126729f, 0.0193339f, 0.3575761f, 0.7151522f, 0.1191920f, 0.1804375f,
                        0.0721750f, 0.9503041f);
const mat3 rgb_from_xyz = glm::inverse(xyz_from_rgb);
const vec3 white = xyz_from_rgb * vec3(1.0f);

// The linear opponent space YCxCz, in which the eye's contrast sensitivity is known per axis.
vec3 opponent_from_rgb(vec3 rgb) {
  const vec3 v = (xyz_from_rgb * rgb) / white;
  return {116.0f * v.y - 16.0f, 500.0f * (v.x - v.y), 200.0f * (v.y - v.z)};
}

vec3 rgb_from_opponent(vec3 opponent) {
  const float y = (opponent.x + 16.0f) / 116.0f;
  return rgb_from_xyz * (vec3(y + opponent.y / 500.0f, y, y - opponent.z / 200.0f) * white);
}

// CIE L*a*b* with the chroma scaled by lightness (Hunt: colours look less colourful when they are dark).
vec3 hunt_lab_from_rgb(vec3 rgb) {
  constexpr float delta = 6.0f / 29.0f;
  const vec3 v = (xyz_from_rgb * rgb) / white;
  const auto f = [](float t) {
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
  };
  const float x = f(v.x), y = f(v.y), z = f(v.z), lightness = 116.0f * y - 16.0f;
  return {lightness, 0.01f * lightness * 500.0f * (x - y), 0.01f * lightness * 200.0f * (y - z)};
}

// HyAB: city-block in lightness, Euclidean in chroma; raised to qc.
float colour_distance(vec3 a, vec3 b) {
  return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), 0.7f);
}

// Maps [0, pc * largest] onto [0, pt] and the rest onto [pt, 1]: large differences are all simply large.
float redistribute(float distance, float largest) {
  constexpr float pc = 0.4f, pt = 0.95f;
  const float knee = pc * largest;
  return distance < knee ? pt / knee * distance : pt + (distance - knee) / (largest - knee) * (1.0f - pt);
}

// 2 * radius + 1 weights. Double: the square root over feature differences turns the rounding of floats,
// 1e-7, into 3e-4 where there are no features at all.
using Kernel = std::vector<double>;

Kernel gaussian(int radius, double falloff) {  // exp(-falloff i^2)
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(std::exp(-falloff * i * i));
  return kernel;
}

double sum_of(const Kernel& kernel) {
  double sum = 0.0;
  for (const double weight : kernel) sum += weight;
  return sum;
}

// Scaled so that the positive weights sum to 1 and the negative ones to -1.
void balance(Kernel& kernel) {
  double positive = 0.0, negative = 0.0;
  for (const double weight : kernel) (weight > 0.0 ? positive : negative) += weight;
  for (double& weight : kernel) weight = weight > 0.0 ? weight / positive : weight / -negative;
}

// Every two-dimensional filter of the paper is a product of one-dimensional ones, or a sum of two such
// products.
struct Filters {
  int csf_radius, feature_radius;
  Kernel y, cx, cz_1, cz_2;         // contrast sensitivity per opponent axis
  double cz_weight_1, cz_weight_2;  // of the two products in Cz
  Kernel smooth, slope, curvature;  // Gaussian, its first and its second derivative

  explicit Filters(double pixels_per_degree) {
    constexpr double pi = std::numbers::pi;
    // Sums of a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees: the paper's Table 1.
    constexpr double b_y = 0.0047, b_cx = 0.0053, a_cz_1 = 34.1, b_cz_1 = 0.04, a_cz_2 = 13.5, b_cz_2 = 0.025;
    csf_radius = int(std::ceil(3.0 * std::sqrt(b_cz_1 / (2.0 * pi * pi)) * pixels_per_degree));
    const auto sensitivity = [&](double b) {
      return gaussian(csf_radius, pi * pi / (b * pixels_per_degree * pixels_per_degree));
    };
    y = sensitivity(b_y), cx = sensitivity(b_cx), cz_1 = sensitivity(b_cz_1), cz_2 = sensitivity(b_cz_2);
    const double volume_1 = a_cz_1 * std::sqrt(pi / b_cz_1) * sum_of(cz_1) * sum_of(cz_1);
    const double volume_2 = a_cz_2 * std::sqrt(pi / b_cz_2) * sum_of(cz_2) * sum_of(cz_2);
    cz_weight_1 = volume_1 / (volume_1 + volume_2);
    cz_weight_2 = volume_2 / (volume_1 + volume_2);
    for (Kernel* kernel : {&y, &cx, &cz_1, &cz_2}) normalise(*kernel);

    const double deviation = 0.5 * 0.082 * pixels_per_degree;  // [pixels] features are 0.082 degrees wide
    feature_radius = int(std::ceil(3.0 * deviation));
    smooth = slope = curvature = gaussian(feature_radius, 1.0 / (2.0 * deviation * deviation));
    normalise(smooth);
    for (int i = -feature_radius; i <= feature_radius; ++i) {
      slope[std::size_t(i + feature_radius)] *= -i;
      curvature[std::size_t(i + feature_radius)] *= i * i / (deviation * deviation) - 1.0;
    }
    balance(slope);
    balance(curvature);
  }

 private:
  static void normalise(Kernel& kernel) {
    const double sum = sum_of(kernel);
    for (double& weight : kernel) weight /= sum;
  }
};

// One row of a picture filtered vertically, with its ends repeated so that the horizontal pass needs no
// bounds.
class FilteredRow {
 public:
  FilteredRow(int width, int radius)
      : width_(width), radius_(radius), values_(std::size_t(width + 2 * radius)) {}
  // `channel` of the opponent picture, rows beyond the picture repeat its edge.
  void filter_vertically(const std::vector<vec3>& picture, int height, int y, int channel,
                         const Kernel& kernel) {
    std::fill(values_.begin(), values_.end(), 0.0);
    for (int i = -radius_; i <= radius_; ++i) {
      const vec3* row = picture.data() + std::size_t(std::clamp(y + i, 0, height - 1)) * std::size_t(width_);
      const double weight = kernel[std::size_t(i + radius_)];
      for (int x = 0; x < width_; ++x) values_[std::size_t(x + radius_)] += weight * row[x][channel];
    }
    for (int i = 0; i < radius_; ++i) {
      values_[std::size_t(i)] = values_[std::size_t(radius_)];
      values_[std::size_t(width_ + radius_ + i)] = values_[std::size_t(width_ + radius_ - 1)];
    }
  }
  double filter_horizontally(int x, const Kernel& kernel) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < kernel.size(); ++i) sum += kernel[i] * values_[std::size_t(x) + i];
    return sum;
  }

 private:
  int width_, radius_;
  std::vector<double> values_;
};

// What the eye makes of one row of a picture: colours as filtered by it, and strengths of edges and points.
class SeenRow {
 public:
  SeenRow(int width, const Filters& filters)
      : filters_(filters),
        y_(width, filters.csf_radius),
        cx_(y_),
        cz_1_(y_),
        cz_2_(y_),
        smooth_(width, filters.feature_radius),
        slope_(smooth_),
        curvature_(smooth_) {}
  void look(const std::vector<vec3>& picture, int height, int row) {
    y_.filter_vertically(picture, height, row, 0, filters_.y);
    cx_.filter_vertically(picture, height, row, 1, filters_.cx);
    cz_1_.filter_vertically(picture, height, row, 2, filters_.cz_1);
    cz_2_.filter_vertically(picture, height, row, 2, filters_.cz_2);
    smooth_.filter_vertically(picture, height, row, 0, filters_.smooth);
    slope_.filter_vertically(picture, height, row, 0, filters_.slope);
    curvature_.filter_vertically(picture, height, row, 0, filters_.curvature);
  }
  vec3 hunt_lab(int x) const {
    const vec3 opponent(y_.filter_horizontally(x, filters_.y), cx_.filter_horizontally(x, filters_.cx),
                        filters_.cz_weight_1 * cz_1_.filter_horizontally(x, filters_.cz_1) +
                            filters_.cz_weight_2 * cz_2_.filter_horizontally(x, filters_.cz_2));
    return hunt_lab_from_rgb(glm::clamp(rgb_from_opponent(opponent), 0.0f, 1.0f));
  }
  // The paper's features live on Y scaled to [0, 1]; the kernels' weights sum to 0, so the offset falls out.
  double edge(int x) const {
    return std::hypot(smooth_.filter_horizontally(x, filters_.slope),
                      slope_.filter_horizontally(x, filters_.smooth)) /
           116.0;
  }
  double point(int x) const {
    return std::hypot(smooth_.filter_horizontally(x, filters_.curvature),
                      curvature_.filter_horizontally(x, filters_.smooth)) /
           116.0;
  }

 private:
  const Filters& filters_;
  FilteredRow y_, cx_, cz_1_, cz_2_, smooth_, slope_, curvature_;
};

std::vector<vec3> opponent_picture(std::span<const vec3> picture, float exposure) {
  const float gain = std::exp2(exposure);
  std::vector<vec3> opponent(picture.size());
  // The display's sRGB encoding and the metric's decoding cancel; its clipping stays.
  for (std::size_t i = 0; i < picture.size(); ++i)
    opponent[i] = opponent_from_rgb(glm::clamp(picture[i] * gain, 0.0f, 1.0f));
  return opponent;
}

}  // namespace

FlipResult flip(std::span<const vec3> a, std::span<const vec3> b, int width, int height,
                const FlipSettings& settings) {
  assert(width >= 1 && height >= 1 && a.size() == std::size_t(width) * std::size_t(height) &&
         b.size() == a.size());
  const std::vector<vec3> opponent_a = opponent_picture(a, settings.exposure);
  const std::vector<vec3> opponent_b = opponent_picture(b, settings.exposure);
  const Filters filters(settings.pixels_per_degree);
  const float largest = colour_distance(hunt_lab_from_rgb(vec3(0, 1, 0)), hunt_lab_from_rgb(vec3(0, 0, 1)));
  FlipResult result;
  result.map.resize(a.size());
  tbb::parallel_for(tbb::blocked_range<int>(0, height, 8), [&](const tbb::blocked_range<int>& rows) {
    SeenRow seen_a(width, filters), seen_b(width, filters);
    for (int y = rows.begin(); y != rows.end(); ++y) {
      seen_a.look(opponent_a, height, y);
      seen_b.look(opponent_b, height, y);
      for (int x = 0; x < width; ++x) {
        const float colour = redistribute(colour_distance(seen_a.hunt_lab(x), seen_b.hunt_lab(x)), largest);
        const double feature = std::sqrt(
            std::max(std::abs(seen_a.edge(x) - seen_b.edge(x)), std::abs(seen_a.point(x) - seen_b.point(x))) /
            std::numbers::sqrt2);
        result.map[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
            float(std::clamp(std::pow(double(colour), 1.0 - feature), 0.0, 1.0));
      }
    }
  });
  double sum = 0.0;
  for (const float value : result.map) {
    sum += value;
    result.max = std::max(result.max, value);
  }
  result.mean = float(sum / double(result.map.size()));
  return result;
}

}  // namespace plinian
