// Data that scenes hold, a file type, a menu entry and callbacks, from outside.
#include <fstream>
#include <sstream>

#include "host/sdk/plugin.h"

namespace {

using namespace plinian::sdk;

struct Points {
  std::vector<double> values;
};

std::unique_ptr<const Points> read_points(std::string_view bytes) {
  std::istringstream text{std::string(bytes)};
  auto points = std::make_unique<Points>();
  for (double value = 0.0; text >> value;) points->values.push_back(value);
  if (!text.eof()) throw Error("a point is no number");
  return points;
}

std::string write_points(const Points& points) {
  std::ostringstream text;
  for (std::size_t i = 0; i < points.values.size(); ++i) text << (i ? " " : "") << points.values[i];
  return text.str();
}

// Bytes that are no text.
struct Blob {
  std::string bytes;
};

NodeType cloud_of_points() {
  NodeType type("points");
  const Attribute points =
      type.add({.name = "points", .type = "data", .data_type = "pointList", .affects = "count"});
  const Attribute blob = type.add({.name = "blob", .type = "data", .data_type = "blob", .affects = "count"});
  const Attribute count = type.add({.name = "count", .output = true});
  type.compute = [=](Context& context, Attribute) {
    const auto* held = static_cast<const Points*>(context.data(points));
    const auto* bytes = static_cast<const Blob*>(context.data(blob));
    context.set(count,
                (held ? double(held->values.size()) : -1.0) + (bytes ? double(bytes->bytes.size()) : 0.0));
  };
  return type;
}

FileType point_files() {
  FileType type;
  type.name = "points";
  type.extensions = "xyz pts";
  type.import_file = [](Call& call, const std::string& path) {
    std::ifstream file(path);
    if (!file) throw Error(path + ": cannot be read");
    std::string text;
    std::getline(file, text);
    const auto space = call.words("namespace");
    const std::string name =
        call.execute("createNode points -name " + (space.empty() ? "" : space[0] + ":") + "read");
    call.execute("setAttr " + name + ".points \"" + text + "\"");
    call.answer(name);
  };
  type.export_file = [](Call& call, const std::string& path) {
    std::ofstream file(path);
    for (const std::string& node : call.words("nodes"))
      file << call.execute("getAttr " + node + ".points") << "\n";
  };
  return type;
}

// What it heard, asked for by a command.
std::vector<std::string> heard;
std::unique_ptr<Subscription> once;

void initialise(Plugin& plugin) {
  heard.clear();
  plugin.add(DataType::of<Points>("pointList", write_points, read_points));
  plugin.add(DataType::of<Blob>(
      "blob",
      [](const Blob& blob) {
        if (blob.bytes == "bad") throw Error("it is spoiled");
        return blob.bytes;
      },
      [](std::string_view bytes) { return std::make_unique<const Blob>(Blob{std::string(bytes)}); }));
  plugin.add(cloud_of_points());
  plugin.add(point_files());
  plugin.add(MenuEntry{"Create/Points", "createNode points", "An empty cloud of points."});
  for (const char* kind : {"nodeCreated", "nodeDeleted", "nodeRenamed", "attributeChanged", "connected",
                           "disconnected", "selectionChanged", "timeChanged", "beforeNew", "afterNew",
                           "beforeOpen", "afterOpen", "beforeSave", "afterSave"})
    plugin.on(kind, [](const Event& event) {
      std::string line = event.kind;
      for (const std::string& text : {event.node, event.plug})
        if (!text.empty()) line += " " + text;
      if (!event.other.empty()) line += " (" + event.other.substr(event.other.rfind('/') + 1) + ")";
      if (event.kind == "timeChanged") line += " " + std::to_string(int(event.time));
      heard.push_back(line);
    });
  plugin.on("attributeChanged", [](const Event& event) {
    if (event.plug == "bad.blob") throw Error("not that one");
    // Whoever is called "follow" has twice the count.
    if (event.plug == "lead.points") event.execute("setAttr follow.points \"1 2 3 4\"");
  });
  once = std::make_unique<Subscription>(plugin.subscribe("nodeCreated", [](const Event& event) {
    heard.push_back("once " + event.node);
    once.reset();
  }));
  plugin.add(Command{.name = "heard", .help = "What was heard since.", .run = [](Call& call) {
                       for (const std::string& line : heard) call.answer(line);
                       heard.clear();
                     }});
}

}  // namespace

PLINIAN_PLUGIN("extras", "1.0", "A. Artist", "node:points data:pointList data:blob file:points command:heard",
               initialise);
