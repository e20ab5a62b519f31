// A diary of the window: what happened and when, a line each, for whoever measures it or drives it from
// outside.
//
//   512 picture 3 640x480 passes 1 quick
//   530 item "key.exposure" 1012 233 120 22
//
// The first word is the time since the start [ms].
#pragma once

#include <chrono>
#include <cstdio>
#include <map>
#include <string>

#include "core/shared/glue.h"

namespace plinian::window {

class Trace {
 public:
  /// path: empty for none. Throws std::runtime_error where it cannot be written.
  explicit Trace(const std::string& path);
  ~Trace();
  Trace(const Trace&) = delete;
  Trace& operator=(const Trace&) = delete;

  bool is_on() const { return file_ != nullptr; }
  void note(const std::string& line);
  /// Where a widget is, when it has moved. [points] of the window
  void item(const std::string& name, vec2 begin, vec2 size);
  double milliseconds() const;

 private:
  std::FILE* file_ = nullptr;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::map<std::string, ivec4> items_;
};

}  // namespace plinian::window
