// Matrices as the SDK hands them on.
#pragma once

#include "core/shared/glue.h"
#include "host/sdk/plugin.h"

namespace plinian::nodes {

inline sdk::Matrix columns(const dmat4& matrix) {
  sdk::Matrix result;
  for (int i = 0; i < 16; ++i) result[std::size_t(i)] = matrix[i / 4][i % 4] + 0.0;  // no -0
  return result;
}

}  // namespace plinian::nodes
