// Computes plugs of one snapshot at one time: pulls what they depend on, and nothing else.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "host/graph/evaluation/result.h"
#include "host/graph/evaluation/value_cache.h"
#include "host/graph/model/graph.h"

namespace plinian::graph {

/// What evaluations did, for tests and for the curious.
struct EvaluationCounters {
  std::uint64_t computes = 0;    // runs of compute functions
  std::uint64_t cache_hits = 0;  // results that were found instead
  std::uint64_t blocked = 0;     // outputs that were not computed because something upstream had failed
  std::map<std::string, std::uint64_t> computes_of_type;
};

/// Thrown out of an evaluation whose cancellation was asked for.
struct EvaluationCancelled {};

/// What all evaluations share.
struct EvaluationServices {
  ValueCache* cache = nullptr;                    // null: none
  std::recursive_mutex* one_at_a_time = nullptr;  // held by types that may not run concurrently
  const std::atomic<bool>* cancelled = nullptr;
  std::atomic<NodeId>* at_work = nullptr;  // told which node's computation runs; none: {}
  std::function<void(const Plug&, double fraction, std::string_view what)> progress;
  std::string folder;  // that relative paths are relative to, as compute functions read them
  /// A result that is known beforehand, or null.
  std::function<ResultPtr(const Plug&)> known;
};

class Evaluation {
 public:
  Evaluation(GraphSnapshotPtr snapshot, double time, EvaluationServices services);
  ~Evaluation();

  /// The value of a plug (not of a compound). Does not recurse, however long the chain. Throws
  /// EvaluationCancelled; what else fails becomes the error of the result.
  ResultPtr evaluate(const Plug& plug);

  /// What was looked at, with its result; null for what was not needed in the end.
  const FlatMap<Plug, ResultPtr>& results() const { return results_; }
  const EvaluationCounters& counters() const { return counters_; }
  /// Inputs that computations read although they do not affect the output, as "node.out reads node.seed".
  const std::map<Plug, std::set<Plug>>& undeclared_reads() const { return undeclared_reads_; }
  /// What computations had to say of their results, now or when these were computed.
  const std::map<Plug, std::string>& warnings() const { return warnings_; }

 private:
  class Context;

  const Result* find(const Plug& plug, bool need_value);
  bool advance(const Plug& plug, bool need_value, std::vector<std::pair<Plug, bool>>& stack);
  void sources_of(const Node& node, const Plug& plug, std::vector<Plug>& sources) const;
  ResultPtr pass_on(const Node& node, const Plug& plug);
  Hash key_of(const Node& node, const Plug& output, bool& time_dependent);
  void add_input_identity(Hasher& hasher, const Node& node, AttributeIndex attribute, std::int32_t element);
  bool reads_hold(const Node& node, const std::vector<OtherTimeRead>& reads);
  ResultPtr compute(const Node& node, const Plug& output, Hash key, bool time_dependent);
  Value gathered(const Node& node, AttributeIndex attribute, std::int32_t element);
  ResultPtr evaluate_at(double time, const Plug& plug);
  void store(const Plug& plug, ResultPtr result) { results_[plug] = std::move(result); }
  void check_cancelled() const;

  GraphSnapshotPtr snapshot_;
  double time_;  // [frames]
  EvaluationServices services_;
  FlatMap<Plug, ResultPtr> results_;
  std::map<double, std::unique_ptr<Evaluation>> other_times_;
  std::map<Plug, std::set<Plug>> undeclared_reads_;
  std::map<Plug, std::string> warnings_;
  std::unordered_map<const NodeType*, std::uint64_t> computes_;
  EvaluationCounters counters_;
};

}  // namespace plinian::graph
