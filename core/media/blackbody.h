// The colour of a black body, exactly and as the table that every renderer reads.
//
// Planck's law against the CIE 1931 2-degree observer, in the multi-lobe fit of Wyman, Sloan and Shirley,
// "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2), 2013. Brightness is
// left out: it follows (T/1800)^4, see core/media/medium.h.
#pragma once

#include <array>

#include "core/shared/blackbody_lookup.h"

namespace plinian {

/// Colour of a black body, linear Rec.709 [-], luminance 1. Channels outside the gamut (blue under about 1900
/// K, green under about 850 K) are clamped to zero, then the luminance is made 1 again. kelvin: > 0; under
/// 100 K the colour of 100 K.
vec3 planck_colour(double kelvin);

/// planck_colour at blackbody_entries temperatures from blackbody_first to blackbody_last, evenly spaced; w
/// is 0.
using BlackbodyTable = std::array<vec4, shared::blackbody_entries>;
const BlackbodyTable& blackbody_table();

/// The table's colour at a temperature [K], clamped to its ends. Within 0.3% of planck_colour (where green
/// leaves the gamut; far better elsewhere): it is what all renderers use, so it counts as the definition.
vec3 blackbody_colour(float kelvin);

}  // namespace plinian
