// Files numbered by frames, and which of them a moment shows.
//
// A pattern has one place for the number in the file's name: `smoke.####.vdb` (four digits),
// `smoke.%04d.vdb`, `smoke.%d.vdb`, `smoke.$F4.vdb` or `smoke.$F.vdb`, as Maya, C and Houdini write it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plinian {

/// A file name with a place for a frame's number.
class FramePattern {
 public:
  /// Empty where the name of the file (not of its folder) has no such place.
  static std::optional<FramePattern> parse(const std::string& path);

  /// The path of a frame. Negative numbers get a '-' before their digits.
  std::string path(int frame) const;
  /// Numbers of the frames that are on the disk, ascending. Only names that path() would write count.
  std::vector<int> frames_on_disk() const;
  /// The path without the number and what sets it off: "smoke.vdb" of "smoke.####.vdb".
  std::string unnumbered() const;
  /// The whole path as it was given.
  const std::string& text() const { return text_; }

 private:
  std::string text_, before_, after_;  // before_ ends where the number begins
  int digits_ = 1;                     // at least so many
};

/// What is shown before the first and behind the last frame.
enum class Beyond { hold, loop, ping_pong, blank };

/// How time maps to the frames of a sequence.
struct FrameTiming {
  double start = 1.0, end = 1.0;   // [frames of the sequence] first and last one; end >= start
  double offset = 0.0;             // [frames of the scene] by which the sequence begins later
  double speed = 1.0;              // [-] 0.5: half as fast; negative: backwards, from the last frame on
  double frames_per_second = 0.0;  // of the sequence; 0: as the scene
  double scene_rate = 24.0;        // [frames/s] > 0
  Beyond before = Beyond::hold, after = Beyond::hold;
};

/// The sequence's frame at a time of the scene [frames], not yet held to its range. Frame `start` (or, played
/// backwards, `end`) is shown at time start + offset.
double source_frame(const FrameTiming& timing, double time);

/// The whole frame in [start, end] that a place in the sequence shows; a frame lasts until the next one.
/// Empty where nothing is shown.
std::optional<int> frame_in_range(const FrameTiming& timing, double source);

}  // namespace plinian
