// The one immutable value that front ends make and renderers read.
#pragma once

#include <memory>
#include <vector>

#include "core/lights/light.h"
#include "core/media/medium.h"
#include "core/scene/camera.h"
#include "core/scene/quality.h"

namespace plinian {

struct SceneSnapshot {
  Camera camera;
  std::vector<Medium> media;
  std::vector<Light> lights;
  vec3 ambient{0.0f};     // [radiance] L_a of the scattered ambient light [TFM11 4.3], unshadowed
  vec3 background{0.0f};  // [radiance] constant sky, seen through the media
  Quality quality;
  // [-] >= 1: a map that is there serves up to so many times its extinction, see map_power(). No preset's:
  // for quick pictures, while a hand is on.
  float extinction_reuse = 1.0f;
  int width = 512, height = 512;  // [pixels]
};

}  // namespace plinian
