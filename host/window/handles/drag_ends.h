// Drags that do not end by letting go: taken back, or refused before they begin.
#pragma once

#include <cstdint>
#include <string>

#include "host/window/studio.h"

namespace plinian::window {

/// Undoes what a drag did, if it did anything. steps: that the history had made before it. While a drag goes
/// on nothing else is edited, so that its step is the last one.
inline void take_back(Studio& studio, std::uint64_t steps) {
  studio.commands.later([&studio, steps] {
    if (studio.session().history().steps_made() != steps) studio.commands.run_now("undo");
  });
}

/// Says why something does not move.
inline void refuse(Studio& studio, const std::string& problem) {
  studio.console.add(LineKind::error, problem);
  studio.trace.note("refused: " + problem);
}

}  // namespace plinian::window
