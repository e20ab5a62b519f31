// From the graph to the snapshot that is shown, without waiting: what is dirty is computed by workers, and
// until it is there the last good snapshot stays.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/scene/workspace.h"

namespace plinian::window {

class SceneFeed : private graph::GraphObserver {
 public:
  explicit SceneFeed(scene::Workspace& workspace);
  ~SceneFeed() override;
  SceneFeed(const SceneFeed&) = delete;
  SceneFeed& operator=(const SceneFeed&) = delete;

  /// Takes over what workers have finished, and asks them for what is missing. Returns whether there is a new
  /// snapshot. To be called once a turn.
  bool update();
  /// The last good one; its size and camera are the scene's. Empty before the first.
  const std::shared_ptr<const scene::BuiltSnapshot>& snapshot() const { return snapshot_; }
  /// Whether the snapshot is older than the scene: something is still being computed, or failed.
  bool is_stale() const { return stale_; }
  /// Of what the snapshot shows. [frames]
  double time() const { return time_; }
  bool is_computing() const { return request_ != 0; }
  /// How far that is [0, 1], and what it is.
  graph::Evaluator::Progress progress() const;
  /// Why there is no newer snapshot, one line for each cause.
  const std::vector<std::string>& problems() const { return problems_; }
  /// Gives up what is being computed; the scene stays as it is until it is edited.
  void cancel();

 private:
  struct Seen {
    double time = 0.0;
    std::string quality;
    graph::NodeId camera;
    std::set<graph::NodeId> isolated;
    bool operator==(const Seen&) const = default;
  };
  void edited(const graph::Edit& edit) override;
  bool build();

  scene::Workspace& workspace_;
  std::shared_ptr<const scene::BuiltSnapshot> snapshot_;
  std::vector<std::string> problems_;
  Seen seen_;
  double time_ = 0.0;
  bool changed_ = true, stale_ = true;
  graph::Evaluator::RequestId request_ = 0;
};

}  // namespace plinian::window
