// A computation that goes on until it is asked to stop, or, made deaf, for a minute.
#include <chrono>
#include <thread>

#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

void initialise(Plugin& plugin) {
  NodeType patient("patient");
  const Attribute in = patient.add({.name = "in", .affects = "out"});
  const Attribute deaf = patient.add({.name = "deaf", .type = "bool", .affects = "out"});
  const Attribute out = patient.add({.name = "out", .output = true});
  patient.compute = [=](Context& context, Attribute) {
    const double share = context.number(in);
    const bool is_deaf = context.number(deaf) != 0.0;
    for (int turn = 0; turn < 60000 && (is_deaf || !context.cancelled()); ++turn) {
      if (!is_deaf) context.progress(share, "waiting");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    context.set(out, share);
  };
  plugin.add(std::move(patient));
}

}  // namespace

PLINIAN_PLUGIN("patient", "1.0", "the tests", "node:patient", initialise);
