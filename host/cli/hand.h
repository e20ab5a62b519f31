// A hand on the window's controls, without a window: asks the window's own renderer for pictures sixty times
// a second, and notes what arrives and when.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <vector>

#include "host/window/view/view_renderer.h"

namespace plinian::cli {

class Hand {
 public:
  /// Returns false once the user has interrupted; share: of the movement or of the time to wait [0, 1].
  using Progress = std::function<bool(double share)>;

  struct Arrival {
    double latency_ms = 0.0;  // from when its scene was asked for first
    double at_s = 0.0;        // since the movement or the wait began
    window::ViewPicturePtr picture;
  };
  struct Movement {
    std::vector<Arrival> arrivals;  // pictures of this movement alone
    std::uint64_t asked = 0, dropped = 0;
    double seconds = 0.0;
  };

  explicit Hand(window::ViewRenderer::Maker make);

  /// Asks for scene_at(u) at 60 Hz while u goes from 0 to 1. keeps: whether the arrival number so many keeps
  /// its frame; of others only the figures stay. Throws RenderCancelled, and what rendering threw.
  Movement move(double seconds, const std::function<SceneSnapshot(double u)>& scene_at,
                const std::function<bool(double u)>& keeps, const Progress& progress);
  /// Lets go of the last scene that was asked for, or of another one, and waits until its picture is at rest,
  /// or for so long. Every frame is kept.
  std::vector<Arrival> rest(double most_seconds, const Progress& progress);
  std::vector<Arrival> rest(const SceneSnapshot& scene, double most_seconds, const Progress& progress);
  /// Lets go of a scene, takes hold of another one after a while, and returns how long its picture took. [ms]
  double interrupt(const SceneSnapshot& scene, const SceneSnapshot& next, double after_seconds,
                   const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;
  void begin();
  void ask(const SceneSnapshot& scene, bool new_picture, bool hand_on);
  void arrived();
  std::vector<Arrival> let_go(const SceneSnapshot& scene, bool new_picture, double most_seconds,
                              const Progress& progress);
  void check(const Progress& progress, double share);
  // Until `ready` of what has arrived, or the time is over.
  void wait(double most_seconds, const std::function<bool()>& ready, const Progress& progress);

  std::mutex mutex_;  // guards what follows, up to the renderer
  std::condition_variable news_;
  std::map<std::uint64_t, Clock::time_point> asked_at_;  // of the movement
  std::map<std::uint64_t, double> place_of_;             // u of each number
  std::function<bool(double u)> keeps_;
  std::vector<Arrival> arrivals_;
  window::ViewPicturePtr last_;
  Clock::time_point begin_;

  SceneSnapshot scene_;
  std::uint64_t number_ = 0;
  window::ViewRenderer renderer_;  // its thread calls arrived()
};

}  // namespace plinian::cli
