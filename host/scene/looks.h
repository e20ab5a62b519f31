// Looks: the optical properties of media in JSON files, found by name in the folders `presets/looks`.
//
//   { "plinian_look": {"major": 1, "minor": 0}, "albedo": [0.6, 0.5, 0.4], "phase": "two_lobe", "g": 0.35 }
//
// The keys are those of a medium in a neutral scene that say how it looks. What a look leaves out is at its
// default, but density_scale, which belongs to a volume. Keys that begin with `_` are comments.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene_description.h"
#include "host/graph/commands/session.h"

namespace plinian::scene {

struct Look {
  std::string name, path;
  MediumDescription medium;  // of which only what says how it looks is given
  std::string hash;          // of what it says, as 16 hexadecimal digits
};

/// name_or_path: a path where it ends in .json or holds a slash. Throws std::runtime_error with one line: no
/// such look (listing those there are), unknown key, wrong type, out of range, newer major version.
Look load_look(const std::string& name_or_path);
std::vector<std::string> look_names();

/// Puts a look on a medium node, by commands; what is connected or locked is left alone. Throws GraphError
/// where the node is no medium.
void apply_look(graph::Session& session, const std::string& node, const Look& look);

/// The medium that looks are put on where none is named: that is selected, else the first; null: there is
/// none.
const graph::Node* medium_for_looks(const graph::Graph& graph);

/// A file that puts on what the medium looks like now.
std::string look_text(graph::Session& session, const std::string& node, const std::string& name);

/// One line for each medium whose look is not there any more, or says something else than when it was put
/// on.
std::vector<std::string> changed_looks(graph::Session& session);

}  // namespace plinian::scene
