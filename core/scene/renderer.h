// The interface that the GL renderer, its CPU twin and the offline reference answer to.
#pragma once

#include <functional>
#include <memory>
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

class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Renders `passes` jittered passes of the snapshot (the reference ignores it). Maps and volumes are kept
  /// from one call to the next and rebuilt only for the reasons listed in map_key.h.
  virtual Frame render(const SceneSnapshot& scene, int passes, const Progress& progress = {}) = 0;
  virtual const RenderStats& stats() const = 0;
};

}  // namespace plinian
