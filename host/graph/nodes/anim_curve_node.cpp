// The node type "animCurve": a number over time, by keys.
//
// attribute          unit
// in                 frames: where the curve is read; driven by the scene's time
// key[].time         frames
// key[].value        of what the curve drives
// key[].interpolation  how the curve runs to the next key: stepped, linear or smooth (monotone cubic: it
// passes
//                      through the keys and never overshoots them)
// out                of what the curve drives; held before the first and behind the last key
#include <algorithm>

#include "host/graph/evaluation/compute_context.h"
#include "host/graph/nodes/node_types.h"
#include "host/graph/values/ramp.h"

namespace plinian::graph {

double evaluate_keys(std::vector<AnimKey> keys, double time) {
  if (keys.empty()) return 0.0;
  std::stable_sort(keys.begin(), keys.end(),
                   [](const AnimKey& a, const AnimKey& b) { return a.time < b.time; });
  // Of keys at the same time the last one holds.
  std::vector<AnimKey> distinct;
  for (const AnimKey& key : keys)
    if (!distinct.empty() && distinct.back().time == key.time)
      distinct.back() = key;
    else
      distinct.push_back(key);
  const auto next = std::upper_bound(distinct.begin(), distinct.end(), time,
                                     [](double t, const AnimKey& key) { return t < key.time; });
  if (next == distinct.begin()) return distinct.front().value;
  if (next == distinct.end()) return distinct.back().value;
  const AnimKey &from = *std::prev(next), &to = *next;
  if (from.interpolation == Interpolation::stepped) return from.value;
  if (from.interpolation == Interpolation::linear)
    return from.value + (to.value - from.value) * (time - from.time) / (to.time - from.time);
  // A slope depends on a key's neighbours alone.
  const std::size_t i = std::size_t(std::prev(next) - distinct.begin());
  const std::size_t first = i > 0 ? i - 1 : i, last = std::min(i + 2, distinct.size() - 1);
  std::vector<double> x, y;
  for (std::size_t k = first; k <= last; ++k) {
    x.push_back(distinct[k].time);
    y.push_back(distinct[k].value);
  }
  const std::vector<double> slopes = monotone_slopes(x, y);
  const std::size_t at = i - first;
  return hermite(x[at], y[at], slopes[at], x[at + 1], y[at + 1], slopes[at + 1], time);
}

void add_anim_curve_node(TypeRegistry& registry) {
  NodeTypeSpec spec;
  spec.name = "animCurve";
  spec.help = "A number that changes over time, by keys. setKeyframe makes it.";
  spec.follows = true;
  spec.attributes = {
      {.name = "in",
       .type = AttributeType::time,
       .help = "Where the curve is read.",
       .unit = "frames",
       .keyable = false,
       .affects = {"out"}},
      {.name = "key",
       .type = AttributeType::compound,
       .help = "The keys, in any order.",
       .array = true,
       .keyable = false,
       .children = {{.name = "time", .type = AttributeType::time, .unit = "frames"},
                    {.name = "value", .type = AttributeType::double1},
                    {.name = "interpolation",
                     .type = AttributeType::choice,
                     .default_value = int(Interpolation::smooth),
                     .help = "How the curve runs to the next key.",
                     .choices = {{int(Interpolation::stepped), "stepped", "Stepped"},
                                 {int(Interpolation::linear), "linear", "Linear"},
                                 {int(Interpolation::smooth), "smooth", "Smooth"}}}},
       .affects = {"out"}},
      {.name = "out", .type = AttributeType::double1, .help = "The curve at `in`.", .output = true}};
  const Schema schema(spec.attributes);
  const AttributeIndex in = schema.find("in"), key = schema.find("key"), time = schema.find("key.time"),
                       value = schema.find("key.value"), interpolation = schema.find("key.interpolation"),
                       out = schema.find("out");
  spec.compute = [=](ComputeContext& context, AttributeIndex) {
    std::vector<AnimKey> keys;
    for (const std::int32_t element : context.elements(key))
      keys.push_back({context.number(time, element), context.number(value, element),
                      Interpolation(context.integer(interpolation, element))});
    context.set_output(out, evaluate_keys(std::move(keys), context.number(in)));
  };
  registry.add(std::move(spec));
}

}  // namespace plinian::graph
