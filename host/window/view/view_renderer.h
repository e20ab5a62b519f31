// Renders on a thread of its own: takes the newest request, drops those that it overtook, shows a quick
// picture first and refines it until it is at rest. Nobody waits for it.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "host/window/view/media_extent.h"
#include "viewport/light_map_copy.h"

namespace plinian::window {

struct ViewRequest {
  SceneSnapshot scene;       // its size: of the picture at rest [pixels]
  std::uint64_t number = 0;  // of what it shows: another number, another picture
  double time = 0.0;         // [frames] that it shows
  bool hand_on = false;      // it is about to change again: a quick picture is enough
  bool light_maps = false;   // somebody draws over it who may look them up
};

/// A picture as it was rendered. Immutable.
struct ViewPicture {
  Frame frame;
  SceneSnapshot scene;                                        // that it shows, at the size at rest
  MediaExtent::Ptr extent = std::make_shared<MediaExtent>();  // of its media
  std::uint64_t number = 0;                                   // of the request
  double time = 0.0;                                          // [frames] likewise
  bool quick = false;                                         // smaller than asked for, and of one pass
  bool at_rest = false;                                       // no further pass follows
  int passes = 0;
  bool is_played = false;       // shown again, without its layers: see PlayedFrames
  int map_resolution = 0;       // [texels] of its light maps
  std::int64_t map_builds = 0;  // maps that were built for it
  RenderStats stats;
  double render_ms = 0.0;      // wall clock since the request was taken up
  LightMapCopyPtr light_maps;  // that it was made with, where the request wanted them and there are any
};
using ViewPicturePtr = std::shared_ptr<const ViewPicture>;

class ViewRenderer {
 public:
  using Maker = std::function<std::unique_ptr<Renderer>()>;

  /// make: called on the renderer's thread; throws where there is none. wake: called on that thread whenever
  /// there is news; must not block.
  ViewRenderer(Maker make, std::function<void()> wake);
  ~ViewRenderer();
  ViewRenderer(const ViewRenderer&) = delete;
  ViewRenderer& operator=(const ViewRenderer&) = delete;

  /// Takes the place of the request before. One for the same number and size only tells whether a hand is on
  /// and whether light maps are wanted.
  void ask(ViewRequest request);
  /// The newest picture, or null before the first.
  ViewPicturePtr picture() const;

  struct Status {
    bool is_busy = false;
    double share = 0.0;         // [0, 1] of the pass or picture under way
    std::string error;          // of the last request that failed, one line; empty where it did not
    std::uint64_t dropped = 0;  // requests that newer ones overtook before they were begun
    std::uint64_t begun = 0;
  };
  Status status() const;

 private:
  class Thread;
  void run();

  Maker make_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable news_;
  std::optional<ViewRequest> waiting_;
  std::uint64_t asked_number_ = 0;
  ivec2 asked_size_{0};
  bool asked_hand_on_ = false, asked_light_maps_ = false;
  ViewPicturePtr picture_;
  Status status_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace plinian::window
