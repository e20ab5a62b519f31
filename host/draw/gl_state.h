// The state of OpenGL as it was, put back when somebody else's code has run.
#pragma once

#include <memory>

namespace plinian::draw {

/// Remembers the state of the current context when it is made, and restores it when it is destroyed:
/// programs, bindings, tests, blending, masks, viewport, pixel storage. Not what objects hold: those of
/// others are not a draw override's to change. Looks at the first 16 texture units and at the first 8 indexed
/// buffers and image units.
class GlState {
 public:
  GlState();
  ~GlState();
  GlState(const GlState&) = delete;
  GlState& operator=(const GlState&) = delete;

  struct Values;

 private:
  std::unique_ptr<Values> values_;
};

}  // namespace plinian::draw
