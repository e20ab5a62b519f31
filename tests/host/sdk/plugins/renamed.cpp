// A node type whose attribute got another name and another meaning at a time, and a migrator that may be
// wrong.
#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

void initialise(Plugin& plugin) {
  NodeType type("renamed", 2);
  type.aliases = "strength=amount";
  type.add({.name = "amount", .default_value = "1"});
  type.add({.name = "how", .type = "string", .default_value = "right"});
  type.migrate = [](int, Migration& migration) {
    std::string how = migration.text("how").value_or("right");
    std::erase(how, '"');  // as it stands in the scene
    const auto old = migration.text("amount");
    if (!old) throw Error("there is no amount");
    const std::string twice = std::to_string(2 * std::stoi(*old));
    if (how == "misspelt") {
      migration.set("amuont", twice);
      migration.remove("amount");
    } else if (how == "no number") {
      migration.set("strength", "twice");
    } else if (how == "old name") {
      migration.set("strength", twice);
    } else {
      migration.set("amount", twice);
      if (how == "removed") migration.remove("strength");
    }
  };
  plugin.add(type);
}

}  // namespace

PLINIAN_PLUGIN("renamed", "1.2", "A. Artist", "node:renamed", initialise);
