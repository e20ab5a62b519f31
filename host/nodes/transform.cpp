// The node type "transform": a group with a place.
//
// attribute       unit
// translate       m, under its parent
// rotate          degrees, in rotate_order
// scale           -
// pivot           m, in its own space
// visibility      off hides what is under it as well
// matrix          parent_from_own
// inverse_matrix  own_from_parent
#include "host/nodes/matrices.h"
#include "host/nodes/node_types.h"
#include "host/nodes/placement_attributes.h"

namespace plinian::nodes {

void add_transform(sdk::Plugin& plugin) {
  sdk::NodeType type("transform");
  type.help = "A group with a place: what is under it moves, turns, scales and hides with it.";
  type.holds_children = true;
  const PlacementAttributes placement(type, "matrix inverse_matrix");
  const sdk::Attribute matrix = type.add(
      {.name = "matrix", .type = "matrix", .help = "From its own space to its parent's.", .output = true});
  const sdk::Attribute inverse = type.add({.name = "inverse_matrix",
                                           .type = "matrix",
                                           .help = "From its parent's space to its own.",
                                           .output = true});
  type.compute = [=](sdk::Context& context, sdk::Attribute output) {
    const dmat4 parent_from_own = matrix_of(placement.read(context));
    if (output == matrix) return context.set(matrix, columns(parent_from_own));
    if (glm::determinant(dmat3(parent_from_own)) == 0.0) throw sdk::Error("a scale of 0 cannot be undone");
    context.set(inverse, columns(glm::inverse(parent_from_own)));
  };
  plugin.add(type);
}

}  // namespace plinian::nodes
