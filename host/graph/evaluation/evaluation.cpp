// Evaluation by an explicit stack. Results are found by a key: the hash of the node's type and of the
// identities of all inputs that affect the output.
#include "host/graph/evaluation/evaluation.h"

#include <algorithm>
#include <forward_list>

#include "host/graph/evaluation/compute_context.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/graph/values/file_path.h"

namespace plinian::graph {

namespace {

// The identity of a value that `key` led to.
Hash identity_of(const Value& value, Hash key) {
  if (const auto* data = std::get_if<DataPtr>(&value); data && *data && (*data)->content == 0) return key;
  Hasher hasher;
  add_to_hash(hasher, value);
  return hasher.result();
}

bool affects(const Node& node, AttributeIndex attribute, AttributeIndex output) {
  const auto& outputs = (*node.schema)[attribute].affects;
  return std::find(outputs.begin(), outputs.end(), output) != outputs.end();
}

}  // namespace

// What a compute function sees: the inputs of one node at one time.
class Evaluation::Context : public ComputeContext {
 public:
  Context(Evaluation& evaluation, const Node& node, const Plug& output)
      : evaluation_(evaluation), node_(node), output_(output) {}

  const Value& input(AttributeIndex attribute, std::int32_t element) override {
    const Value& value = plain_input(attribute, element);
    return is_relative(attribute, value) ? converted_.emplace_front(expanded(value)) : value;
  }
  std::vector<std::int32_t> elements(AttributeIndex array) override {
    note_read(array, -1);
    return node_.elements(array);
  }
  Value input_at(double time, AttributeIndex attribute, std::int32_t element) override {
    note_read(attribute, element);
    const ResultPtr result = evaluation_.evaluate_at(time, {node_.id, attribute, element, -1});
    reads_.push_back({time, attribute, element, result->identity});
    require(result);
    return is_relative(attribute, result->value) ? expanded(result->value) : result->value;
  }
  void set_output(AttributeIndex attribute, Value value) override {
    need_attribute(attribute, "writes");
    const SchemaAttribute& declared = (*node_.schema)[attribute];
    if (!declared.spec.output) throw GraphError("writes '" + declared.path + "', which is no output");
    Value fit = fitted(declared.spec, value);
    for (auto& [written, old] : outputs_)
      if (written == attribute) {
        old = std::move(fit);
        return;
      }
    outputs_.emplace_back(attribute, std::move(fit));
  }
  bool cancelled() const override {
    return evaluation_.services_.cancelled &&
           evaluation_.services_.cancelled->load(std::memory_order_relaxed);
  }
  void progress(double fraction, std::string_view what) override {
    if (evaluation_.services_.progress) evaluation_.services_.progress(output_, fraction, what);
  }
  void warn(const std::string& line) override { warning_ += (warning_.empty() ? "" : "; ") + line; }
  double time() const override {
    if (!node_.type->spec().time_source) throw GraphError("asks for the time without being a time source");
    return evaluation_.time_;
  }
  const std::string& node_name() const override { return node_.name; }

  bool wrote(AttributeIndex attribute) const {
    return std::any_of(outputs_.begin(), outputs_.end(),
                       [&](const auto& pair) { return pair.first == attribute; });
  }

  std::vector<std::pair<AttributeIndex, Value>> outputs_;
  std::vector<OtherTimeRead> reads_;
  std::string warning_;

