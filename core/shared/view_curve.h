// From scene radiance to the values that a display takes: the sRGB transfer function and a filmic curve.
//
// The filmic curve is a sigmoid over log2 of the radiance, applied per channel between a slight inset of the
// primaries and its inverse, the structure of AgX [Sobotka 2022, github.com/sobotka/AgX]; the sigmoid, the
// inset and the numbers are our own. With u the stops around middle grey, scaled to x in [0, 1]:
//   y = y0 + h(s (x - x0); scale, p),   h(t; scale, p) = t / (1 + |t / scale|^p)^(1/p),
// slope s at middle grey, which keeps the display value y0 that plain sRGB gives it; the toe's and the
// shoulder's scale make the curve end exactly in 0 and 1. The inset lets a saturated colour reach the other
// channels, so that fire brightens from orange over amber to pale yellow and white instead of clipping to a
// flat yellow.
#ifndef PLINIAN_SHARED_VIEW_CURVE_H
#define PLINIAN_SHARED_VIEW_CURVE_H

#include "core/shared/glue.h"

PLN_BEGIN

/// sRGB encoding of one linear value [IEC 61966-2-1]. linear: [0, 1]. Returns [0, 1].
PLN_FN float srgb_from_linear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// The inverse of srgb_from_linear. encoded: [0, 1]. Returns [0, 1].
PLN_FN float linear_from_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : pow((encoded + 0.055f) / 1.055f, 2.4f);
}

PLN_CONST float filmic_grey = 0.18f;             // [radiance] middle grey
PLN_CONST float filmic_grey_display = 0.46136f;  // [display] srgb_from_linear(0.18)
PLN_CONST float filmic_darkest = -10.0f;         // [stops] from middle grey: black
PLN_CONST float filmic_brightest = 6.5f;         // [stops] from middle grey: white
PLN_CONST float filmic_slope = 3.0f;     // [display per range of stops] 2.4 is plain sRGB's at middle grey
PLN_CONST float filmic_toe = 1.8f;       // [-] power: larger bends later and harder
PLN_CONST float filmic_shoulder = 2.2f;  // [-]
PLN_CONST float filmic_inset = 0.1f;     // [-] share of the mean that is mixed into each channel

/// The sigmoid of the header. radiance: any; values that are not positive give 0. Returns [display] in [0,
/// 1].
PLN_FN float filmic_curve(float radiance) {
  if (!(radiance > 0.0f)) return 0.0f;
  float range = filmic_brightest - filmic_darkest;
  float x0 = -filmic_darkest / range;
  float stops = log(radiance / filmic_grey) * 1.44269504f;
  float x = clamp((stops - filmic_darkest) / range, 0.0f, 1.0f);
  bool bright = x >= x0;
  float p = bright ? filmic_shoulder : filmic_toe;
  float reach = filmic_slope * (bright ? 1.0f - x0 : x0);                  // t at the end of the curve
  float rise = bright ? 1.0f - filmic_grey_display : filmic_grey_display;  // y has to cover this much
  float scale = reach / pow(pow(reach / rise, p) - 1.0f, 1.0f / p);
  float t = filmic_slope * (x - x0);
  return clamp(filmic_grey_display + t / pow(1.0f + pow(abs(t) / scale, p), 1.0f / p), 0.0f, 1.0f);
}

/// The filmic view of a linear Rec.709 radiance. Returns [display, sRGB-encoded] in [0, 1] per channel.
PLN_FN vec3 filmic_view(vec3 radiance) {
  float mean = (radiance.r + radiance.g + radiance.b) / 3.0f;
  vec3 curved = vec3(0.0f);
  for (int c = 0; c < 3; ++c) curved[c] = filmic_curve(radiance[c] + filmic_inset * (mean - radiance[c]));
  float curved_mean = (curved.r + curved.g + curved.b) / 3.0f;
  return clamp((curved - vec3(filmic_inset * curved_mean)) / (1.0f - filmic_inset), vec3(0.0f), vec3(1.0f));
}

/// The plain view: clipped to [0, 1] and sRGB-encoded.
PLN_FN vec3 srgb_view(vec3 radiance) {
  vec3 shown = vec3(0.0f);
  for (int c = 0; c < 3; ++c) shown[c] = srgb_from_linear(clamp(radiance[c], 0.0f, 1.0f));
  return shown;
}

PLN_END

#endif
