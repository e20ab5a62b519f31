// Pictures of frames that were played, to be shown again at once where they would come out the same.
//
// They are kept without their layers: what shows a light alone, or another layer than beauty, alpha and
// depth, is rendered anew.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "host/window/view/view_renderer.h"

namespace plinian::window {

/// What the pictures of all frames have in common: where it changes they are played anew.
struct Take {
  std::uint64_t generation = 0;  // of the graph
  std::string quality;           // the set that is on
  bool original_maps = false;
  ivec2 size{0};               // [pixels]
  std::optional<Camera> free;  // empty: through the scene's camera
};
bool operator==(const Take& a, const Take& b);

class PlayedFrames {
 public:
  /// budget: of all pictures [bytes].
  explicit PlayedFrames(std::size_t budget = std::size_t(1) << 30) : budget_(budget) {}

  /// Forgets the pictures of another take. Returns whether it is another one.
  bool begin(const Take& take);
  /// Keeps it, unless there is a better one of the same. What was not asked for the longest leaves first.
  void keep(const ViewPicture& picture);
  /// The picture of a scene, or null.
  ViewPicturePtr find(const SceneSnapshot& scene);
  /// Frames of which there are pictures past the quick one, in no order.
  std::vector<double> frames() const;
  std::size_t bytes() const { return bytes_; }

 private:
  struct Played {
    ViewPicturePtr picture;
    std::size_t bytes = 0;
  };

  std::size_t budget_;
  std::size_t bytes_ = 0;
  Take take_;
  std::list<Played> played_;  // asked for last first
};

}  // namespace plinian::window
