// Undo, redo, scopes and merging.
#include "host/graph/edits/history.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <iterator>
#include <utility>

#include "host/graph/edits/footprint.h"
#include "host/graph/edits/sleep.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/graph.h"

namespace plinian::graph {

History::Scope::Scope(History& history, std::string name, std::string merge_key)
    : history_(history), begin_(history.open_.inverses.size()), exceptions_(std::uncaught_exceptions()) {
  if (history_.depth_++ > 0) return;
  history_.open_.name = std::move(name);
  history_.open_.merge_key = std::move(merge_key);
}

History::Scope::Scope(History& history, std::string name, Form form) : Scope(history, std::move(name)) {
  if (history.depth_ == 1) history.open_.form = std::move(form.reason);
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
  const bool changes =
      step.form.empty() && std::any_of(step.inverses.begin(), step.inverses.end(), changes_scene);
  step.state = changes ? ++last_state_ : state();
  if (aftermath_ == After::step && !undo_.empty()) {
    std::vector<Edit>& into = undo_.back().inverses;
    into.insert(into.end(), std::make_move_iterator(step.inverses.begin()),
                std::make_move_iterator(step.inverses.end()));
    undo_.back().state = step.state;
    if (changes) undo_.back().form.clear();
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

// Plays back the last step of one list and hangs it onto the other.
void History::repeat(std::deque<Step>& from, std::deque<Step>& to) {
  assert(depth_ == 0);
  for (const Edit& edit : from.back().inverses)
    if (const std::string what = sleeping_part(edit); !what.empty())
      throw GraphError("'" + from.back().name + "' brings back " + what);
  ++steps_repeated_;
  Step step = std::move(from.back());
  from.pop_back();
  step.inverses = play_back(step.inverses, 0);
  can_merge_ = false;
  to.push_back(std::move(step));
}

std::string History::undo() {
  if (undo_.empty()) return "";
  repeat(undo_, redo_);
  return redo_.back().name;
}

std::string History::redo() {
  if (redo_.empty()) return "";
  repeat(redo_, undo_);
  return undo_.back().name;
}

bool History::take_back_form(const std::string& reason) {
  if (undo_.empty() || undo_.back().form != reason ||
      std::any_of(undo_.back().inverses.begin(), undo_.back().inverses.end(),
                  [](const Edit& edit) { return !sleeping_part(edit).empty(); }))
    return false;
  undo();
  redo_.clear();
  return true;
}

// Of one list, whose next step is at its end.
std::size_t History::forget(std::deque<Step>& steps, const std::function<bool(const Edit&)>& lost) {
  FootprintReader reader(graph_);
  Footprint forgotten;
  std::deque<Step> kept;
  std::uint64_t state = 0;  // number of what an undo now leads to, with what stays done
  for (std::size_t i = steps.size(); i-- > 0;) {
    Step& step = steps[i];
    const std::vector<NodeId> selection = reader.selection();
    const Footprint own = reader.read(step.inverses);
    const bool any_gone = kept.size() + i + 1 < steps.size();
    if (std::any_of(step.inverses.begin(), step.inverses.end(), lost) ||
        (any_gone && own.depends_on(forgotten))) {
      if (!any_gone) state = step.state;
      forgotten.add(own);
      continue;
    }
    if (any_gone) {
      // What was selected then, without what only the forgotten steps account for.
      step.inverses.push_back(SetSelection{selection});
      for (Edit& edit : step.inverses)
        if (auto* selected = std::get_if<SetSelection>(&edit))
          std::erase_if(selected->nodes, [&](NodeId id) { return forgotten.nodes.contains(id); });
      step.state = &steps == &undo_ ? std::exchange(state, ++last_state_) : ++last_state_;
    }
    kept.push_front(std::move(step));
  }
  const std::size_t count = steps.size() - kept.size();
  if (&steps == &undo_ && count > 0) first_state_ = state;
  steps = std::move(kept);
  return count;
}

std::size_t History::forget_steps_where(const std::function<bool(const Edit&)>& lost) {
  const std::size_t count = forget(undo_, lost) + forget(redo_, lost);
  if (count > 0) can_merge_ = false;
  return count;
}

void History::rewrite(const std::function<void(Edit&)>& rewrite_edit) {
  for (std::deque<Step>* steps : {&undo_, &redo_})
    for (Step& step : *steps)
      for (Edit& edit : step.inverses) rewrite_edit(edit);
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
