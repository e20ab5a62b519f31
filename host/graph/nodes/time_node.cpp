// The node type "time": tells the current time, and holds the range and the rate of the scene.
//
// attribute   unit
// rate        frames per second
// start, end  frames: what the timeline shows
// out         frames: the current time
#include "host/graph/evaluation/compute_context.h"
#include "host/graph/nodes/node_types.h"

namespace plinian::graph {

void add_time_node(TypeRegistry& registry) {
  NodeTypeSpec spec;
  spec.name = "time";
  spec.help = "The current time. There is one of it in a scene; what it drives changes from frame to frame.";
  spec.time_source = true;
  spec.attributes = {
      {.name = "rate",
       .type = AttributeType::double1,
       .default_value = 24.0,
       .nice_name = "Frame Rate",
       .help = "Frames that make a second.",
       .unit = "frames/s",
       .minimum = 0.001,
       .soft_minimum = 12.0,
       .soft_maximum = 60.0,
       .keyable = false},
      {.name = "start",
       .type = AttributeType::time,
       .default_value = 1.0,
       .help = "First frame of the timeline.",
       .unit = "frames",
       .keyable = false},
      {.name = "end",
       .type = AttributeType::time,
       .default_value = 120.0,
       .help = "Last frame of the timeline.",
       .unit = "frames",
       .keyable = false},
      {.name = "out", .type = AttributeType::time, .help = "The current time.", .output = true}};
  const AttributeIndex out = Schema(spec.attributes).find("out");
  spec.compute = [out](ComputeContext& context, AttributeIndex) { context.set_output(out, context.time()); };
  registry.add(std::move(spec));
}

}  // namespace plinian::graph
