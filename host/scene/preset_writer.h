// Writes the values of a preset or look into a node, past what is locked, keyed or driven by something else.
#pragma once

#include <string>
#include <vector>

#include "host/graph/commands/session.h"

namespace plinian::scene {

class PresetWriter {
 public:
  PresetWriter(graph::Session& session, const graph::Node& node) : session_(session), node_(node) {}

  /// words: as setAttr takes them; empty: back to the default.
  void write(const std::string& attribute, const std::string& words);
  /// Says, in one line, what was left as it is and why; nothing where all was written.
  void tell_left() const;

 private:
  graph::Session& session_;
  const graph::Node& node_;
  std::vector<std::string> left_;  // "medium.albedo is locked"
};

}  // namespace plinian::scene
