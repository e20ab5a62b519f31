// Plug-ins that must be refused; each is built with one of these defined.
#include "host/sdk/plugin.h"

#if defined(BAD_THROWS)
static void initialise(plinian::sdk::Plugin& plugin) {
  plugin.add(plinian::sdk::NodeType("badNode"));
  throw plinian::sdk::Error("it is Monday");
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "", initialise);
#elif defined(BAD_TYPE)
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  plugin.add(NodeType("fineNode"));
  NodeType type("badNode");
  type.add({.name = "a", .affects = "nothing"});
  plugin.add(type);
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "node:badNode", initialise);
#elif defined(BAD_PLAIN)
// Without plugin.h: described by a file beside it, and throwing through the boundary or lacking functions.
#if defined(BAD_THROWS_THROUGH)
extern "C" int plinian_initialise(const PlinianHost*) {
  throw 7;
}
extern "C" void plinian_uninitialise(const PlinianHost*) {}
#endif
// Would end the program if the library were loaded before it is known to be fit.
#if defined(BAD_STATIC)
[[maybe_unused]] static const int end = (std::abort(), 0);
#endif
#endif
