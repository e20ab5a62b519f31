// How far the media of a scene reach. That follows from all their bricks, so it is worked out beside the
// picture, once for media that stay where they are, and not while the interface is drawn.
#pragma once

#include <memory>
#include <vector>

#include "core/scene/framing.h"

namespace plinian::window {

class MediaExtent {
 public:
  using Ptr = std::shared_ptr<const MediaExtent>;
  /// before: may be null; is handed back where it tells of the same.
  static Ptr of(const std::vector<Medium>& media, const Ptr& before = nullptr);

  const SceneBounds& all() const { return all_; }
  /// Of the i-th medium; null where it is empty.
  const SceneBounds* medium(std::size_t i) const;

 private:
  bool tells_of(const std::vector<Medium>& media) const;

  std::vector<Medium> media_;
  SceneBounds all_;
  std::vector<SceneBounds> each_;
};

}  // namespace plinian::window
