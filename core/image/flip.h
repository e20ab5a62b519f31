// FLIP: the difference that a viewer sees when two pictures alternate.
//
// Source: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images", HPG 2020. Both pictures are filtered as the eye filters at a viewing distance
// (contrast sensitivity in an opponent colour space), compared by the HyAB distance of Hunt-adjusted L*a*b*,
// and the difference is amplified where edges or points differ. Written from the paper's formulas; leaves out
// HDR-FLIP, whose place is taken by measuring at stated exposures.
#pragma once

#include <span>
#include <vector>

#include "core/shared/glue.h"

namespace plinian {

struct FlipSettings {
  float exposure = 0.0f;  // [stops] both pictures are multiplied by 2^exposure and clipped to [0, 1]
  float pixels_per_degree = 67.02f;  // [pixels / degree] 0.7 m from a 0.7 m wide screen of 3,840 pixels
};

struct FlipResult {
  float mean = 0.0f;       // [-] in [0, 1]
  float max = 0.0f;        // [-] in [0, 1]
  std::vector<float> map;  // [-] in [0, 1], width * height, top row first
};

/// FLIP of two linear Rec.709 pictures of width * height finite pixels, top row first. Symmetric; 0 where
/// they are equal; 1 for flat green against flat blue, the largest difference that a display can show. width,
/// height >= 1.
FlipResult flip(std::span<const vec3> a, std::span<const vec3> b, int width, int height,
                const FlipSettings& settings = {});

}  // namespace plinian
