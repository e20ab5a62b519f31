// Undo of the camera, apart from that of the scene.
#pragma once

#include <optional>
#include <vector>

#include "host/window/navigation/free_camera.h"

namespace plinian::window {

/// How the viewport looks: through a camera of the scene, or through the artist's own.
struct Look {
  std::optional<FreeCamera> free;  // none: through the scene's
};

class CameraHistory {
 public:
  /// Notes how it was before a move; what was taken back is forgotten.
  void note(const Look& before);
  /// The one before, or after it was taken back; none where there is none.
  std::optional<Look> back(const Look& now);
  std::optional<Look> forth(const Look& now);
  void clear();

 private:
  std::vector<Look> back_, forth_;
};

}  // namespace plinian::window
