// Which names of files are frames of one sequence.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace plinian {

struct NameGroup {
  std::string name;                  // "smoke.####.vdb", as FramePattern reads it; the name where it is alone
  std::vector<std::size_t> members;  // places among the names that were given, by number
  int first = 0, last = 0;           // frames; 0 where the name is alone
};

/// Names that differ only in the number before their extension belong together where a pattern writes them
/// all: equally padded, or none of them padded. Versions ("ash_v2.vdb") are no frames. In no order.
std::vector<NameGroup> group_names(const std::vector<std::string>& names);

}  // namespace plinian
