// A plug-in that crashes where it is told to: $PLINIAN_TEST_CRASH names the part of its life, the attribute
// `how` of its node what happens there.
#include <csignal>
#include <cstdlib>

#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

bool is_asked_for(const char* part) {
  const char* wanted = std::getenv("PLINIAN_TEST_CRASH");
  return wanted && std::string(wanted) == part;
}

void fault() {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
}

int overrun(int depth) {
  volatile char page[4096] = {};
  page[0] = char(depth);
  return depth < 0 ? 0 : overrun(depth + 1) + page[0];
}

[[maybe_unused]] const int at_load = is_asked_for("load") ? (fault(), 0) : 0;

void initialise(Plugin& plugin) {
  if (is_asked_for("initialise")) fault();
  if (is_asked_for("exit")) std::exit(0);
  NodeType type("crash");
  const Attribute how = type.add({.name = "how", .type = "string", .affects = "out"});
  const Attribute out = type.add({.name = "out", .output = true});
  type.compute = [=](Context& context, Attribute) {
    const std::string what = context.text(how);
    if (what == "fault") fault();
    if (what == "abort") std::abort();
    if (what == "overrun") overrun(0);
    if (what == "fill") {
      VolumeSource source;
      source.count = {512, 512, 8};
      source.concurrent = true;
      source.fill = [](const Voxel& first, float*, float*) {
        if (first[1] == 256) fault();
        return false;
      };
      context.make_volume(source);
    }
    context.set(out, 1.0);
  };
  plugin.add(type);
  plugin.add(Command{.name = "crashNow", .help = "Crashes.", .run = [](Call&) { fault(); }});
  plugin.on("timeChanged", [](const Event&) { fault(); });
}

}  // namespace

PLINIAN_PLUGIN("crash", "1.0", "Nobody", "node:crash command:crashNow", initialise);
