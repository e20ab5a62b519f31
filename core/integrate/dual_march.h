// The offline reference: single scattering by brute force, a light march for every view sample, on the CPU.
//
// Convergence control: the picture is rendered with coarse steps, then with steps of half the size, again and
// again. A pixel is settled when two doublings in a row changed none of its layers by more than the
// tolerance; it is refined for as long as it or one of its eight neighbours is not settled, so that no pixel
// stops by accident. Rays that meet no medium are exact at once. How one ray is integrated stands in
// ray_integral.h.
//
// The defaults were chosen on a smoke of 111 x 222 x 112 voxels, optical depth 1 and 60 across: against a
// sixteenth of the first steps they end at 133 and 123 dB (peak 1), where the first picture alone stands at
// 74 and 59 dB and each doubling buys some 15 to 20.
//
// The picture depends on nothing but the snapshot and the options: not on the number of threads, not on time.
#pragma once

#include "core/integrate/ray_integral.h"
#include "core/scene/renderer.h"

namespace plinian {

struct DualMarchOptions {
  double tolerance = 1e-3;   // [-] largest change per doubling, relative to the pixel's brightness
  double dark_pixel = 0.05;  // [-] pixels under this share of the picture's peak count as that bright
  int max_doublings = 8;  // of the number of steps; pixels that are not settled then are counted in a warning
  MarchSteps steps;       // of the first picture
};

class DualMarch final : public Renderer {
 public:
  explicit DualMarch(const DualMarchOptions& options = {});

  /// Renders the snapshot; `passes` is ignored. Throws std::invalid_argument for a medium without a volume or
  /// with a singular transform, and for a picture without pixels. stats().passes is the number of pictures it
  /// took.
  Frame render(const SceneSnapshot& scene, const Passes& passes = 1, const Progress& progress = {}) override;
  const RenderStats& stats() const override { return stats_; }

  /// Pixels rendered at each level by the last render().
  const std::vector<std::int64_t>& pixels_per_level() const { return pixels_per_level_; }

 private:
  DualMarchOptions options_;
  RenderStats stats_;
  std::vector<std::int64_t> pixels_per_level_;
};

}  // namespace plinian
