// Hue, saturation and value of a scene-linear colour: what a hand turns, where fields hold what is computed
// with.
//
// They are those of its plain sRGB encoding, because steps of it look even. The encoding goes on beyond 1, so
// that what is brighter than a display can show has them, too.
#pragma once

#include "core/shared/glue.h"

namespace plinian::window {

struct Hsv {
  float hue = 0.0f;         // [degrees] in [0, 360): 0 red, 120 green, 240 blue
  float saturation = 0.0f;  // [-] in [0, 1]
  float value = 0.0f;       // [display] >= 0; over 1: brighter than a display shows
};

/// Of a linear colour; what is negative counts as 0. before: a grey keeps its hue, and black its saturation
/// as well, so that they are still there when the colour comes back.
Hsv hsv_of(const vec3& linear, const Hsv& before);

/// The linear colour of that hue, saturation and value. hue: any.
vec3 linear_of(const Hsv& hsv);

}  // namespace plinian::window
