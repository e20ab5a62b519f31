// The node type "animCurve": a number over time, by keys.
//
// attribute          unit
// in                 frames: where the curve is read; driven by the scene's time
// key[].time         frames
// key[].value        of what the curve drives
// key[].interpolation  how the curve runs to the next key: stepped, linear or smooth (monotone cubic: it
//                      passes through the keys and never overshoots them)
// out                of what the curve drives; held before the first and behind the last key
#include "host/graph/values/anim_keys.h"
#include "host/nodes/node_types.h"

namespace plinian::nodes {

void add_anim_curve(sdk::Plugin& plugin) {
  sdk::NodeType type("animCurve");
  type.help = "A number that changes over time, by keys. setKeyframe makes it.";
  type.follows = true;
  const sdk::Attribute in = type.add({.name = "in",
                                      .type = "time",
                                      .help = "Where the curve is read.",
                                      .unit = "frames",
                                      .affects = "out",
                                      .keyable = false});
  const sdk::AttributeSpec keys = {.name = "key",
                                   .type = "compound",
                                   .help = "The keys, in any order.",
                                   .affects = "out",
                                   .array = true,
                                   .keyable = false,
                                   .children = {{.name = "time", .type = "time", .unit = "frames"},
                                                {.name = "value", .type = "double"},
                                                {.name = "interpolation",
                                                 .type = "enum",
                                                 .default_value = "smooth",
                                                 .help = "How the curve runs to the next key.",
                                                 .choices = "stepped,linear,smooth"}}};
  const sdk::Attribute key = type.add(keys), time = type.child(key, keys, "time"),
                       value = type.child(key, keys, "value"),
                       interpolation = type.child(key, keys, "interpolation");
  const sdk::Attribute out =
      type.add({.name = "out", .type = "double", .help = "The curve at `in`.", .output = true});
  type.compute = [=](sdk::Context& context, sdk::Attribute) {
    std::vector<graph::AnimKey> found;
    for (const std::int32_t element : context.elements(key))
      found.push_back({context.number(time, element), context.number(value, element),
                       graph::Interpolation(int(context.number(interpolation, element)))});
    context.set(out, graph::evaluate_keys(std::move(found), context.number(in)));
  };
  plugin.add(type);
}

}  // namespace plinian::nodes
