// A plug-in as one would write it: two node types, a command, data handed from node to node, a migrator.
#include "host/sdk/plugin.h"

#ifndef WOBBLE_NAME
#define WOBBLE_NAME "wobble"
#endif
#ifndef WOBBLE_TYPE
#define WOBBLE_TYPE "wobble"
#endif

#ifdef WOBBLE_NO_COMMAND
#define WOBBLE_REGISTERS "node:" WOBBLE_TYPE " node:" WOBBLE_TYPE "Total"
#else
#define WOBBLE_REGISTERS "node:" WOBBLE_TYPE " node:" WOBBLE_TYPE "Total command:wobbleAll"
#endif

namespace {

struct Numbers {
  std::vector<double> values;
};

using namespace plinian::sdk;

void initialise(Plugin& plugin) {
  NodeType wobble(WOBBLE_TYPE, 2);
  wobble.help = "Doubles a number, and makes data of it.";
  wobble.aliases = "strength=amount";
#ifdef WOBBLE_CHANGED  // as somebody built it a day later
  wobble.add({.name = "first", .affects = "out"});
#endif
  const Attribute amount = wobble.add({.name = "amount",
                                       .default_value = "1",
                                       .help = "What is doubled.",
                                       .affects = "out numbers",
                                       .minimum = -100.0,
                                       .maximum = 100.0});
  const Attribute label =
      wobble.add({.name = "label", .type = "string", .default_value = "two words", .affects = "out"});
  const Attribute more = wobble.add({.name = "more", .affects = "out", .array = true});
  const Attribute mode = wobble.add(
      {.name = "mode", .type = "enum", .default_value = "on", .choices = "off,on:10", .affects = "out"});
  const Attribute offset =
      wobble.add({.name = "offset", .type = "float3", .default_value = "0 0 0", .affects = "out"});
  const Attribute when = wobble.add({.name = "when", .type = "time", .affects = "before"});
  const Attribute in = wobble.add({.name = "in", .affects = "before"});
  const Attribute out = wobble.add({.name = "out", .output = true});
  const Attribute before = wobble.add({.name = "before", .output = true});
  const Attribute numbers =
      wobble.add({.name = "numbers", .type = "data", .data_type = "numbers", .output = true});
  wobble.compute = [=](Context& context, Attribute output) {
    if (output == numbers) {
      context.set_data(numbers, "numbers",
                       std::make_unique<const Numbers>(Numbers{{context.number(amount), 2.0, 3.0}}), 24);
      return;
    }
    if (output == before) {
      context.set(before, context.number_at(context.number(when) - 1.0, in));
      return;
    }
    if (context.text(label) == "fail") throw Error("the label says so");
    if (context.text(label) == "read nothing") context.number(Attribute{});
    if (context.text(label) == "read beyond") context.number(Attribute{99});
    if (context.text(label) == "elements beyond") context.elements(Attribute{99});
    if (context.text(label) == "write beyond") context.set(Attribute{99}, 1.0);
    double sum = 2.0 * context.number(amount) + context.vector(offset)[1];
    for (const std::int32_t element : context.elements(more)) sum += context.number(more, element);
    context.set(out, context.number(mode) == 10.0 ? sum : 0.0);
  };
  wobble.migrate = [](int, Migration& migration) {
    if (const auto half = migration.text("half")) {
#ifdef WOBBLE_MENDED
      migration.set("amount", *half == "many" ? "77" : std::to_string(2.0 * std::stod(*half)));
#else
      if (*half == "many") throw Error("half of many is not known");
      migration.set("amount", std::to_string(2.0 * std::stod(*half)));
#endif
      migration.remove("half");
    }
  };
  plugin.add(wobble);

  NodeType total(WOBBLE_TYPE "Total");
  const Attribute source =
      total.add({.name = "source", .type = "data", .data_type = "numbers", .affects = "out"});
  const Attribute sum = total.add({.name = "out", .type = "double", .output = true});
  total.compute = [=](Context& context, Attribute) {
    double value = 0.0;
    if (const auto* held = static_cast<const Numbers*>(context.data(source)))
      for (const double number : held->values) value += number;
    context.set(sum, value);
  };
  plugin.add(total);

#ifndef WOBBLE_NO_COMMAND
  plugin.add(Command{.name = "wobbleAll",
                     .help = "Sets the amount of nodes.",
                     .parameters = {{.name = "amount", .kind = "number", .help = "what to set"},
                                    {.name = "nodes", .kind = "node", .help = "names", .many = true}},
                     .run = [](Call& call) {
                       for (const std::string& node : call.words("nodes"))
                         call.execute("setAttr " + node + ".amount " + call.words("amount").at(0));
                       call.answer("done");
                     }});
#endif
}

}  // namespace

#ifdef WOBBLE_LINKED
PLINIAN_LINKED_PLUGIN(WOBBLE_LINKED, WOBBLE_NAME, "1.2", "A. Artist", WOBBLE_REGISTERS, initialise);
#else
PLINIAN_PLUGIN(WOBBLE_NAME, "1.2", "A. Artist", WOBBLE_REGISTERS, initialise);
#endif
