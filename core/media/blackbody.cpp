#include "core/media/blackbody.h"

#include <algorithm>
#include <cmath>

namespace plinian {
namespace {

// One lobe of the fit: a Gaussian with a different width on each side. All in nanometres.
double lobe(double wavelength, double centre, double width_below, double width_above) {
  const double x = (wavelength - centre) / (wavelength < centre ? width_below : width_above);
  return std::exp(-0.5 * x * x);
}

// Colour matching functions at a wavelength [nm] [Wyman, Sloan, Shirley 2013, table 1].
dvec3 observer(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

// Planck's spectral radiance per wavelength relative to that at 780 nm, so that cold bodies do not underflow.
double planck_relative(double nm, double kelvin) {
  constexpr double second_radiation_constant = 1.438776877e7;  // [nm K] h c / k, CODATA 2018
  const double x = second_radiation_constant / kelvin;
  const double a = x / nm, b = x / 780.0;
  // exp(b - a) (1 - e^-b) / (1 - e^-a) = (e^b - 1) / (e^a - 1), without overflow.
  return std::pow(780.0 / nm, 5.0) * std::exp(b - a) * std::expm1(-b) / std::expm1(-a);
}

double luminance(dvec3 rgb) {
  return 0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z;
}

}  // namespace

vec3 planck_colour(double kelvin) {
  kelvin = std::max(kelvin, 100.0);
  // Smooth integrand, nanometre steps: the trapezoid's error is far below that of the observer's fit.
  dvec3 xyz{0.0};
  for (int nm = 360; nm <= 830; ++nm) xyz += planck_relative(nm, kelvin) * observer(nm);
  xyz /= xyz.y;

  // IEC 61966-2-1, D65 white.
  const dvec3 rgb{3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                  -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                  0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
  const dvec3 inside = glm::max(rgb, dvec3(0.0));
  return vec3(inside / luminance(inside));
}

const BlackbodyTable& blackbody_table() {
  static const BlackbodyTable table = [] {
    BlackbodyTable result{};
    for (int i = 0; i < shared::blackbody_entries; ++i) {
      const double share = i / (shared::blackbody_entries - 1.0);
      const double kelvin =
          shared::blackbody_first + share * (shared::blackbody_last - shared::blackbody_first);
      result[static_cast<std::size_t>(i)] = vec4(planck_colour(kelvin), 0.0f);
    }
    return result;
  }();
  return table;
}

vec3 blackbody_colour(float kelvin) {
  const BlackbodyTable& table = blackbody_table();
  const float position = shared::blackbody_position(kelvin);
  const int below = std::min(static_cast<int>(position), shared::blackbody_entries - 2);
  return vec3(glm::mix(table[static_cast<std::size_t>(below)], table[static_cast<std::size_t>(below) + 1],
                       position - static_cast<float>(below)));
}

}  // namespace plinian
