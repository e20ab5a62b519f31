// Tells whoever asks what happens to a scene, between commands.
//
// Edits are noted as they are made, and told when nothing is under way: after a command that no other one
// runs, or by deliver(). What a failed command took back is not told. Opening a scene is told as such, not
// node by node.
//
// What callbacks edit belongs to the step of undo that they are told of. Of undo and redo they are told, too,
// but may edit nothing then: the step brings their edits with it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

#include "host/graph/commands/session.h"

namespace plinian::sdk {

enum class EventKind {
  node_created,
  node_deleted,
  node_renamed,
  attribute_changed,
  connected,
  disconnected,
  selection_changed,
  time_changed,
  before_new,
  after_new,
  before_open,
  after_open,
  before_save,
  after_save
};

/// "nodeCreated", as plug-ins spell it; and back. Throws GraphError, with the nearest name, for none.
const std::string& event_name(EventKind kind);
EventKind event_of_name(const std::string& name);

struct SceneEvent {
  EventKind kind = EventKind::node_created;
  std::string node, plug, other;  // as in PlinianEvent
  double time = 0.0;              // [frames]
};

struct EventEntry;

class EventHub : private graph::GraphObserver, private graph::SessionListener {
 public:
  /// Throws to say that it failed: told as a warning of the session, once, and nobody else suffers.
  using Callback = std::function<void(const SceneEvent&)>;

  explicit EventHub(graph::Session& session);
  ~EventHub() override;
  EventHub(const EventHub&) = delete;
  EventHub& operator=(const EventHub&) = delete;

  /// Lasts until it is destroyed or ended; may outlive the hub.
  class Subscription {
   public:
    Subscription() = default;
    Subscription(Subscription&&) = default;
    Subscription& operator=(Subscription&& other) {
      end();
      entry_ = std::move(other.entry_);
      return *this;
    }
    ~Subscription() { end(); }
    void end();

   private:
    friend class EventHub;
    std::weak_ptr<EventEntry> entry_;
  };
  /// owner: named where the callback fails.
  [[nodiscard]] Subscription subscribe(EventKind kind, std::string owner, Callback callback);

  /// Tells what is waiting, unless something is under way. For edits made without a command, as by a drag.
  void deliver();
  /// Whether a callback is running, and this is its thread.
  bool is_delivering() const { return std::this_thread::get_id() == thread_ && delivering_; }
  graph::Session& session() { return session_; }

 private:
  void edited(const graph::Edit& edit) override;
  void passed(graph::SceneMoment moment, const std::string& path) override;
  void begun() override;
  void ended(bool failed) override;
  bool can_deliver() const;
  void deliver_rounds();
  void note(SceneEvent event);
  void tell(const SceneEvent& event);
  bool wanted(EventKind kind) const { return subscribers_[std::size_t(kind)] != 0; }

  graph::Session& session_;
  const std::thread::id thread_ = std::this_thread::get_id();
  std::vector<std::shared_ptr<EventEntry>> entries_;
  std::vector<int> subscribers_;                          // by kind
  std::unordered_map<graph::NodeId, std::string> names_;  // of nodes that may be gone when they are told of
  std::vector<SceneEvent> waiting_;
  std::size_t mark_ = 0;                                 // where the running command began
  std::uint64_t steps_before_ = 0, repeats_before_ = 0;  // likewise, of the history
  double time_ = 0.0;                                    // told last
  bool opening_ = false, delivering_ = false;
  bool after_undo_ = false;  // what is told is an undo or a redo
};

}  // namespace plinian::sdk
