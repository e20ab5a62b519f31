// Patterns and timing of sequences.
#include "core/media/frame_sequence.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace plinian {

namespace fs = std::filesystem;

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Where a place for a number lies in a name, and how many digits it takes at least.
struct Place {
  std::size_t begin = 0, end = 0;
  int digits = 1;
};

std::optional<Place> hashes(const std::string& name) {
  const std::size_t last = name.rfind('#');
  if (last == name.npos) return std::nullopt;
  std::size_t first = last;
  while (first > 0 && name[first - 1] == '#') --first;
  return Place{first, last + 1, int(last + 1 - first)};
}

// %d and %04d.
std::optional<Place> printf_place(const std::string& name) {
  for (std::size_t at = name.rfind('%'); at != name.npos; at = at ? name.rfind('%', at - 1) : name.npos) {
    std::size_t end = at + 1;
    while (end < name.size() && is_digit(name[end])) ++end;
    if (end >= name.size() || name[end] != 'd' || end - at > 3) continue;
    const int digits = end > at + 1 ? std::stoi(name.substr(at + 1, end - at - 1)) : 1;
    return Place{at, end + 1, std::max(1, digits)};
  }
  return std::nullopt;
}

// $F and $F4.
std::optional<Place> houdini_place(const std::string& name) {
  const std::size_t at = name.rfind("$F");
  if (at == name.npos) return std::nullopt;
  const bool wide = at + 2 < name.size() && is_digit(name[at + 2]);
  return Place{at, at + (wide ? 3 : 2), wide ? std::max(1, name[at + 2] - '0') : 1};
}

}  // namespace

std::optional<FramePattern> FramePattern::parse(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::size_t begin = slash == path.npos ? 0 : slash + 1;
  const std::string name = path.substr(begin);
  std::optional<Place> place = hashes(name);
  if (!place) place = printf_place(name);
  if (!place) place = houdini_place(name);
  if (!place) return std::nullopt;
  FramePattern pattern;
  pattern.text_ = path;
  pattern.before_ = path.substr(0, begin + place->begin);
  pattern.after_ = name.substr(place->end);
  pattern.digits_ = place->digits;
  return pattern;
}

std::string FramePattern::path(int frame) const {
  std::string digits = std::to_string(std::abs((long long)(frame)));
  if (int(digits.size()) < digits_) digits.insert(0, std::size_t(digits_) - digits.size(), '0');
  return before_ + (frame < 0 ? "-" : "") + digits + after_;
}

std::string FramePattern::unnumbered() const {
  std::string path = before_;
  while (!path.empty() && std::string_view("._-").find(path.back()) != std::string_view::npos)
    path.pop_back();
  return path + after_;
}

std::vector<int> FramePattern::frames_on_disk() const {
  const fs::path beginning(before_);
  const fs::path folder = beginning.has_parent_path() ? beginning.parent_path() : fs::path(".");
  const std::string name = beginning.filename().string();
  std::vector<int> frames;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string file = at->path().filename().string();
    if (file.size() <= name.size() + after_.size() || !file.starts_with(name) || !file.ends_with(after_))
      continue;
    const char* const first = file.data() + name.size();
    const char* const last = file.data() + file.size() - after_.size();
    int frame = 0;
    const auto [rest, failure] = std::from_chars(first, last, frame);
    if (failure != std::errc() || rest != last) continue;
    if (fs::path(path(frame)).filename() == file) frames.push_back(frame);
  }
  std::sort(frames.begin(), frames.end());
  return frames;
}

double source_frame(const FrameTiming& timing, double time) {
  const double ratio = timing.frames_per_second > 0.0 ? timing.frames_per_second / timing.scene_rate : 1.0;
  return (timing.speed < 0.0 ? timing.end : timing.start) +
         (time - timing.start - timing.offset) * timing.speed * ratio;
}

std::optional<int> frame_in_range(const FrameTiming& timing, double source) {
  if (!std::isfinite(source) || std::abs(source) > 1e9) return std::nullopt;
  // Rounding must not show a frame one moment too late.
  const long long frame = (long long)(std::floor(source + 1e-6));
  const long long first = (long long)(std::floor(timing.start)), last = (long long)(std::floor(timing.end));
  if (last < first) return std::nullopt;
  if (frame >= first && frame <= last) return int(frame);
  const long long count = last - first + 1, place = frame - first;
  const auto wrapped = [&](long long period) { return ((place % period) + period) % period; };
  switch (frame < first ? timing.before : timing.after) {
    case Beyond::hold:
      return int(frame < first ? first : last);
    case Beyond::loop:
      return int(first + wrapped(count));
    case Beyond::ping_pong: {
      if (count == 1) return int(first);
      const long long turn = wrapped(2 * count - 2);  // the ends are shown once
      return int(first + (turn < count ? turn : 2 * count - 2 - turn));
    }
    case Beyond::blank:
      break;
  }
  return std::nullopt;
}

}  // namespace plinian
