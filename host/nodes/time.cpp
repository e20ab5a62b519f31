// The node type "time": tells the current time, and holds the range and the rate of the scene.
//
// attribute   unit
// rate        frames per second
// start, end  frames: what the timeline shows
// out         frames: the current time
#include "host/nodes/node_types.h"

namespace plinian::nodes {

void add_time(sdk::Plugin& plugin) {
  sdk::NodeType type("time");
  type.help = "The current time. There is one of it in a scene; what it drives changes from frame to frame.";
  type.time_source = true;
  type.unique = true;
  type.add({.name = "rate",
            .type = "double",
            .default_value = "24",
            .nice_name = "Frame Rate",
            .help = "Frames that make a second.",
            .unit = "frames/s",
            .minimum = 0.001,
            .soft_minimum = 12.0,
            .soft_maximum = 60.0,
            .keyable = false});
  type.add({.name = "start",
            .type = "time",
            .default_value = "1",
            .help = "First frame of the timeline.",
            .unit = "frames",
            .keyable = false});
  type.add({.name = "end",
            .type = "time",
            .default_value = "120",
            .help = "Last frame of the timeline.",
            .unit = "frames",
            .keyable = false});
  const sdk::Attribute out =
      type.add({.name = "out", .type = "time", .help = "The current time.", .output = true});
  type.compute = [=](sdk::Context& context, sdk::Attribute) { context.set(out, context.time()); };
  plugin.add(type);
}

}  // namespace plinian::nodes