 private:
  // A plug-in counts its attributes itself.
  void need_attribute(AttributeIndex attribute, const char* what) const {
    if (attribute < 0 || attribute >= node_.schema->size())
      throw GraphError(what + (" attribute number " + std::to_string(attribute)) + ", which " +
                       node_.type->name() + " does not have: was it added?");
  }
  // Returns whether the input affects the output, itself or by what is in it.
  bool note_read(AttributeIndex attribute, std::int32_t element) {
    need_attribute(attribute, "reads");
    if (affects(node_, attribute, output_.attribute)) return true;
    if (!(*node_.schema)[attribute].children.empty())
      for (const AttributeIndex leaf : node_.schema->leaves(attribute))
        if (affects(node_, leaf, output_.attribute)) return true;
    evaluation_.undeclared_reads_[output_].insert({node_.id, attribute, element});
    return false;
  }
  const Value& plain_input(AttributeIndex attribute, std::int32_t element) {
    if (!note_read(attribute, element)) {
      // Not pulled beforehand, as the others were.
      for (const Input& input : node_.inputs_of(attribute, element))
        require(evaluation_.evaluate(input.source.whole()));
    }
    const auto inputs = node_.inputs_of(attribute, element);
    if (inputs.empty()) return node_.value(attribute, element);
    if (inputs.size() == 1 && inputs[0].component < 0 && inputs[0].source.component < 0) {
      // The value itself, where it needs no conversion.
      const Value& value = evaluation_.results_.at(inputs[0].source.whole())->value;
      const AttributeSpec& spec = (*node_.schema)[attribute].spec;
      if (value.index() == spec.default_value.index() && !spec.minimum && !spec.maximum &&
          spec.type != AttributeType::choice)
        return value;
    }
    return converted_.emplace_front(evaluation_.gathered(node_, attribute, element));
  }

  // A path as it was typed means nothing to whoever opens files.
  bool is_relative(AttributeIndex attribute, const Value& value) const {
    return (*node_.schema)[attribute].spec.type == AttributeType::path &&
           std::holds_alternative<std::string>(value) && !std::get<std::string>(value).empty();
  }
  Value expanded(const Value& value) const {
    return expand_path(std::get<std::string>(value), evaluation_.services_.folder);
  }

  // An input read beyond those declared may have failed; so does what reads it.
  static void require(const ResultPtr& result) {
    if (result->error) throw GraphError("an input failed: " + result->error->message);
  }

