// What a benchmark ran on.
#pragma once

#include <string>

namespace plinian::cli {

/// "AMD EPYC, 2 cores".
std::string machine_name();

}  // namespace plinian::cli
