// Hints at names.
#include "host/graph/types/names_elsewhere.h"

#include <algorithm>

#include "core/scene/nearest_word.h"

namespace plinian::graph {

std::string NamesElsewhere::hint(const std::string& name, const std::vector<std::string>& known) const {
  if (const std::string found = source ? source(name) : ""; !found.empty()) return found;
  if (const std::string meant = did_you_mean(name, known); !meant.empty()) return meant;
  const auto meant = names ? nearest_word(name, names()) : std::nullopt;
  return meant ? " (did you mean '" + *meant + "'" + source(*meant) + ")" : "";
}

}  // namespace plinian::graph
