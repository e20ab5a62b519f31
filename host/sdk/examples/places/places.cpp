// Places in a text file, a line each; a node that takes its time; and scenes of an older version of it.
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include "host/sdk/plugin.h"

using namespace plinian::sdk;

namespace {

void import_places(Call& call, const std::string& path) {
  std::ifstream file(path);
  if (!file) throw Error(path + ": cannot be read");
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::istringstream words(line);
    std::string name, x, y, z;
    if (!(words >> name >> x >> y >> z))
      throw Error(path + ":" + std::to_string(number) + ": a line is NAME X Y Z");
    const std::string node = call.execute("createNode transform -name " + name);
    call.execute("setAttr " + node + ".translate " + x + " " + y + " " + z);
    call.answer(node);
  }
}

void export_places(Call& call, const std::string& path) {
  std::ofstream file(path);
  for (const std::string& node : call.words("nodes")) {
    if (call.execute("ls -type transform " + node).empty()) continue;
    file << node;
    for (const char* axis : {".x", ".y", ".z"})
      file << ' ' << call.execute("getAttr " + node + ".translate" + axis);
    file << '\n';
  }
  if (!file.flush()) throw Error(path + ": cannot be written");
}

NodeType spread() {
  NodeType type("spread", 2);
  type.help = "How far apart two points in a ball are, on average.";
  const Attribute radius = type.add(
      {.name = "radius", .type = "distance", .default_value = "1", .affects = "mean", .minimum = 0.0});
  const Attribute pairs = type.add({.name = "pairs",
                                    .type = "int",
                                    .default_value = "100000",
                                    .help = "How many are tried.",
                                    .affects = "mean",
                                    .minimum = 1.0});
  const Attribute mean = type.add({.name = "mean", .type = "distance", .output = true});
  type.compute = [=](Context& context, Attribute) {
    const int count = int(context.number(pairs));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> side(-1.0, 1.0);
    const auto point = [&] {
      while (true)
        if (const std::array<double, 3> p{side(random), side(random), side(random)};
            std::hypot(p[0], p[1], p[2]) <= 1.0)
          return p;
    };
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
      if (i % 1024 == 0) {
        if (context.cancelled()) return;
        context.progress(double(i) / count, "trying pairs");
      }
      const auto a = point(), b = point();
      sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    context.set(mean, context.number(radius) * sum / count);
  };
  type.migrate = [](int from, Migration& migration) {
    const auto diameter = migration.text("diameter");  // as scenes of version 1 have it
    if (from != 1 || !diameter) return;
    std::istringstream words(*diameter);
    double number = 0.0;
    if (!(words >> number)) throw Error("the diameter " + *diameter + " is no number");
    migration.set("radius", std::to_string(number / 2.0));
    migration.remove("diameter");
  };
  return type;
}

void initialise(Plugin& plugin) {
  plugin.add(FileType{.name = "places",
                      .help = "Names and places, a line each.",
                      .extensions = "places",
                      .import_file = import_places,
                      .export_file = export_places});
  plugin.add(spread());
}

}  // namespace

PLINIAN_PLUGIN("places", "2.0", "A. Artist", "file:places node:spread", initialise);
