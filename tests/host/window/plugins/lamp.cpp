// A node with handles of its own: a place and a reach.
#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

void initialise(Plugin& plugin) {
  NodeType type("lampShape");
  type.hierarchical = true;
  type.add({.name = "place", .type = "float3"});
  type.add({.name = "range", .type = "distance", .default_value = "1.5"});
  type.handles = {{.name = "lamp", .attribute = "place"},
                  {.name = "range",
                   .grip = Grip::distance,
                   .attribute = "range",
                   .origin = "place",
                   .axis = {0, 1, 0},
                   .colour = {1.0f, 0.4f, 0.0f}}};
  plugin.add(type);
}

}  // namespace

PLINIAN_PLUGIN("lamp", "1.0", "A. Artist", "node:lampShape", initialise);
