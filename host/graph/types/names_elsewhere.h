// Names that are not known at the moment and that something could bring: a plug-in that is not loaded.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace plinian::graph {

struct NamesElsewhere {
  /// Who brings a name, as ": the plug-in 'extras' brings it: loadPlugin extras"; empty where nobody does.
  std::function<std::string(const std::string& name)> source;
  /// All that somebody brings.
  std::function<std::vector<std::string>()> names;

  /// What goes behind an error about a name that is not there: who brings it, or what was meant.
  std::string hint(const std::string& name, const std::vector<std::string>& known) const;
};

}  // namespace plinian::graph
