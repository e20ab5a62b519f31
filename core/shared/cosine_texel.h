// One texel of a transmittance map: a cosine series on [kmin, kmax], as [TFM11] and [ATFM13] store it.
//
//   x = (k - kmin) / (kmax - kmin),   S(x) = c_0 + sum_{j>=1} c_j cos(j pi x),   T = max(S, 0)^weighting
//
// c_0 carries the half of [ATFM13 eq. 8] already. In front of kmin T is 1; behind kmax it is 0 in a dense
// texel and S(1)^weighting in a thin one. Coefficients are halves; the bounds are fractions of the map's
// depth in 16 bits, the last bit of kmax telling dense from thin: 6 + 2 numbers fit one RGBA32UI texel, 14 +
// 2 fit two.
#ifndef PLINIAN_SHARED_COSINE_TEXEL_H
#define PLINIAN_SHARED_COSINE_TEXEL_H
#include "core/shared/glue.h"
PLN_BEGIN

PLN_CONST float pi = 3.14159265358979f;

/// Bounds that a texel can hold exactly: k_min is rounded down, k_max up, to steps of the map's depth.
/// A texel that never meets density keeps k_min = k_max = 65535 steps: every k lies in front of it.
PLN_FN uint pack_bounds(float k_min, float k_max, bool dense, float depth) {
  uint low = uint(clamp(floor(k_min / depth * 65535.0f), 0.0f, 65532.0f));
  uint high = uint(clamp(ceil(k_max / depth * 65535.0f), 0.0f, 65534.0f));
  high = max(high, low + 1u);
  // The last bit of the upper bound is the flag: round up to the next value that has it right.
  uint flag = dense ? 1u : 0u;
  if ((high & 1u) != flag) high += 1u;
  return low | (high << 16);
}

PLN_FN uint missed_bounds() {
  return 0xffffffffu;
}

PLN_FN float bounds_k_min(uint bounds, float depth) {
  return float(bounds & 0xffffu) * (depth / 65535.0f);
}
PLN_FN float bounds_k_max(uint bounds, float depth) {
  return float(bounds >> 16) * (depth / 65535.0f);
}
PLN_FN bool bounds_dense(uint bounds) {
  return (bounds & 0x10000u) != 0u;
}

/// cos(pi x) for x in [0, 1] to 2e-7: an odd polynomial in x - 1/2.
PLN_FN float cos_pi(float x) {
  float y = 0.5f - x;
  float z = y * y;
  // sin(pi y) / y, minimax on |y| <= 1/2.
  return y * (3.14159265f +
              z * (-5.16771278f +
                   z * (2.55016404f + z * (-0.59926453f + z * (0.0821458866f - z * 0.00737043094f)))));
}

PLN_END
#endif
