// Events in C++: what happens to a scene, told between commands.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/support.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

/// Fields as in PlinianEvent.
class Event {
 public:
  Event(const PlinianHost& host, const PlinianEvent& plain)
      : kind(plain.kind),
        node(plain.node),
        plug(plain.plug),
        other(plain.other),
        time(plain.time),
        host_(host) {}

  std::string kind, node, plug, other;
  double time = 0.0;  // [frames]

  /// Runs a command and returns what it answers. Throws Error where it fails.
  std::string execute(const std::string& line) const {
    const char* answers = "";
    if (!host_.execute(host_.self, line.c_str(), &answers)) throw Error(host_.error(host_.self));
    return answers;
  }

 private:
  const PlinianHost& host_;
};

/// A callback that is called until this is destroyed, or the plug-in is unloaded.
class Subscription {
 public:
  Subscription() = default;
  /// alive: empties when the host goes.
  Subscription(const PlinianHost& host, std::weak_ptr<const bool> alive, const std::string& kind,
               std::function<void(const Event&)> callback)
      : state_(std::make_unique<State>(State{&host, std::move(alive), std::move(callback), 0})) {
    if (!state_->callback) throw Error("the event '" + kind + "' is given no function to call");
    state_->number =
        host.subscribe(host.self, kind.c_str(), state_.get(), [](void* user, const PlinianEvent* plain) {
          State& state = *static_cast<State*>(user);
          int success = 0;
          detail::guarded(
              [&] {
                // It may end itself.
                const auto running = state.callback;
                running(Event(*state.host, *plain));
                success = 1;
              },
              [host = state.host](const char* message) { host->fail(host->self, message); });
          return success;
        });
    if (state_->number == 0) throw Error(host.error(host.self));
  }
  Subscription(Subscription&&) = default;
  Subscription& operator=(Subscription&& other) {
    end();
    state_ = std::move(other.state_);
    return *this;
  }
  ~Subscription() { end(); }
  void end() {
    if (state_ && !state_->alive.expired()) state_->host->unsubscribe(state_->host->self, state_->number);
    state_.reset();
  }

 private:
  struct State {
    const PlinianHost* host;
    std::weak_ptr<const bool> alive;
    std::function<void(const Event&)> callback;
    std::uint64_t number;
  };
  std::unique_ptr<State> state_;
};

}  // namespace sdk
}  // namespace plinian
