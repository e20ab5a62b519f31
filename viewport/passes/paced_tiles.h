// A picture or a map cut into tiles, each one dispatch.
#pragma once

#include <functional>

#include "core/shared/glue.h"
#include "viewport/gl/objects.h"
#include "viewport/passes/tile_pace.h"

namespace plinian::passes {

struct PacedProgram {
  gl::Program program;
  TilePace pace;
};

/// Runs the program that is in use over [first, end), a tile after the other; its uniform at `location` takes
/// the first pixel of each. `go_on` is asked between tiles; returns false where it said no.
bool run_tiles(PacedProgram& paced, int location, ivec2 first, ivec2 end, const std::function<bool()>& go_on);

}  // namespace plinian::passes
