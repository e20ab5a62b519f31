// What an action says when it refuses.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/graph/graph_error.h"

namespace plinian::graph {

/// The message of the GraphError that `action` throws; a test failure and "" where it throws none.
std::string message_of(const auto& action) {
  try {
    action();
  } catch (const GraphError& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

}  // namespace plinian::graph
