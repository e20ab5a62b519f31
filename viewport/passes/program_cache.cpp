#include "viewport/passes/program_cache.h"

#include <algorithm>
#include <utility>

namespace plinian::passes {

PacedProgram& ProgramCache::get(const gl::Defines& defines) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.defines == defines; });
  if (found != entries_.end())
    entries_.splice(entries_.begin(), entries_, found);
  else
    entries_.push_front({defines, {gl::make_compute_program(shader_.c_str(), defines), {}}});
  entries_.front().used = true;
  return entries_.front().program;
}

void ProgramCache::end_picture() {
  std::size_t unused = 0;
  std::erase_if(entries_,
                [&](Entry& entry) { return !std::exchange(entry.used, false) && ++unused > spare_; });
}

}  // namespace plinian::passes
