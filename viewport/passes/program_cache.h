// The programs of a pass, one for each set of defines that a scene asked for. Beside those of the last
// picture only a few are kept: whoever tries out media, lights and encodings for a day would keep them all,
// and in llvmpipe one takes two MiB and more.
#pragma once

#include <list>
#include <string>

#include "viewport/gl/shader.h"
#include "viewport/passes/paced_tiles.h"

namespace plinian::passes {

class ProgramCache {
 public:
  /// shader: path of the file, as for make_compute_program(). spare: how many that a picture did not use
  /// outlive it, for going back and forth between two kinds of picture.
  explicit ProgramCache(std::string shader, std::size_t spare = 3)
      : shader_(std::move(shader)), spare_(spare) {}

  /// Made where it is not there; valid until the end of the picture. Throws as make_compute_program() does.
  PacedProgram& get(const gl::Defines& defines);
  /// Lets go of those that were not used for longest.
  void end_picture();
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    gl::Defines defines;
    PacedProgram program;
    bool used = true;  // by the picture under way
  };

  std::string shader_;
  std::size_t spare_;
  std::list<Entry> entries_;  // used last first
};

}  // namespace plinian::passes
