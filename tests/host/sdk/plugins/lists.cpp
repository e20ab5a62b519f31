// Files that list names, and a node type that has a visibility of its own.
#include <fstream>

#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

NodeType ghost() {
  NodeType type("ghost");
  type.hierarchical = true;
  const Attribute seen = type.add({.name = "visibility", .default_value = "0.25", .affects = "out"});
  const Attribute out = type.add({.name = "out", .output = true});
  type.compute = [=](Context& context, Attribute) { context.set(out, 2.0 * context.number(seen)); };
  return type;
}

// Knows nothing of namespaces, and names nodes as they should be called.
void import_names(Call& call, const std::string& path) {
  std::ifstream file(path);
  for (std::string name; std::getline(file, name);) {
    call.execute("createNode transform -name " + name);
    call.execute("setAttr " + name + ".translate.y 5");
    call.answer(name);
  }
}

void export_names(Call& call, const std::string& path) {
  std::ofstream file(path);
  for (const std::string& name : call.words("nodes")) {
    if (name == "nothing") return;
    file << name << std::endl;
    if (name == "broken") throw Error(path + ": 'broken' has no name in such files");
  }
}

void initialise(Plugin& plugin) {
  NodeType place("place");
  place.hierarchical = true;
  plugin.add(place);
  plugin.add(ghost());
  plugin.add(FileType{
      .name = "list", .extensions = "list", .import_file = import_names, .export_file = export_names});
}

}  // namespace

PLINIAN_PLUGIN("lists", "1.0", "A. Artist", "node:place node:ghost file:list", initialise);
