#include "viewport/passes/paced_tiles.h"

#include <epoxy/gl.h>

#include <chrono>

namespace plinian::passes {

bool run_tiles(PacedProgram& paced, int location, ivec2 first, ivec2 end,
               const std::function<bool()>& go_on) {
  using Clock = std::chrono::steady_clock;
  constexpr int group = TilePace::group_size, height = group * TilePace::most_groups;
  for (int y = first.y; y < end.y; y += height)
    for (int x = first.x; x < end.x;) {
      if (go_on && !go_on()) return false;
      // Where nobody asks, nobody waits, and a tile need only be short enough for a watchdog.
      const int most = go_on ? paced.pace.columns() : TilePace::most_groups;
      const int columns = std::min((end.x - x + group - 1) / group, most);
      glProgramUniform2i(paced.program.name(), location, x, y);
      const Clock::time_point start = Clock::now();
      // All rows of groups, as spread_group() in scene_access.glsl asks; those outside end at once.
      glDispatchCompute(unsigned(columns), TilePace::most_groups, 1);
      if (go_on) {
        glFinish();
        paced.pace.took(columns, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
      }
      x += columns * group;
    }
  return true;
}

}  // namespace plinian::passes
