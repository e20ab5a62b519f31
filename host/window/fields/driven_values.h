// Numbers of attributes that something drives, as far as they are known: what takes time to compute is
// computed by workers, and shown when it is there.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <utility>

#include "host/graph/commands/session.h"

namespace plinian::window {

class DrivenValues {
 public:
  /// As it is now, or, while that is being computed, as it was last. 0 before the first, and where it failed.
  double number(graph::Session& session, const graph::Plug& plug);
  /// Whether something is being computed.
  bool is_waiting() const { return !state_->asked.empty(); }
  /// Whether values have come since the last call.
  bool take_news() { return std::exchange(state_->has_news, false); }

 private:
  // Outlives this while a worker computes.
  struct State {
    std::set<graph::Plug> asked;  // requests in flight
    bool has_news = false;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
  std::map<graph::Plug, double> known_;
};

}  // namespace plinian::window
