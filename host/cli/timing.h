// What maps, frames and edits cost. Everything is measured in turn within one run, because absolute times
// move from run to run; medians, and ratios of what was measured side by side.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/scene/snapshot.h"
#include "host/cli/swim.h"

namespace plinian::cli {

struct TimingOptions {
  int runs = 5;         // medians are over so many
  int passes = 1;       // of each frame
  std::string against;  // another program's command line, run in turn with the orbit frames; may be empty
};

/// Times an orbit frame and every kind of edit with every quality, and an orbit frame that marches to the
/// light with the same view march. Returns "machine", "renderers" (medians [ms] and bytes by renderer and
/// quality), "ratios" (medians of the ratios within each run), "map_builds", "skipped" (renderers that do not
/// run here, and why), and, where asked, "against". Throws RenderCancelled where `progress` returns false,
/// and std::runtime_error where no renderer runs here or the other program fails.
nlohmann::ordered_json measure_times(const SceneSnapshot& scene, const std::vector<BenchQuality>& qualities,
                                     const TimingOptions& options,
                                     const std::function<bool(double)>& progress);

}  // namespace plinian::cli
