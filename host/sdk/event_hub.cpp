// Noting and telling events.
#include "host/sdk/event_hub.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"

namespace plinian::sdk {

namespace {

const std::array<std::string, 14> names = {
    "nodeCreated",  "nodeDeleted",      "nodeRenamed", "attributeChanged", "connected",
    "disconnected", "selectionChanged", "timeChanged", "beforeNew",        "afterNew",
    "beforeOpen",   "afterOpen",        "beforeSave",  "afterSave"};

// Callbacks whose edits call them again come to an end.
constexpr int max_rounds = 100;

}  // namespace

struct EventEntry {
  EventKind kind;
  std::string owner;
  EventHub::Callback callback;  // empty once it has ended
  int* subscribers;             // of its kind
  bool failed = false;
};

const std::string& event_name(EventKind kind) {
  return names[std::size_t(kind)];
}

EventKind event_of_name(const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return EventKind(found - names.begin());
  throw graph::GraphError("there is no event " + graph::shown(name) +
                          did_you_mean(name, std::vector<std::string>(names.begin(), names.end())));
}

EventHub::EventHub(graph::Session& session)
    : session_(session), subscribers_(names.size()), time_(session.evaluator().time()) {
  for (const graph::Node* node : session.graph().nodes()) names_[node->id] = node->name;
  session_.graph().add_observer(this);
  session_.add_listener(this);
}

EventHub::~EventHub() {
  session_.remove_listener(this);
  session_.graph().remove_observer(this);
}

EventHub::Subscription EventHub::subscribe(EventKind kind, std::string owner, Callback callback) {
  int& count = subscribers_[std::size_t(kind)];
  ++count;
  Subscription subscription;
  entries_.push_back(
      std::make_shared<EventEntry>(EventEntry{kind, std::move(owner), std::move(callback), &count}));
  subscription.entry_ = entries_.back();
  return subscription;
}

void EventHub::Subscription::end() {
  const std::shared_ptr<EventEntry> entry = entry_.lock();
  entry_.reset();
  if (!entry || !entry->callback) return;
  --*entry->subscribers;
  entry->callback = nullptr;  // taken out of the list when that is not being gone through
}

void EventHub::note(SceneEvent event) {
  if (!wanted(event.kind)) return;
  // Once is enough for an attribute that is set several times in a row.
  if ((event.kind == EventKind::attribute_changed || event.kind == EventKind::selection_changed) &&
      waiting_.size() > mark_ && waiting_.back().kind == event.kind && waiting_.back().plug == event.plug)
    return;
  waiting_.push_back(std::move(event));
}

void EventHub::edited(const graph::Edit& edit) {
  using namespace graph;
  const Graph& graph = session_.graph();
  if (const auto* add = std::get_if<AddNode>(&edit)) {
    const std::string& name = names_[add->node->id] = graph.find(add->node->id)->name;
    if (!opening_) note({EventKind::node_created, name});
  } else if (const auto* remove = std::get_if<RemoveNode>(&edit)) {
    const auto name = names_.find(remove->node);
    if (!opening_) note({EventKind::node_deleted, name->second});
    names_.erase(name);
  } else if (const auto* rename = std::get_if<RenameNode>(&edit)) {
    const std::string before = std::exchange(names_[rename->node], rename->name);
    if (!opening_) note({EventKind::node_renamed, rename->name, "", before});
  } else if (opening_) {
    return;
  } else if (const auto* value = std::get_if<SetValue>(&edit)) {
    if (wanted(EventKind::attribute_changed))
      note({EventKind::attribute_changed, "", graph.name_of(value->plug)});
  } else if (const auto* input = std::get_if<SetInput>(&edit)) {
    const EventKind kind = input->source ? EventKind::connected : EventKind::disconnected;
    if (wanted(kind))
      note({kind, "", graph.name_of(input->destination), input->source ? graph.name_of(*input->source) : ""});
  } else if (std::holds_alternative<SetSelection>(edit)) {
    note({EventKind::selection_changed});
  }
}

void EventHub::passed(graph::SceneMoment moment, const std::string& path) {
  const auto kind = EventKind(int(EventKind::before_new) + int(moment));
  using enum graph::SceneMoment;
  const bool after = moment == after_new || moment == after_open || moment == after_save;
  if (moment == before_new || moment == before_open) {
    tell({kind, "", "", path});
    opening_ = true;
    return;
  }
  if (moment == after_new || moment == after_open) {
    opening_ = false;
    waiting_.clear();  // what was to be told of the old scene
    mark_ = 0;
  }
  if (after)
    note({kind, "", "", path});
  else
    tell({kind, "", "", path});
}

void EventHub::begun() {
  mark_ = waiting_.size();
  steps_before_ = session_.history().steps_made();
  repeats_before_ = session_.history().steps_repeated();
}

void EventHub::ended(bool failed) {
  opening_ = false;
  if (failed && mark_ <= waiting_.size()) waiting_.resize(mark_);
  mark_ = 0;
  if (!can_deliver()) return;
  graph::History& history = session_.history();
  after_undo_ = history.steps_repeated() != repeats_before_;
  std::optional<graph::History::Aftermath> aftermath;
  if (after_undo_ || (!failed && history.steps_made() != steps_before_))
    aftermath.emplace(history, after_undo_);
  deliver_rounds();
  after_undo_ = false;
}

// Nothing is under way that will tell later.
bool EventHub::can_deliver() const {
  return !delivering_ && !session_.history().is_open() && std::this_thread::get_id() == thread_;
}

void EventHub::deliver() {
  if (!can_deliver()) return;
  deliver_rounds();
}

void EventHub::deliver_rounds() {
  for (int round = 0; round < max_rounds; ++round) {
    if (session_.evaluator().time() != time_) {
      time_ = session_.evaluator().time();
      note({.kind = EventKind::time_changed, .time = time_});
    }
    if (waiting_.empty()) return;
    mark_ = 0;
    const std::vector<SceneEvent> events = std::exchange(waiting_, {});
    for (const SceneEvent& event : events) tell(event);
  }
  waiting_.clear();
  session_.warn("event callbacks cause events without end; the rest is not told");
}

void EventHub::tell(const SceneEvent& event) {
  if (!wanted(event.kind) || std::this_thread::get_id() != thread_) return;
  const bool outermost = !std::exchange(delivering_, true);
  const std::vector<std::shared_ptr<EventEntry>> entries = entries_;  // callbacks may subscribe and end
  for (const std::shared_ptr<EventEntry>& entry : entries) {
    if (entry->kind != event.kind || !entry->callback) continue;
    const Callback callback = entry->callback;  // may end itself
    std::string failure;
    try {
      callback(event);
    } catch (const std::exception& error) {
      failure = error.what();
    } catch (...) {
      failure = "no reason is given";
    }
    // Who edits whenever it is told is refused after an undo, which is no failure of its own.
    if (failure.empty() || after_undo_ || std::exchange(entry->failed, true)) continue;
    session_.warn(entry->owner + ": its callback for " + event_name(event.kind) + " failed: " + failure);
  }
  if (!outermost) return;
  delivering_ = false;
  std::erase_if(entries_, [](const std::shared_ptr<EventEntry>& entry) { return !entry->callback; });
}

}  // namespace plinian::sdk
