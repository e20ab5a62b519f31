// What a plug-in's compute function sees, over the graph's own context.
#pragma once

#include <forward_list>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "host/graph/evaluation/compute_context.h"
#include "host/sdk/abi.h"
#include "host/sdk/data_count.h"

namespace plinian::sdk {

/// Behind a PlinianContext: one run of a compute function.
struct ComputeState {
  graph::ComputeContext& context;
  std::shared_ptr<DataCount> data;
  std::string error, failure;
  std::forward_list<graph::Value> held;  // texts and data whose addresses were handed out
  std::vector<graph::DataPtr> volumes;   // likewise
  std::vector<std::int32_t> elements;

  ComputeState(graph::ComputeContext& of, std::shared_ptr<DataCount> count)
      : context(of), data(std::move(count)) {}
  PlinianContext* plain() { return reinterpret_cast<PlinianContext*>(this); }
};
inline ComputeState& state_of(PlinianContext* context) {
  return *reinterpret_cast<ComputeState*>(context);
}

/// Runs what a plug-in asked for; 0 and a message in the state where it throws.
template <class Action>
int guarded(PlinianContext* context, const Action& action) {
  ComputeState& state = state_of(context);
  try {
    action(state);
    return 1;
  } catch (const std::bad_variant_access&) {
    state.error = "an attribute was read as what it is not";
  } catch (const std::exception& error) {
    state.error = error.what();
  }
  return 0;
}

/// The value of an input at the present (time: null) or at another frame; good for as long as the state.
const graph::Value& input_of(ComputeState& state, std::int32_t attribute, std::int32_t element,
                             const double* time);

extern const PlinianCompute compute_table;

}  // namespace plinian::sdk
