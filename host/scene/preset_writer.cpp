#include "host/scene/preset_writer.h"

#include <algorithm>

namespace plinian::scene {

void PresetWriter::write(const std::string& attribute, const std::string& words) {
  const graph::Plug plug = graph::Graph::plug(node_, attribute);
  if (const std::string problem = session_.editor().set_problem(plug); !problem.empty()) {
    left_.push_back(problem.substr(0, problem.find(": ")));  // what to do about it is nobody's question here
    return;
  }
  const std::string name = session_.graph().name_of(plug);
  session_.execute(words.empty() ? "resetAttr " + name : "setAttr " + name + " " + words);
}

void PresetWriter::tell_left() const {
  if (left_.empty()) return;
  constexpr std::size_t most = 4;
  std::string line = "left as it is: ";
  for (std::size_t i = 0; i < std::min(left_.size(), most); ++i) line += (i ? "; " : "") + left_[i];
  if (left_.size() > most) line += "; and " + std::to_string(left_.size() - most) + " more";
  session_.note(line);
}

}  // namespace plinian::scene
