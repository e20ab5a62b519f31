// The commands that a field sends.
#pragma once

#include <string>
#include <vector>

#include "host/graph/model/graph.h"

namespace plinian::window {

/// setAttr for a plug and for the same attribute of every other selected node that has it, of the same type.
/// words: the value as commands spell it.
std::vector<std::string> set_lines(const graph::Graph& graph, const graph::Plug& plug,
                                   const std::string& words);
/// resetAttr, likewise.
std::vector<std::string> reset_lines(const graph::Graph& graph, const graph::Plug& plug);

/// The plug's value as commands spell it: what was set, or the default. A component is one number.
std::string words_at(const graph::Graph& graph, const graph::Plug& plug);

/// One number of a plug as it is set; 0 where it is none.
double number_at(const graph::Graph& graph, const graph::Plug& plug);

}  // namespace plinian::window
