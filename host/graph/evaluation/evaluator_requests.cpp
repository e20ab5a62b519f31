// Evaluation on workers, from snapshots.
#include <algorithm>

#include "host/graph/evaluation/evaluator.h"

namespace plinian::graph {

// Notes what the request may compute, and what it can take as known: the clean outputs at the edge of the
// dirt.
void Evaluator::cover(Request& request) {
  std::vector<Plug> stack;
  for (const Plug& plug : request.plugs) stack.push_back(plug.whole());
  std::set<Plug> passed;
  while (!stack.empty()) {
    const Plug plug = stack.back();
    stack.pop_back();
    const Node* node = graph_.find(plug.node);
    if (!node) continue;
    OutputState* output = state(plug);
    if (!output) {
      if (passed.insert(plug).second)
        for (const Input& input : node->inputs_of(plug.attribute, plug.element))
          stack.push_back(input.source.whole());
      continue;
    }
    if (output->clean) {
      request.known.emplace(plug, output->result);
      if (output->result->has_value || output->result->error) continue;
    }
    if (!request.covered.insert(plug).second) continue;
    ++output->pending;
    for (const Input& input : node->inputs) {
      const auto& affects = (*node->schema)[input.attribute].affects;
      if (std::find(affects.begin(), affects.end(), plug.attribute) != affects.end())
        stack.push_back(input.source.whole());
    }
  }
}

Evaluator::RequestId Evaluator::request(std::vector<Plug> plugs, std::function<void(const Outcome&)> done) {
  const auto request = std::make_shared<Request>();
  request->id = ++last_request_;
  request->plugs = std::move(plugs);
  request->done = std::move(done);
  request->snapshot = graph_.snapshot();
  request->time = time_;
  request->moment = moment_;
  cover(*request);
  in_flight_.push_back(request);
  while (workers_.size() < worker_count_) workers_.emplace_back([this] { work(); });
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(request);
  }
  wake_.notify_one();
  return request->id;
}

void Evaluator::cancel(RequestId id) {
  for (const RequestPtr& request : in_flight_)
    if (request->id == id) request->cancelled = true;
}

void Evaluator::cancel_all() {
  for (const RequestPtr& request : in_flight_) request->cancelled = true;
}

void Evaluator::work() {
  while (true) {
    RequestPtr request;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
      if (stopping_) return;
      request = std::move(waiting_.front());
      waiting_.pop_front();
    }
    EvaluationServices services = this->services();
    services.cancelled = &request->cancelled;
    services.at_work = &request->at_work;
    services.known = [&](const Plug& plug) -> ResultPtr {
      const auto found = request->known.find(plug);
      return found == request->known.end() ? nullptr : found->second;
    };
    services.progress = [&](const Plug& plug, double fraction, std::string_view what) {
      const std::lock_guard lock(request->progress_mutex);
      request->progress = {plug, fraction, std::string(what)};
    };
    Evaluation evaluation(request->snapshot, request->time, services);
    std::vector<ResultPtr> results;
    try {
      for (const Plug& plug : request->plugs) results.push_back(evaluation.evaluate(plug));
    } catch (const EvaluationCancelled&) {
      results.clear();
    }
    request->results = std::move(results);
    request->computed = evaluation.results();
    request->counters = evaluation.counters();
    request->undeclared_reads = evaluation.undeclared_reads();
    request->warnings = evaluation.warnings();
    {
      const std::lock_guard lock(mutex_);
      done_.push_back(std::move(request));
    }
    finished_.notify_all();
  }
}

// Takes over what still holds, and lets go of the rest.
void Evaluator::end(const RequestPtr& request) {
  std::erase(in_flight_, request);
  for (const auto& [plug, result] : request->computed) {
    const OutputState* output = state(plug);
    if (!output || output->dirtied_at > request->moment) continue;
    // Also one that was known, but whose value had left the cache: it may not come back.
    const bool is_known = output->clean && (output->result->has_value || output->result->error);
    if (!is_known) accept(plug, result, request->warnings);
  }
  for (const Plug& plug : request->covered)
    if (plug.node.value < state_ranges_.size())
      if (OutputState* output = state(plug); output && output->pending > 0) --output->pending;
  count(request->counters);
  tell_undeclared(request->undeclared_reads);
  Outcome outcome;
  outcome.cancelled = request->cancelled;
  if (!outcome.cancelled) outcome.results = request->results;
  if (request->done) request->done(outcome);
}

std::size_t Evaluator::poll() {
  std::deque<RequestPtr> ended;
  {
    const std::lock_guard lock(mutex_);
    ended.swap(done_);
  }
  for (const RequestPtr& request : ended) end(request);
  return ended.size();
}

void Evaluator::finish() {
  while (!in_flight_.empty()) {
    {
      std::unique_lock lock(mutex_);
      finished_.wait(lock, [this] { return !done_.empty(); });
    }
    poll();
  }
}

bool Evaluator::finish_within(std::chrono::milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!in_flight_.empty()) {
    {
      std::unique_lock lock(mutex_);
      if (!finished_.wait_until(lock, end, [this] { return !done_.empty(); })) return false;
    }
    poll();
  }
  return true;
}

const Node* Evaluator::at_work() const {
  for (const RequestPtr& request : in_flight_)
    if (const Node* node = graph_.find(request->at_work)) return node;
  return nullptr;
}

std::vector<Evaluator::Progress> Evaluator::progress() const {
  std::vector<Progress> result;
  for (const RequestPtr& request : in_flight_) {
    const std::lock_guard lock(request->progress_mutex);
    if (request->progress.plug.node) result.push_back(request->progress);
  }
  return result;
}

}  // namespace plinian::graph
