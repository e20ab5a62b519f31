#include "viewport/passes/program_cache.h"

#include <algorithm>

namespace plinian::passes {

PacedProgram& ProgramCache::get(const gl::Defines& defines) {
  const auto found = std::find_if(programs_.begin(), programs_.end(),
                                  [&](const auto& entry) { return entry.first == defines; });
  if (found != programs_.end()) {
    programs_.splice(programs_.begin(), programs_, found);
  } else {
    programs_.emplace_front(defines, PacedProgram{gl::make_compute_program(shader_.c_str(), defines), {}});
    if (programs_.size() > most_) programs_.pop_back();
  }
  return programs_.front().second;
}

}  // namespace plinian::passes
