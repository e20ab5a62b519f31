// What all tables of one plug-in share: what it is called, and how much of its data is held. Its library must
// stay while its code may be called to release some.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>

namespace plinian::sdk {

struct DataCount {
  std::atomic<std::size_t> objects{0};
  std::string owner = "a plug-in";  // "the plug-in 'wobble'"
};

}  // namespace plinian::sdk
