// The interface that the GL renderer, its CPU twin and the offline reference answer to.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>

#include "core/scene/frame.h"
#include "core/scene/snapshot.h"

namespace plinian {

/// Called with a share of the work done in [0, 1]; returning false cancels.
using Progress = std::function<bool(double)>;

/// Thrown by render() when its Progress returned false.
struct RenderCancelled : std::runtime_error {
  RenderCancelled() : std::runtime_error("cancelled") {}
};

/// How many jittered passes a picture takes: a plain number means exactly so many.
struct Passes {
  Passes(int exactly) : most(exactly) {}  // implicit, so that a number will do
  Passes(int most_, float rest_change_) : most(most_), rest_change(rest_change_) {}

  int most;                  // >= 1
  float rest_change = 0.0f;  // [8-bit steps] ends earlier where no more change than this is to come, see
                             // RestGauge; 0: never
  /// Called after each pass with the number done and, when it is known anew, the change still to come.
  /// Returning false ends the picture with what there is.
  std::function<bool(int done, std::optional<float> change)> after_pass;
  /// Called before that, for whoever shows a picture while it is refined: `mean` makes the picture of the
  /// passes done so far, which costs time only where it is called.
  std::function<void(int done, const std::function<Frame()>& mean)> on_mean;
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Renders jittered passes of the snapshot (the reference ignores how many). Maps and volumes are kept
  /// from one call to the next and rebuilt only for the reasons listed in map_key.h.
  virtual Frame render(const SceneSnapshot& scene, const Passes& passes, const Progress& progress = {}) = 0;
  virtual const RenderStats& stats() const = 0;
};

}  // namespace plinian
