// The attributes of a node as an editor shows them: grouped, labelled, a row for what belongs together.
// Derived from the declarations alone, so that a plug-in's node is shown like any other.
#pragma once

#include <string>
#include <vector>

#include "host/graph/model/graph.h"

namespace plinian::window {

struct AttributeRow {
  graph::Plug plug;                // the whole: an attribute or a compound of numbers
  std::string name;                // "key.exposure", as commands spell it
  std::string label;               // "Exposure"
  std::vector<graph::Plug> parts;  // single numbers: components or children; empty where it is no number
  bool changed = false;            // set to something else than the default
  bool locked = false;
  std::string driver;  // the plug that drives it or a part of it; empty: none
};

struct AttributeGroup {
  std::string title;
  int depth = 0;     // under other groups
  bool open = true;  // to begin with
  std::vector<AttributeRow> rows;
};

/// Groups in the order in which they are declared; empty ones are left out, and so is what is hidden,
/// computed or not to be shown while another attribute says so.
std::vector<AttributeGroup> attribute_groups(const graph::Graph& graph, const graph::Node& node);

/// Those of a type that have a row while nothing else keeps them from being shown, in the order in which they
/// are declared.
std::vector<graph::AttributeIndex> row_attributes(const graph::Schema& schema);

/// "density_scale": "Density scale".
std::string label_of(const graph::AttributeSpec& spec);

/// The part's own letter or name: "x", "r"; empty for a row of one.
std::string part_label(const graph::Graph& graph, const AttributeRow& row, std::size_t part);

}  // namespace plinian::window
