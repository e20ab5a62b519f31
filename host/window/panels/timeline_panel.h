// The timeline: where in time one is, and what is keyed there.
#pragma once

#include <chrono>
#include <vector>

#include "host/window/panels/widgets.h"
#include "host/window/studio.h"

namespace plinian::window {

class TimelinePanel {
 public:
  void show(Studio& studio, const PaneRect& pane);
  bool is_playing() const { return playing_; }
  /// Goes to the next frame where it is time for it. To be called once a turn.
  void play(Studio& studio);
  void toggle_play(Studio& studio);
  void step(Studio& studio, double frames);

 private:
  struct Range {
    double start = 1.0, end = 100.0, rate = 24.0;  // [frames], [frames/s]
  };
  Range range_of_scene(Studio& studio) const;
  void find_keys(Studio& studio);
  void go_to(Studio& studio, double frame);

  bool playing_ = false, every_frame_ = false;
  std::chrono::steady_clock::time_point stepped_{};  // to the frame that is shown, where every one is
  std::chrono::steady_clock::time_point began_{};
  double began_at_ = 1.0;     // [frames]
  std::vector<double> keys_;  // [frames] of the selection
  std::uint64_t generation_ = ~std::uint64_t(0);
};

}  // namespace plinian::window
