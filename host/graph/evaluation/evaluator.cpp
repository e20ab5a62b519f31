// The state of outputs: pushing dirt, pulling values, reporting errors. evaluator_requests.cpp holds the
// workers.
#include "host/graph/evaluation/evaluator.h"

#include <algorithm>
#include <utility>

namespace plinian::graph {

Evaluator::Evaluator(const Graph& graph) : Evaluator(graph, Options()) {}

Evaluator::Evaluator(const Graph& graph, const Options& options)
    : graph_(graph),
      cache_(options.cache_bytes),
      worker_count_(options.workers ? options.workers : std::max(1u, std::thread::hardware_concurrency())) {
  for (const Node* node : graph_.nodes()) add_states(node->id);
  graph_.add_observer(this);
}

Evaluator::~Evaluator() {
  graph_.remove_observer(this);
  for (const RequestPtr& request : in_flight_) request->cancelled = true;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

const Evaluator::OutputState* Evaluator::state(const Plug& output) const {
  if (output.node.value >= state_ranges_.size()) return nullptr;
  const StateRange& range = state_ranges_[output.node.value];
  if (!range.there) return nullptr;
  for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
    if (states_[i].attribute == output.attribute) return &states_[i];
  return nullptr;
}

Evaluator::OutputState* Evaluator::state(const Plug& output) {
  return const_cast<OutputState*>(static_cast<const Evaluator*>(this)->state(output));
}

std::span<Evaluator::OutputState> Evaluator::states_of(NodeId node) {
  const StateRange& range = state_ranges_[node.value];
  return std::span(states_).subspan(range.first, range.count);
}

void Evaluator::add_states(NodeId id) {
  const Node& node = *graph_.find(id);
  if (state_ranges_.size() <= id.value) state_ranges_.resize(id.value + 1);
  StateRange& range = state_ranges_[id.value];
  range.there = true;
  const auto outputs = node.schema->outputs();
  if (outputs.size() > range.count) {
    // A node of another type has come in its place, or of any: it moves to the end.
    const StateRange before = range;
    range.first = std::uint32_t(states_.size());
    states_.resize(states_.size() + outputs.size());
    for (std::uint32_t i = 0; i < before.count; ++i)
      states_[range.first + i].pending = states_[before.first + i].pending;
  }
  range.count = std::uint16_t(outputs.size());
  // A count of pending requests survives: they end some time.
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    OutputState& state = states_[range.first + i];
    state = {.attribute = outputs[i], .pending = state.pending, .dirtied_at = moment_};
  }
  if (node.type->spec().time_source)
    time_sources_.insert(id);
  else
    time_sources_.erase(id);
}

void Evaluator::edited(const Edit& edit) {
  ++moment_;
  if (const auto* add = std::get_if<AddNode>(&edit)) {
    add_states(add->node->id);
  } else if (const auto* replace = std::get_if<ReplaceNode>(&edit)) {
    push_outputs(*graph_.find(replace->node->id));
    add_states(replace->node->id);
  } else if (const auto* remove = std::get_if<RemoveNode>(&edit)) {
    time_sources_.erase(remove->node);
    for (auto failing = failing_.begin(); failing != failing_.end();)
      failing = failing->first.node == remove->node ? failing_.erase(failing) : std::next(failing);
    for (OutputState& state : states_of(remove->node))
      state = {.attribute = state.attribute, .pending = state.pending, .dirtied_at = moment_};
    state_ranges_[remove->node.value].there = false;
    for (const RequestPtr& request : in_flight_)
      if (const auto first = request->covered.lower_bound({remove->node});
          first != request->covered.end() && first->node == remove->node)
        request->cancelled = true;
  } else if (const auto* value = std::get_if<SetValue>(&edit)) {
    push_dirt(value->plug);
  } else if (const auto* input = std::get_if<SetInput>(&edit)) {
    push_dirt(input->destination.whole());
  }
}

void Evaluator::set_time(double frames) {
  if (frames == time_) return;
  time_ = frames;
  ++moment_;
  for (const NodeId id : time_sources_) push_outputs(*graph_.find(id));
}

void Evaluator::set_folder(const std::string& folder) {
  if (folder == folder_) return;
  folder_ = folder;
  forget();
}

void Evaluator::push_outputs(const Node& node) {
  for (const AttributeIndex output : node.schema->outputs()) push_dirt({node.id, output});
}

void Evaluator::push_dirt(const Plug& begin) {
  std::vector<Plug> stack = {begin};
  std::set<Plug> passed;  // inputs that drive others; each is passed once
  while (!stack.empty()) {
    const Plug plug = stack.back();
    stack.pop_back();
    const Node& node = *graph_.find(plug.node);
    const auto& outgoing = graph_.outgoing(plug.node);
    const auto first = outgoing.lower_bound({{plug.node, plug.attribute, plug.element, -1}, {}});
    const bool drives = first != outgoing.end() && first->source.whole() == plug;
    if (OutputState* output = state(plug)) {
      // What is dirty already has dirtied the rest, unless a worker is at it and must hear of this edit too.
      if (!output->clean && (output->pending == 0 || output->dirtied_at == moment_)) continue;
      dirtied_ += output->clean;
      output->clean = false;
      output->dirtied_at = moment_;
      if (output->pending > 0)
        for (const RequestPtr& request : in_flight_)
          if (request->covered.contains(plug)) request->cancelled = true;
    } else {
      for (const AttributeIndex affected : (*node.schema)[plug.attribute].affects)
        stack.push_back({plug.node, affected});
      if (drives && !passed.insert(plug).second) continue;
      // Somebody may be waiting for an input itself.
      for (const RequestPtr& request : in_flight_)
        if (std::find(request->plugs.begin(), request->plugs.end(), plug) != request->plugs.end())
          request->cancelled = true;
    }
    for (auto at = first; at != outgoing.end() && at->source.whole() == plug; ++at)
      stack.push_back(at->destination.whole());
  }
}

EvaluationServices Evaluator::services() {
  return {.cache = &cache_, .one_at_a_time = &one_at_a_time_, .folder = folder_};
}

// Of what is computed on the thread that asks for it.
EvaluationServices Evaluator::services_here() {
  EvaluationServices services = this->services();
  services.cancelled = interrupt_;
  services.progress = on_progress;
  return services;
}

ResultPtr Evaluator::evaluate(const Plug& plug) {
  const OutputState* ready = plug.component < 0 ? state(plug) : nullptr;
  if (ready && ready->clean && ready->result->has_value) return ready->result;
  EvaluationServices services = services_here();
  services.known = [this](const Plug& wanted) -> ResultPtr {
    const OutputState* known = state(wanted);
    return known && known->clean ? known->result : nullptr;
  };
  Evaluation evaluation(graph_.snapshot(), time_, services);
  const ResultPtr result = evaluation.evaluate(plug);
  for (const auto& [output, found] : evaluation.results()) accept(output, found, evaluation.warnings());
  count(evaluation.counters());
  tell_undeclared(evaluation.undeclared_reads());
  return result;
}

ResultPtr Evaluator::evaluate_at(double frames, const Plug& plug) {
  if (frames == time_) return evaluate(plug);
  EvaluationServices services = services_here();
  services.known = [this](const Plug& wanted) -> ResultPtr {
    const OutputState* known = state(wanted);
    return known && known->clean && !known->result->time_dependent ? known->result : nullptr;
  };
  Evaluation evaluation(graph_.snapshot(), frames, services);
  const ResultPtr result = evaluation.evaluate(plug);
  count(evaluation.counters());
  return result;
}

// Makes a result the state of an output, and tells of a failure that is new.
void Evaluator::accept(const Plug& output, const ResultPtr& result,
                       const std::map<Plug, std::string>& warnings) {
  OutputState* state = result ? this->state(output) : nullptr;
  if (!state) return;  // an input that is passed on
  if (state->clean && state->result == result) return;
  state->result = result;
  state->clean = true;
  if (!result->error) {
    state->last_good = result;
    failing_.erase(output);
    if (warnings.empty() && warned_.empty()) return;
    const auto warning = warnings.find(output);
    if (warning == warnings.end())
      warned_.erase(output);
    else if (std::exchange(warned_[output], warning->second) != warning->second && on_warning)
      on_warning(graph_.name_of(output) + ": " + warning->second);
    return;
  }
  if (result->error->origin != output) {
    failing_.erase(output);
    // An input may be the cause as well, where its value could not be converted.
    if (this->state(result->error->origin)) return;
  }
  const Plug cause = result->error->origin;
  std::string& reported = failing_[cause];
  if (reported == result->error->message) return;
  reported = result->error->message;
  reports_.push_back(graph_.name_of(cause) + ": " + reported);
}

// Once for a type, whichever of its nodes it was seen in.
void Evaluator::tell_undeclared(const std::map<Plug, std::set<Plug>>& reads) {
  for (const auto& [output, inputs] : reads) {
    const Node* node = graph_.find(output.node);
    if (!node || output.attribute >= node->schema->size()) continue;
    const std::string computed = (*node->schema)[output.attribute].path;
    for (const Plug& input : inputs) {
      const std::string& read = (*node->schema)[input.attribute].path;
      if (undeclared_told_.insert(node->type->name() + "." + computed + " " + read).second && on_warning)
        on_warning(node->name + "." + computed + ": its computation reads '" + read +
                   "', which is not declared to affect it: a change of it goes unseen");
    }
  }
}

void Evaluator::count(const EvaluationCounters& counters) {
  counters_.computes += counters.computes;
  counters_.cache_hits += counters.cache_hits;
  counters_.blocked += counters.blocked;
  for (const auto& [type, number] : counters.computes_of_type) counters_.computes_of_type[type] += number;
}

bool Evaluator::is_dirty(const Plug& output) const {
  const OutputState* known = state(output);
  return !known || !known->clean;
}

ResultPtr Evaluator::known(const Plug& output) const {
  const OutputState* known = state(output);
  return known && known->clean ? known->result : nullptr;
}

ResultPtr Evaluator::last_good(const Plug& output) const {
  const OutputState* known = state(output);
  return known ? known->last_good : nullptr;
}

std::string Evaluator::error_text(const Plug& plug, const Result& result) const {
  if (!result.error) return "";
  if (result.error->origin == plug.whole()) return result.error->message;
  const std::string cause = graph_.name_of(result.error->origin);
  return "blocked by " + (cause.empty() ? "a deleted node" : cause) + ": " + result.error->message;
}

std::vector<std::string> Evaluator::take_reports() {
  return std::exchange(reports_, {});
}

void Evaluator::forget() {
  cache_.clear();
  cancel_all();
  undeclared_told_.clear();
  ++moment_;
  for (OutputState& state : states_)
    state = {.attribute = state.attribute, .pending = state.pending, .dirtied_at = moment_};
}

std::vector<std::string> Evaluator::check(const Plug& plug) {
  evaluate(plug);
  EvaluationServices services = services_here();
  services.cache = nullptr;
  Evaluation anew(graph_.snapshot(), time_, services);
  anew.evaluate(plug);
  const auto differs = [&](const Plug& output, const ResultPtr& fresh) {
    const OutputState* known = state(output);
    if (!known || !known->clean || !known->result->has_value || !fresh->has_value) return false;
    const auto* data = std::get_if<DataPtr>(&fresh->value);
    const bool comparable = !data || !*data || (*data)->content != 0;
    return comparable && known->result->identity != fresh->identity;
  };
  std::set<Plug> wrong;
  for (const auto& [output, fresh] : anew.results())
    if (fresh && differs(output, fresh)) wrong.insert(output);
  std::set<Plug> suspects = wrong;
  for (const auto& [output, reads] : anew.undeclared_reads()) suspects.insert(output);
  std::vector<std::string> lines;
  for (const Plug& output : suspects) {
    const Node& node = *graph_.find(output.node);
    const auto reads = anew.undeclared_reads().find(output);
    const bool undeclared = reads != anew.undeclared_reads().end();
    // Where something upstream differs, that is to blame.
    const bool passed_on = std::any_of(node.inputs.begin(), node.inputs.end(), [&](const Input& input) {
      return wrong.contains(input.source.whole());
    });
    if (!undeclared && passed_on) continue;
    std::string line = graph_.name_of(output) + (wrong.contains(output) ? ": computed anew it differs" : ":");
    if (wrong.contains(output) && undeclared) line += ";";
    if (undeclared)
      for (const Plug& read : reads->second)
        line += " its computation reads '" + (*node.schema)[read.attribute].path +
                "', which is not declared to affect it";
    else
      line += " although no input did: its computation depends on something else";
    lines.push_back(line);
  }
  return lines;
}

}  // namespace plinian::graph
