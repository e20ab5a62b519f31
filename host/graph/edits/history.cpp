// Undo, redo, scopes and merging.
#include "host/graph/edits/history.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <iterator>

#include "host/graph/graph_error.h"
#include "host/graph/model/graph.h"

namespace plinian::graph {

History::Scope::Scope(History& history, std::string name, std::string merge_key)
    : history_(history), begin_(history.open_.inverses.size()), exceptions_(std::uncaught_exceptions()) {
  if (history_.depth_++ > 0) return;
  history_.open_.name = std::move(name);
  history_.open_.merge_key = std::move(merge_key);
}

History::Scope::~Scope() {
  if (std::uncaught_exceptions() > exceptions_) roll_back();
  if (--history_.depth_ == 0) history_.commit();
}

void History::Scope::roll_back() {
  history_.play_back(history_.open_.inverses, begin_);
}

// Undoes the edits from `begin` on, the last one first; returns what would do them again, in playing order.
std::vector<Edit> History::play_back(std::vector<Edit>& inverses, std::size_t begin) {
  std::vector<Edit> again;
  again.reserve(inverses.size() - begin);
  while (inverses.size() > begin) {
    again.push_back(graph_.apply(inverses.back()));
    inverses.pop_back();
  }
  return again;
}

void History::perform(const Edit& edit) {
  if (aftermath_ == After::undo)
    throw GraphError("nothing can be edited by who is told of an undo or a redo");
  const Scope scope(*this, "edit");
  open_.inverses.push_back(graph_.apply(edit));
}

void History::commit() {
  Step step = std::move(open_);
  open_ = {};
  if (step.inverses.empty()) return;
  ++steps_made_;
  redo_.clear();
  const bool changes = std::any_of(step.inverses.begin(), step.inverses.end(), changes_scene);
  step.state = changes ? ++last_state_ : state();
  if (aftermath_ == After::step && !undo_.empty()) {
    std::vector<Edit>& into = undo_.back().inverses;
    into.insert(into.end(), std::make_move_iterator(step.inverses.begin()),
                std::make_move_iterator(step.inverses.end()));
    undo_.back().state = step.state;
    return;
  }
  const bool merges =
      can_merge_ && !step.merge_key.empty() && !undo_.empty() && undo_.back().merge_key == step.merge_key;
  can_merge_ = true;
  if (!merges) {
    undo_.push_back(std::move(step));
    return;
  }
  // Where a step only sets values, the first inverse of each plug says all: it holds the oldest value.
  std::vector<Edit>& into = undo_.back().inverses;
  undo_.back().state = step.state;
  const auto sets = [](const Edit& edit) { return std::holds_alternative<SetValue>(edit); };
  const bool only_values = std::all_of(into.begin(), into.end(), sets);
  for (Edit& edit : step.inverses) {
    const auto same = [&](const Edit& old) {
      return std::get<SetValue>(old).plug == std::get<SetValue>(edit).plug;
    };
    if (only_values && sets(edit) && std::all_of(into.begin(), into.end(), sets) &&
        std::any_of(into.begin(), into.end(), same))
      continue;
    into.push_back(std::move(edit));
  }
}

std::string History::undo() {
  assert(depth_ == 0);
  if (undo_.empty()) return "";
  ++steps_repeated_;
  Step step = std::move(undo_.back());
  undo_.pop_back();
  step.inverses = play_back(step.inverses, 0);
  can_merge_ = false;
  redo_.push_back(std::move(step));
  return redo_.back().name;
}

std::string History::redo() {
  assert(depth_ == 0);
  if (redo_.empty()) return "";
  ++steps_repeated_;
  Step step = std::move(redo_.back());
  redo_.pop_back();
  step.inverses = play_back(step.inverses, 0);
  can_merge_ = false;
  undo_.push_back(std::move(step));
  return undo_.back().name;
}

std::vector<std::string> History::undo_names() const {
  std::vector<std::string> names;
  for (const Step& step : undo_) names.push_back(step.name);
  return names;
}

std::vector<std::string> History::redo_names() const {
  std::vector<std::string> names;
  for (auto step = redo_.rbegin(); step != redo_.rend(); ++step) names.push_back(step->name);
  return names;
}

void History::forget_steps() {
  const bool modified = is_modified();
  clear();
  if (!modified) mark_saved();
}

void History::clear() {
  undo_.clear();
  redo_.clear();
  can_merge_ = false;
  first_state_ = ++last_state_;
}

}  // namespace plinian::graph
