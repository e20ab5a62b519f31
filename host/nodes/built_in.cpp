// One plug-in that is linked in.
#include "host/nodes/built_in.h"

#include "host/nodes/node_types.h"

namespace plinian::nodes {

namespace {

void initialise(sdk::Plugin& plugin) {
  add_time(plugin);
  add_anim_curve(plugin);
}

PLINIAN_LINKED_PLUGIN(plugin, "nodes", "0.1.0", "Plinian", "node:time node:animCurve", initialise);

}  // namespace

const PlinianLinkedPlugin& built_in_plugin() {
  return plugin;
}

void add_built_in(graph::Session& session, sdk::PluginManager& plugins) {
  plugins.add_linked(plugin);
  if (session.graph().size() == 0) session.new_scene();
}

}  // namespace plinian::nodes
