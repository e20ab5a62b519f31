// The smallest plug-in: a node that doubles a number.
#include "host/sdk/plugin.h"

static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  NodeType type("twice");
  const Attribute in = type.add({.name = "in", .default_value = "1", .affects = "out"});
  const Attribute out = type.add({.name = "out", .output = true});
  type.compute = [=](Context& context, Attribute) { context.set(out, 2.0 * context.number(in)); };
  plugin.add(type);
}
PLINIAN_PLUGIN("outside", "1.0", "Somebody Else", "node:twice", initialise);
