// Keeps the results of a living graph: knows what is dirty, evaluates here or on workers, and remembers.
//
// Dirtiness is pushed along `affects` and connections when something is edited, which runs no code of node
// types; values are pulled when somebody asks. Everything here is called on the thread that edits the graph.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <set>
#include <span>
#include <thread>

#include "host/graph/evaluation/evaluation.h"

namespace plinian::graph {

class Evaluator : private GraphObserver {
 public:
  struct Options {
    std::size_t cache_bytes = std::size_t(2) << 30;  // of remembered values
    unsigned workers = 0;                            // 0: one for each processor
  };
  explicit Evaluator(const Graph& graph);
  Evaluator(const Graph& graph, const Options& options);
  ~Evaluator() override;
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// The current time [frames]: an input like any other, whose change is no edit.
  double time() const { return time_; }
  void set_time(double frames);

  /// The folder that relative paths are relative to; a change of it makes everything dirty.
  void set_folder(const std::string& folder);

  /// A flag that stops what is computed here and now, as from a signal's handler; null: none. It must outlive
  /// the evaluator.
  void set_interrupt(const std::atomic<bool>* interrupt) { interrupt_ = interrupt; }
  bool is_interrupted() const { return interrupt_ && interrupt_->load(std::memory_order_relaxed); }

  /// The value of a plug, computed now where it is dirty. Throws EvaluationCancelled after an interrupt.
  ResultPtr evaluate(const Plug& plug);
  /// As at another time; nothing of it becomes the current state.
  ResultPtr evaluate_at(double frames, const Plug& plug);
  /// Hears how far what evaluate() computes has come.
  std::function<void(const Plug&, double fraction, std::string_view what)> on_progress;

  /// What a request came to. results: of the plugs, in order; empty where it was cancelled.
  struct Outcome {
    bool cancelled = false;
    std::vector<ResultPtr> results;
  };
  using RequestId = std::uint64_t;
  /// Evaluates plugs on a worker, from a snapshot of this moment. An edit that changes any of them cancels
  /// the request without waiting for it. `done` is called by poll.
  RequestId request(std::vector<Plug> plugs, std::function<void(const Outcome&)> done);
  void cancel(RequestId id);
  void cancel_all();
  /// Takes over what workers have finished; results that an edit has overtaken are dropped. Returns how many
  /// requests ended.
  std::size_t poll();
  /// Polls until no request is in flight.
  void finish();
  /// The same, for so long at most: false where it was not enough.
  bool finish_within(std::chrono::milliseconds limit);
  /// The node that a request in flight computed last, for one that does not end; null: none.
  const Node* at_work() const;

  struct Progress {
    Plug plug;
    double fraction = 0.0;  // [0, 1]
    std::string what;
  };
  /// What running requests said last.
  std::vector<Progress> progress() const;

  /// Whether an output would have to be computed or found again.
  bool is_dirty(const Plug& output) const;
  /// The result of an output as it is known, which may lack its value; null where it is dirty. Computes
  /// nothing.
  ResultPtr known(const Plug& output) const;
  /// The last result of an output that was no error, however old, or null: the last good picture.
  ResultPtr last_good(const Plug& output) const;
  /// "computed nothing", or "blocked by noise1.out: ...": the error as it reads at a plug; empty where there
  /// is none.
  std::string error_text(const Plug& plug, const Result& result) const;

  /// Hears what computations have to say of their results, and of inputs that they read although these are
  /// not declared to affect what is computed: one line each, and not again before it changes.
  std::function<void(const std::string& line)> on_warning;

  /// Failures since the last call, one line for each cause, however much is blocked by it.
  std::vector<std::string> take_reports();

  /// Computes everything upstream of a plug anew and compares it with what is remembered. Each line names an
  /// output whose node type declares a wrong `affects`, or that does not depend on its inputs alone.
  std::vector<std::string> check(const Plug& plug);

  const EvaluationCounters& counters() const { return counters_; }
  std::uint64_t dirtied() const { return dirtied_; }  // outputs, ever
  ValueCache& cache() { return cache_; }
  /// Forgets all results, as when a node type goes, or is replaced by another of the same name and version.
  void forget();

 private:
  struct OutputState {
    AttributeIndex attribute = no_attribute;
    std::uint32_t pending = 0;     // requests that are computing it
    std::uint64_t dirtied_at = 0;  // moment
    ResultPtr result, last_good;
    bool clean = false;
  };
  // Where the states of a node's outputs are among all.
  struct StateRange {
    std::uint32_t first = 0;
    std::uint16_t count = 0;
    bool there = false;  // the node exists
  };
  struct Request {
    RequestId id = 0;
    std::vector<Plug> plugs;
    std::function<void(const Outcome&)> done;
    GraphSnapshotPtr snapshot;
    double time = 0.0;
    std::uint64_t moment = 0;
    std::unordered_map<Plug, ResultPtr> known;  // clean outputs at its edge
    std::set<Plug> covered;                     // dirty outputs that it may compute
    std::atomic<bool> cancelled{false};
    std::atomic<NodeId> at_work{};
    mutable std::mutex progress_mutex;
    Progress progress;
    // Filled in by the worker.
    std::vector<ResultPtr> results;
    FlatMap<Plug, ResultPtr> computed;
    EvaluationCounters counters;
    std::map<Plug, std::set<Plug>> undeclared_reads;
    std::map<Plug, std::string> warnings;
  };
  using RequestPtr = std::shared_ptr<Request>;

  void edited(const Edit& edit) override;
  OutputState* state(const Plug& output);
  const OutputState* state(const Plug& output) const;
  std::span<OutputState> states_of(NodeId node);
  void add_states(NodeId node);
  void push_dirt(const Plug& plug);
  void push_outputs(const Node& node);
  void accept(const Plug& output, const ResultPtr& result, const std::map<Plug, std::string>& warnings);
  void count(const EvaluationCounters& counters);
  void tell_undeclared(const std::map<Plug, std::set<Plug>>& reads);
  EvaluationServices services();
  EvaluationServices services_here();
  void cover(Request& request);
  void end(const RequestPtr& request);
  void work();

  const Graph& graph_;
  double time_ = 1.0;
  const std::atomic<bool>* interrupt_ = nullptr;
  std::string folder_;
  ValueCache cache_;
  std::vector<OutputState> states_;       // of a node one after the other: what is dirtied lies together
  std::vector<StateRange> state_ranges_;  // by node
  std::set<NodeId> time_sources_;
  std::uint64_t moment_ = 1;  // counts edits and changes of time
  std::map<Plug, std::string> failing_, warned_;
  std::set<std::string> undeclared_told_;  // "type.output attribute"
  std::vector<std::string> reports_;
  EvaluationCounters counters_;
  std::uint64_t dirtied_ = 0;
  std::recursive_mutex one_at_a_time_;

  std::vector<RequestPtr> in_flight_;
  RequestId last_request_ = 0;
  std::mutex mutex_;  // guards what follows
  std::condition_variable wake_, finished_;
  std::deque<RequestPtr> waiting_, done_;
  bool stopping_ = false;
  unsigned worker_count_;
  std::vector<std::thread> workers_;  // started with the first request
};

}  // namespace plinian::graph
