// A colour map for errors: black over purple and orange to pale yellow, lightness rising evenly.
//
// The map is magma [Smith and van der Walt 2015, matplotlib, CC0], from ten published anchors, joined
// linearly in sRGB; a test holds its lightness to rising all along.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/shared/glue.h"

namespace plinian {

/// The colour of a value [-]; under 0 is 0, over 1 is 1. Returns [sRGB-encoded] in [0, 1]. Not-a-number is
/// cyan, a colour that the map does not have.
vec3 heat_colour(float value);

/// A picture of `values`, each divided by `full_scale` (> 0): 3 bytes per value, sRGB.
std::vector<std::uint8_t> heat_bytes(std::span<const float> values, float full_scale);

/// A round number (1, 2 or 5 times a power of ten) that at most 0.1% of the values exceed; 1e-6 where they
/// are all smaller. For the scale of a heat map.
float heat_full_scale(std::span<const float> values);

}  // namespace plinian