  Evaluation& evaluation_;
  const Node& node_;
  const Plug output_;
  std::forward_list<Value> converted_;  // stay where they are
};

Evaluation::Evaluation(GraphSnapshotPtr snapshot, double time, EvaluationServices services)
    : snapshot_(std::move(snapshot)), time_(time), services_(std::move(services)) {}

Evaluation::~Evaluation() = default;

void Evaluation::check_cancelled() const {
  if (services_.cancelled && services_.cancelled->load(std::memory_order_relaxed))
    throw EvaluationCancelled();
}

ResultPtr Evaluation::evaluate(const Plug& wanted) {
  const Plug plug = wanted.whole();
  std::vector<std::pair<Plug, bool>> stack = {{plug, true}};
  while (!stack.empty()) {
    const auto [next, need_value] = stack.back();
    if (advance(next, need_value, stack)) stack.pop_back();
  }
  for (const auto& [type, count] : computes_) counters_.computes_of_type[type->name()] += count;
  computes_.clear();
  const ResultPtr result = results_.at(plug);
  if (wanted.component < 0 || result->error) return result;
  Result part = *result;
  part.value = component_of(part.value, wanted.component);
  part.identity = identity_of(part.value, {});
  return std::make_shared<const Result>(std::move(part));
}

// A result that will do, from here or from before. What was looked for in vain is noted by an empty result.
const Result* Evaluation::find(const Plug& plug, bool need_value) {
  const auto [place, fresh] = results_.emplace(plug);
  if (fresh && services_.known) *place = services_.known(plug);
  const Result* result = place->get();
  return result && (result->has_value || result->error || !need_value) ? result : nullptr;
}

void Evaluation::sources_of(const Node& node, const Plug& plug, std::vector<Plug>& sources) const {
  const SchemaAttribute& attribute = (*node.schema)[plug.attribute];
  if (!attribute.spec.output) {
    for (const Input& input : node.inputs_of(plug.attribute, plug.element))
      sources.push_back(input.source.whole());
    return;
  }
  for (const Input& input : node.inputs)
    if (affects(node, input.attribute, plug.attribute)) sources.push_back(input.source.whole());
}

// Takes one plug as far as it goes now; false where it has put others on the stack that must come first.
bool Evaluation::advance(const Plug& plug, bool need_value, std::vector<std::pair<Plug, bool>>& stack) {
  if (find(plug, need_value)) return true;
  check_cancelled();
  const Node* node = snapshot_->find(plug.node);
  if (!node) {
    store(plug, std::make_shared<const Result>(Result{.has_value = false,
                                                      .error = std::make_shared<const ComputeError>(
                                                          ComputeError{plug, "the node does not exist"})}));
    return true;
  }
  const bool output = (*node->schema)[plug.attribute].spec.output;
  std::vector<Plug> sources;
  sources_of(*node, plug, sources);
  const auto push_missing = [&](bool with_value) {
    const std::size_t before = stack.size();
    for (const Plug& source : sources)
      if (!find(source, with_value)) stack.emplace_back(source, with_value);
    return stack.size() > before;
  };
  if (push_missing(!output)) return false;
  for (const Plug& source : sources) {
    const ResultPtr& result = results_.at(source);
    if (!result->error) continue;
    counters_.blocked += output;
    store(plug, std::make_shared<const Result>(Result{
                    .has_value = false, .time_dependent = result->time_dependent, .error = result->error}));
    return true;
  }
  if (!output) {
    store(plug, pass_on(*node, plug));
    return true;
  }
  bool time_dependent = false;
  const Hash key = key_of(*node, plug, time_dependent);
  if (services_.cache) {
    const auto entry = services_.cache->find(key);
    if (entry && (entry->result->has_value || !need_value) && reads_hold(*node, entry->reads)) {
      ++counters_.cache_hits;
      if (!entry->warning.empty()) warnings_[plug] = entry->warning;
      store(plug, entry->result);
      return true;
    }
  }
  if (push_missing(true)) return false;
  store(plug, compute(*node, plug, key, time_dependent));
  return true;
}

// An input: what is set there, or what drives it.
ResultPtr Evaluation::pass_on(const Node& node, const Plug& plug) {
  Result result;
  Hasher hasher;
  add_input_identity(hasher, node, plug.attribute, plug.element);
  for (const Input& input : node.inputs_of(plug.attribute, plug.element))
    result.time_dependent |= results_.at(input.source.whole())->time_dependent;
  try {
    result.value = gathered(node, plug.attribute, plug.element);
    result.identity = identity_of(result.value, hasher.result());
  } catch (const GraphError& error) {
    result.has_value = false;
    result.error = std::make_shared<const ComputeError>(ComputeError{plug, error.what()});
  }
  return std::make_shared<const Result>(std::move(result));
}

void Evaluation::add_input_identity(Hasher& hasher, const Node& node, AttributeIndex attribute,
                                    std::int32_t element) {
  const auto inputs = node.inputs_of(attribute, element);
  // The value beneath shows through where components are driven.
  if (inputs.empty() || inputs[0].component >= 0) add_to_hash(hasher, node.value(attribute, element));
  for (const Input& input : inputs) {
    hasher.add(std::uint64_t(std::uint32_t(input.component)) << 32 | std::uint32_t(input.source.component));
    hasher.add(results_.at(input.source.whole())->identity);
  }
}

Hash Evaluation::key_of(const Node& node, const Plug& output, bool& time_dependent) {
  const SchemaAttribute& attribute = (*node.schema)[output.attribute];
  Hasher hasher;
  hasher.add(std::string_view(node.type->name()));
  hasher.add(std::uint64_t(node.type->version()) << 32 | std::uint32_t(output.attribute));
  if (node.type->spec().time_source) {
    time_dependent = true;
    hasher.add(time_);
  }
  for (const AttributeIndex input : attribute.affected_by) {
    if ((*node.schema)[input].array == no_attribute) {
      add_input_identity(hasher, node, input, -1);
      continue;
    }
    for (const std::int32_t element : node.elements(input)) {
      hasher.add(std::uint64_t(element));
      add_input_identity(hasher, node, input, element);
    }
  }
  for (const Input& input : node.inputs)
    if (!time_dependent && affects(node, input.attribute, output.attribute))
      time_dependent = results_.at(input.source.whole())->time_dependent;
  return hasher.result();
}

bool Evaluation::reads_hold(const Node& node, const std::vector<OtherTimeRead>& reads) {
  return std::all_of(reads.begin(), reads.end(), [&](const OtherTimeRead& read) {
    return evaluate_at(read.time, {node.id, read.attribute, read.element, -1})->identity == read.identity;
  });
}

ResultPtr Evaluation::evaluate_at(double time, const Plug& plug) {
  if (time == time_) return evaluate(plug);
  std::unique_ptr<Evaluation>& other = other_times_[time];
  if (!other) {
    EvaluationServices services = services_;
    // What does not depend on time need not be looked for again.
    services.known = [this](const Plug& wanted) -> ResultPtr {
      const ResultPtr* found = results_.find(wanted);
      ResultPtr result = found ? *found : services_.known ? services_.known(wanted) : nullptr;
      return result && !result->time_dependent ? result : nullptr;
    };
    other = std::make_unique<Evaluation>(snapshot_, time, services);
  }
  const EvaluationCounters before = other->counters_;
  ResultPtr result = other->evaluate(plug);
  counters_.computes += other->counters_.computes - before.computes;
  counters_.cache_hits += other->counters_.cache_hits - before.cache_hits;
  for (const auto& [type, count] : other->counters_.computes_of_type) {
    const auto old = before.computes_of_type.find(type);
    counters_.computes_of_type[type] += count - (old == before.computes_of_type.end() ? 0 : old->second);
  }
  return result;
}

// The value of an input whose sources are all there.
Value Evaluation::gathered(const Node& node, AttributeIndex attribute, std::int32_t element) {
  const AttributeSpec& spec = (*node.schema)[attribute].spec;
  Value value = node.value(attribute, element);
  for (const Input& input : node.inputs_of(attribute, element)) {
    const Value part = component_of(results_.at(input.source.whole())->value, input.source.component);
    value = input.component < 0 ? part : with_component(value, input.component, number_of(part));
  }
  return converted(value, spec);
}

ResultPtr Evaluation::compute(const Node& node, const Plug& output, Hash key, bool time_dependent) {
  Context context(*this, node, output);
  std::string message;
  {
    std::unique_lock<std::recursive_mutex> alone;
    if (!node.type->spec().concurrent && services_.one_at_a_time)
      alone = std::unique_lock(*services_.one_at_a_time);
    ++counters_.computes;
    ++computes_[node.type.get()];
    if (services_.at_work) *services_.at_work = node.id;
    try {
      node.type->spec().compute(context, output.attribute);
      if (!context.wrote(output.attribute))
        message = "computed nothing for '" + (*node.schema)[output.attribute].path + "'";
    } catch (const EvaluationCancelled&) {
      throw;
    } catch (const std::exception& error) {
      message = error.what();
    } catch (...) {
      message = "failed without saying why";
    }
  }
  // What a computation writes after it was asked to stop is worth nothing.
  check_cancelled();
  if (!message.empty()) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    return std::make_shared<const Result>(
        Result{.has_value = false,
               .time_dependent = time_dependent,
               .error = std::make_shared<const ComputeError>(ComputeError{output, message})});
  }
  ResultPtr wanted;
  for (auto& [attribute, value] : context.outputs_) {
    // Another output comes along where it depends on nothing more than this one.
    const auto& mine = (*node.schema)[output.attribute].affected_by;
    const auto& its = (*node.schema)[attribute].affected_by;
    const bool comes_along = std::all_of(its.begin(), its.end(), [&](AttributeIndex input) {
      return std::find(mine.begin(), mine.end(), input) != mine.end();
    });
    if (attribute != output.attribute && !comes_along) continue;
    const Plug plug{node.id, attribute};
    bool ignored = false;
    const Hash own_key = attribute == output.attribute ? key : key_of(node, plug, ignored);
    Result result;
    result.identity = identity_of(value, own_key);
    result.value = std::move(value);
    result.time_dependent = time_dependent || !context.reads_.empty();
    const auto shared = std::make_shared<const Result>(std::move(result));
    // What was read without being declared is not in the key, so that the cache could not be trusted.
    if (services_.cache && !undeclared_reads_.contains(output))
      services_.cache->insert(own_key, {shared, context.reads_,
                                        attribute == output.attribute ? context.warning_ : std::string()});
    if (attribute == output.attribute)
      wanted = shared;
    else
      store(plug, shared);
  }
  if (!context.warning_.empty()) warnings_[output] = std::move(context.warning_);
  return wanted;
}

}  // namespace plinian::graph
