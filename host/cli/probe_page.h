// A page that shows what a probe found: curves that any browser draws.
#pragma once

#include <string>
#include <vector>

#include "core/integrate/ray_probe.h"

namespace plinian::cli {

struct ProbeReport {
  std::string scene, command;  // what was probed, and the command line
  ivec2 pixel{0}, size{0};     // [pixels]
  ViewRayProbe view;
  double t = 0.0;                     // [world] of the point that lights are probed at
  std::vector<LightRayProbe> lights;  // of that point; empty where the ray meets nothing
};

/// One self-contained HTML file: extinction and transmittance along the view ray, and for each light the
/// exact transmittance, its map's, and the bounds.
std::string probe_page(const ProbeReport& report);

}  // namespace plinian::cli
