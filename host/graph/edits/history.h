// The one door through which a graph changes, and the undo that comes of it.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "host/graph/edits/edit.h"

namespace plinian::graph {

class Graph;

class History {
 public:
  explicit History(Graph& graph) : graph_(graph) {}
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  /// Everything performed while a scope is open is one step of undo; scopes nest, and the outermost names the
  /// step. A scope that an exception leaves takes back what was done in it.
  class Scope {
   public:
    /// merge_key: where it is not empty and the last step has the same one, both become one step; the edits
    /// of a drag share a key.
    explicit Scope(History& history, std::string name, std::string merge_key = "");
    /// The step says the same scene in another form: what becomes of nodes when the plug-in comes or goes.
    /// It leaves it at that whether the scene was modified.
    struct Form {
      std::string reason;
    };
    Scope(History& history, std::string name, Form form);
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope();
    /// Takes back what was done since the scope was opened.
    void roll_back();

   private:
    History& history_;
    std::size_t begin_;  // edits done before
    int exceptions_;     // in flight when it was opened
  };

  /// While it lives, those who are told of the last step may add to it: what they perform is undone and
  /// redone with it. Those who are told of an undo or a redo may not: the steps bring all edits with them,
  /// and perform() throws GraphError.
  class Aftermath {
   public:
    Aftermath(History& history, bool of_undo) : history_(history) {
      history_.aftermath_ = of_undo ? After::undo : After::step;
    }
    Aftermath(const Aftermath&) = delete;
    Aftermath& operator=(const Aftermath&) = delete;
    ~Aftermath() { history_.aftermath_ = After::nothing; }

   private:
    History& history_;
  };
  /// Counts steps that were made, and undos and redos.
  std::uint64_t steps_made() const { return steps_made_; }
  std::uint64_t steps_repeated() const { return steps_repeated_; }

  /// Applies an edit and records how to undo it.
  void perform(const Edit& edit);

  /// Takes back the last step, or does it again. Returns its name; empty where there is none. Throws
  /// GraphError, and leaves it, where the step holds what is of a plug-in that is not loaded. Not within a
  /// scope.
  std::string undo();
  std::string redo();
  /// What undo and redo would take, oldest first and next first.
  std::vector<std::string> undo_names() const;
  std::vector<std::string> redo_names() const;
  /// Whether a scope is open: in the middle of what will be one step.
  bool is_open() const { return depth_ > 0; }
  /// Ends a drag: the next step stands alone, whatever its merge key.
  void end_merge() { can_merge_ = false; }
  /// Forgets all steps, as a new scene does.
  void clear();
  /// ... and leaves it at that whether the scene was modified.
  void forget_steps();
  /// Forgets the steps that have such an edit, and of those that are reached through them the ones that
  /// depend on them: that touch the same nodes, names or connections. What the forgotten ones did stays done;
  /// all others can be undone and done again as before. Returns how many.
  std::size_t forget_steps_where(const std::function<bool(const Edit&)>& lost);
  /// Where the last step is such a change of form for that reason, takes it back for good.
  bool take_back_form(const std::string& reason);
  /// Shows every edit that steps hold to who may put another in its place that means the same.
  void rewrite(const std::function<void(Edit&)>& rewrite_edit);

  /// Whether the scene differs from what it was when it was marked as saved.
  bool is_modified() const { return state() != saved_state_; }
  void mark_saved() { saved_state_ = state(); }
  /// ... or that it differs from whatever was saved.
  void mark_modified() { saved_state_ = ~std::uint64_t(0); }

 private:
  struct Step {
    std::string name, merge_key;
    std::string form;            // not empty: it changes how the scene is held, not what it says
    std::vector<Edit> inverses;  // in the order in which they were done
    std::uint64_t state = 0;     // number of the state of the scene that the step leads to
  };
  std::uint64_t state() const { return undo_.empty() ? first_state_ : undo_.back().state; }
  void commit();
  std::size_t forget(std::deque<Step>& steps, const std::function<bool(const Edit&)>& lost);
  void repeat(std::deque<Step>& from, std::deque<Step>& to);
  std::vector<Edit> play_back(std::vector<Edit>& inverses, std::size_t begin);

  Graph& graph_;
  std::deque<Step> undo_, redo_;
  Step open_;
  enum class After { nothing, step, undo };
  After aftermath_ = After::nothing;
  std::uint64_t steps_made_ = 0, steps_repeated_ = 0;
  int depth_ = 0;
  bool can_merge_ = false;
  std::uint64_t last_state_ = 0, first_state_ = 0, saved_state_ = 0;
};

}  // namespace plinian::graph
