// What the evaluation of a plug came to.
#pragma once

#include <memory>
#include <string>

#include "host/graph/model/plug.h"
#include "host/graph/values/hash.h"
#include "host/graph/values/value.h"

namespace plinian::graph {

/// Why a computation failed. Everything downstream of it shares the same one.
struct ComputeError {
  Plug origin;          // the output whose computation failed
  std::string message;  // one line
};
using ErrorPtr = std::shared_ptr<const ComputeError>;

struct Result {
  Value value;
  bool has_value = true;        // false: known by its identity alone, the value having left the cache
  Hash identity;                // equal for equal values; of data without a known content: of what made them
  bool time_dependent = false;  // a node that tells the time is upstream
  ErrorPtr error;               // set: there is no value
};
using ResultPtr = std::shared_ptr<const Result>;

}  // namespace plinian::graph
