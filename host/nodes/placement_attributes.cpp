// Declares and reads a placement.
#include "host/nodes/placement_attributes.h"

namespace plinian::nodes {

using sdk::Attribute;
using sdk::AttributeSpec;

namespace {

// Three numbers under one name; double, so that nothing is lost of a camera's place.
void add_three(sdk::NodeType& type, const std::string& name, const std::string& number_type,
               const char* default_value, const std::string& unit, const std::string& help,
               const std::string& affects, Attribute (&axes)[3]) {
  AttributeSpec spec{.name = name,
                     .type = "compound",
                     .help = help,
                     .group = "Transform",
                     .affects = affects,
                     .of_picture = false};
  for (const char* axis : {"x", "y", "z"})
    spec.children.push_back(
        {.name = axis, .type = number_type, .default_value = default_value, .unit = unit});
  const Attribute compound = type.add(spec);
  for (int i = 0; i < 3; ++i) axes[i] = {compound.index + 1 + i};
}

dvec3 three(const sdk::Context& context, const Attribute (&axes)[3]) {
  return {context.number(axes[0]), context.number(axes[1]), context.number(axes[2])};
}

}  // namespace

PlacementAttributes::PlacementAttributes(sdk::NodeType& type, const std::string& affects) {
  type.hierarchical = true;
  add_three(type, "translate", "distance", "0", "m", "Where it stands under its parent.", affects,
            translate_);
  add_three(type, "rotate", "angle", "0", "degrees", "Turns about its axes, in the order of rotate_order.",
            affects, rotate_);
  std::string orders;
  for (const std::string& order : rotate_order_names()) orders += (orders.empty() ? "" : ",") + order;
  order_ = type.add({.name = "rotate_order",
                     .type = "enum",
                     .help = "The axis that is turned about first, second and third.",
                     .group = "Transform",
                     .choices = orders,
                     .affects = affects,
                     .of_picture = false});
  add_three(type, "scale", "double", "1", "", "Size along its axes; negative mirrors.", affects, scale_);
  add_three(type, "pivot", "distance", "0", "m", "The point that turning and scaling leave where it is.",
            affects, pivot_);
  type.add({.name = "visibility",
            .type = "bool",
            .default_value = "true",
            .help = "Off: neither it nor what is under it is seen.",
            .group = "Transform",
            .of_picture = false});
}

Placement PlacementAttributes::read(const sdk::Context& context) const {
  return {.translate = three(context, translate_),
          .rotate = three(context, rotate_),
          .order = RotateOrder(int(context.number(order_))),
          .scale = three(context, scale_),
          .pivot = three(context, pivot_)};
}

}  // namespace plinian::nodes
