// A drag of a handle: from what was there when the mouse was pressed, and the whole way of the mouse since.
#pragma once

#include <string>
#include <vector>

#include "host/window/handles/handle_target.h"

namespace plinian::window {

class HandleDrag {
 public:
  /// point: [points] of the screen at the interface's scale. snap: [world] step of places while Ctrl is held.
  HandleDrag(HandleTarget target, Part part, const Projection& projection, dvec2 pressed, float point,
             double snap);

  struct Result {
    std::vector<std::string> lines;  // commands that set what the target's nodes have now
    std::string text;                // "x +12.3 m", "45.0°", "×1.20"
    dvec3 stretch{1.0};              // [-] of the axes, while they are scaled
  };
  /// The mouse is at `mouse` [points]. snaps: to round steps of the way.
  Result to(dvec2 mouse, bool snaps);
  /// Commands that put everything back to where it was.
  std::vector<std::string> back() const;

  const HandleTarget& target() const { return target_; }
  const Projection& projection() const { return projection_; }
  Part part() const { return part_; }

 private:
  Result translated(dvec2 mouse, bool snaps);
  Result rotated(dvec2 mouse, bool snaps);
  Result scaled(dvec2 mouse, bool snaps);
  void add_lines(std::vector<std::string>& lines, std::size_t node, const dvec3& before, dvec3 after,
                 const dvec3& step) const;

  HandleTarget target_;
  Part part_;
  Projection projection_;
  dvec2 pressed_;                             // [points]
  float point_;                               // [points] at the interface's scale
  double snap_;                               // [world]
  double turn_ = 0.0;                         // [degrees] that was reached last: tells one turn from two
  std::vector<std::array<bool, 3>> changes_;  // of each node
};

}  // namespace plinian::window
