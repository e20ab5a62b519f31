// How a reader's advice is spelled, at a node and on a command line.
#include "host/nodes/read_facts.h"

#include <utility>

namespace plinian::nodes {

namespace {

std::string replaced(std::string text, bool to_node) {
  static constexpr std::pair<const char*, const char*> names[] = {
      {"--level-set", "attribute level_set"},
      {"--frustum", "attribute frustum"},
      {"--grid", "attribute grid"},
      {"--temperature-grid", "attribute temperature_grid"},
      {"--up-axis", "attribute up_axis"},
      {"--file-unit", "attribute file_unit"},
      {"--density-scale", "attribute density_scale"},
      {"--vdb-time-limit", "attribute time_limit"},
      {"--vdb-memory-limit", "attribute memory_limit"}};
  for (const auto& [option, attribute] : names) {
    const std::string from = to_node ? option : attribute, to = to_node ? attribute : option;
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace

std::string advice_for_node(std::string text) {
  return replaced(std::move(text), true);
}

std::string advice_for_command_line(std::string text) {
  return replaced(std::move(text), false);
}

}  // namespace plinian::nodes
