// How much of a plug-in's data is held: its library must stay while its code may be called to release some.
#pragma once

#include <atomic>
#include <cstddef>

namespace plinian::sdk {

struct DataCount {
  std::atomic<std::size_t> objects{0};
};

}  // namespace plinian::sdk
