// The programs of a pass, one for each set of defines that a scene asked for. Those that were not used for
// longest are let go of: whoever tries out media, lights and encodings for a day would keep them all, and in
// llvmpipe one takes about two MiB.
#pragma once

#include <list>
#include <string>
#include <utility>

#include "viewport/gl/shader.h"
#include "viewport/passes/paced_tiles.h"

namespace plinian::passes {

class ProgramCache {
 public:
  /// shader: path of the file, as for make_compute_program().
  explicit ProgramCache(std::string shader, std::size_t most = 6) : shader_(std::move(shader)), most_(most) {}

  /// Made where it is not there; valid until the next call. Throws as make_compute_program() does.
  PacedProgram& get(const gl::Defines& defines);
  std::size_t size() const { return programs_.size(); }

 private:
  std::string shader_;
  std::size_t most_;
  std::list<std::pair<gl::Defines, PacedProgram>> programs_;  // used last first
};

}  // namespace plinian::passes
