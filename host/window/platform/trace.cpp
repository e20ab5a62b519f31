// Written line by line, so that a reader sees each at once.
#include "host/window/platform/trace.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace plinian::window {

Trace::Trace(const std::string& path) {
  if (path.empty()) return;
  file_ = std::fopen(path.c_str(), "w");
  if (!file_) throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
}

Trace::~Trace() {
  if (file_) std::fclose(file_);
}

double Trace::milliseconds() const {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
}

void Trace::note(const std::string& line) {
  if (!file_) return;
  fmt::print(file_, "{:.0f} {}\n", milliseconds(), line);
  std::fflush(file_);
}

void Trace::item(const std::string& name, vec2 begin, vec2 size) {
  if (!file_) return;
  const ivec4 place(std::lround(begin.x), std::lround(begin.y), std::lround(size.x), std::lround(size.y));
  const auto [known, fresh] = items_.emplace(name, place);
  if (!fresh && known->second == place) return;
  known->second = place;
  note(fmt::format("item \"{}\" {} {} {} {}", name, place.x, place.y, place.z, place.w));
}

}  // namespace plinian::window
