// Independent truths about single scattering that the offline reference is measured against. Nothing here
// shares code with it: chords and integrals are worked out anew, from closed forms or by adaptive
// Gauss-Kronrod quadrature.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "core/shared/glue.h"

namespace plinian::truth {

constexpr double isotropic = 1.0 / (4.0 * std::numbers::pi);  // [1/sr]

/// Adaptive Gauss-Kronrod (7, 15) quadrature of f over [a, b]; nodes and weights from QUADPACK.
inline double integrate(const std::function<double(double)>& f, double a, double b, double tolerance = 1e-11,
                        int depth = 40) {
  static const double x[8] = {0.991455371120812639206854697526, 0.949107912342758524526189684048,
                              0.864864423359769072789712788641, 0.741531185599394439863864773281,
                              0.586087235467691130294144691694, 0.405845151377397166906606412077,
                              0.207784955007898467600689403773, 0.0};
  static const double kronrod[8] = {0.022935322010529224963732008059, 0.063092092629978553290700663189,
                                    0.104790010322250183839876322542, 0.140653259715525918745189590510,
                                    0.169004726639267902826583426599, 0.190350578064785409913256402421,
                                    0.204432940075298892414161999235, 0.209482141084727828012999174892};
  static const double gauss[4] = {0.129484966168869693270611432679, 0.279705391489276667901467771424,
                                  0.381830050505118944950369775489, 0.417959183673469387755102040816};
  const double centre = 0.5 * (a + b), half = 0.5 * (b - a);
  double k = kronrod[7] * f(centre), g = gauss[3] * f(centre);
  for (int i = 0; i < 7; ++i) {
    const double pair = f(centre - half * x[i]) + f(centre + half * x[i]);
    k += kronrod[i] * pair;
    if (i % 2 == 1) g += gauss[i / 2] * pair;
  }
  if (std::abs(k - g) * half <= tolerance * std::max(std::abs(k * half), 1e-300) || depth == 0)
    return k * half;
  return integrate(f, a, centre, tolerance, depth - 1) + integrate(f, centre, b, tolerance, depth - 1);
}

/// Distances at which a line enters and leaves the box |p| <= half; false where it misses.
inline bool box_chord(dvec3 o, dvec3 d, dvec3 half, double& in, double& out) {
  in = -std::numeric_limits<double>::infinity();
  out = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a) {
    if (d[a] == 0.0) {
      if (std::abs(o[a]) > half[a]) return false;
      continue;
    }
    const double near = (-std::copysign(half[a], d[a]) - o[a]) / d[a];
    const double far = (std::copysign(half[a], d[a]) - o[a]) / d[a];
    in = std::max(in, near);
    out = std::min(out, far);
  }
  return in < out;
}

/// Single scattering of a directional light in a homogeneous box |p| <= half, in closed form: the way out
/// towards the light is the least of three linear functions of t, so the integrand is an exponential between
/// their crossings. Everything per one channel; phase [1/sr] includes the cosine's choice. Starts at t =
/// near.
inline double box_directional(dvec3 o, dvec3 d, dvec3 half, dvec3 toward, double sigma_t, double sigma_s,
                              double irradiance, double phase, double near = 0.0) {
  double in, out;
  if (!box_chord(o, d, half, in, out)) return 0.0;
  in = std::max(in, near);
  if (!(in < out)) return 0.0;
  struct Line {
    double at_zero, slope;
  };
  std::vector<Line> ways;
  for (int a = 0; a < 3; ++a)
    if (toward[a] != 0.0)
      ways.push_back({(std::copysign(half[a], toward[a]) - o[a]) / toward[a], -d[a] / toward[a]});
  std::vector<double> cuts{in, out};
  for (std::size_t i = 0; i < ways.size(); ++i)
    for (std::size_t j = i + 1; j < ways.size(); ++j) {
      const double t = (ways[j].at_zero - ways[i].at_zero) / (ways[i].slope - ways[j].slope);
      if (t > in && t < out) cuts.push_back(t);
    }
  std::sort(cuts.begin(), cuts.end());
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double a = cuts[i], b = cuts[i + 1], middle = 0.5 * (a + b);
    Line least = ways[0];
    for (const Line& way : ways)
      if (way.at_zero + way.slope * middle < least.at_zero + least.slope * middle) least = way;
    // exp(-sigma_t (t - in + at_zero + slope t)) over [a, b].
    const double rate = sigma_t * (1.0 + least.slope), offset = sigma_t * (least.at_zero - in);
    sum += std::exp(-offset - rate * a) *
           (std::abs(rate) * (b - a) < 1e-12 ? b - a : -std::expm1(-rate * (b - a)) / rate);
  }
  return sigma_s * phase * irradiance * sum;
}

/// Distance from a point inside the box |p| <= half to its surface.
inline double box_way_out(dvec3 p, dvec3 d, dvec3 half) {
  double in, out;
  return box_chord(p, d, half, in, out) ? std::max(out, 0.0) : 0.0;
}

}  // namespace plinian::truth
