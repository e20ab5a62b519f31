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
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "node:fineNode node:badNode", initialise);
#elif defined(BAD_DATA)
// Registers a data type as often as BAD_DATA says.
struct Thing {};
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  for (int i = 0; i < BAD_DATA; ++i)
    plugin.add(DataType::of<Thing>(
        "pointList", [](const Thing&) { return std::string(); },
        [](std::string_view) { return std::make_unique<const Thing>(); }));
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "data:pointList", initialise);
#elif defined(BAD_CONTRIBUTE)
// Fit to be loaded; its nodes fail, each in its own way.
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  NodeType type("sky");
  const Attribute how = type.add({.name = "how", .type = "string"});
  type.contribute = [=](Context& context, Contribution& out) {
    if (context.text(how) == "throws") throw Error("the sky has fallen");
    if (context.text(how) == "other") throw 7;
    if (context.text(how) == "volume") out.add(Medium{});
    if (context.text(how) == "light") out.add(Light{.name = "sun", .toward = {0, 0, 0}});
    if (context.text(how) == "matrix") out.add(Camera{.object_from_camera = scaled(0.0)});
    if (context.text(how) == "sheared")
      out.add(Camera{.object_from_camera = {2, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}});
    if (context.text(how) == "mirrored")
      out.add(Camera{.object_from_camera = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}});
    if (context.text(how) == "empty") {
      VolumeSource source;
      source.count = {8, 8, 8};
      context.make_volume(source);
    }
    if (context.text(how) == "bounds") out.add_bounds({1, 0, 0}, {0, 0, 0});
  };
  plugin.add(type);
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "node:sky", initialise);
#elif defined(BAD_DRAW)
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  NodeType type("sky");
  type.add({.name = "height"});
  Draw<int, int> draw;
  draw.affected_by = "heigth";
  draw.prepare = [](Context&) { return std::make_unique<const int>(1); };
  type.draw = draw_override(draw);
  plugin.add(type);
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "node:sky", initialise);
#elif defined(BAD_MENU)
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  plugin.add(NodeType("sky"));
  plugin.add(MenuEntry{.path = "Sky", .command = "createNode sky"});
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "node:sky", initialise);
#elif defined(BAD_FILE)
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  plugin.add(NodeType("sky"));
  plugin.add(
      FileType{.name = "others", .extensions = "xyz", .import_file = [](Call&, const std::string&) {}});
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "node:sky file:others", initialise);
#elif defined(BAD_EVENT)
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  plugin.on("timeChanged", [](const Event&) {});
  plugin.on("tomeChanged", [](const Event&) {});
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "", initialise);
#elif defined(BAD_COMMAND)
// Fit to be loaded; its command fails, each time in another way.
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  plugin.add(Command{.name = "stumble", .parameters = {{.name = "how"}}, .run = [](Call& call) {
                       const std::string how = call.words("how").at(0);
                       if (how == "number") std::stoi("no number");
                       if (how == "other") throw 7;
                       if (how == "inner") call.execute("delete nobody");
                       if (how == "named") throw Error("stumble: not today");
                       if (how == "itself") call.execute("stumble itself");
                       if (how == "fall") call.execute("fall");
                     }});
  plugin.add(Command{.name = "fall", .run = [](Call& call) { call.execute("stumble fall"); }});
  plugin.add(Command{
      .name = "collect", .flags = {{.name = "item", .many = true}, {.name = "once"}}, .run = [](Call& call) {
        for (const std::string& item : call.words("item")) call.answer(item);
      }});
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "command:stumble command:fall command:collect", initialise);
#elif defined(BAD_EMPTY)
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  if (BAD_EMPTY == 1) plugin.add(Command{.name = "nothing"});
  if (BAD_EMPTY == 2) plugin.add(DataType::of<int>("nothing", {}, {}));
  if (BAD_EMPTY == 3) plugin.on("timeChanged", {});
  if (BAD_EMPTY == 5) {
    NodeType type("badNode");
    type.add({.name = "size", .widget = "sliderr"});
    plugin.add(type);
  }
  if (BAD_EMPTY == 4)
    plugin.add(Command{
        .name = "nothing", .flags = {{.name = "often", .kind = "", .many = true}}, .run = [](Call&) {}});
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "", initialise);
#elif defined(BAD_DESCRIPTION)
static void initialise(plinian::sdk::Plugin& plugin) {
  using namespace plinian::sdk;
  plugin.add(NodeType("said"));
  plugin.add(NodeType("unsaid"));
  plugin.add(Command{.name = "unsaidToo", .run = [](Call&) {}});
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "node:said data:undone", initialise);
#elif defined(BAD_SYMBOL)
// Needs a function that nobody has.
extern "C" void plinian_test_nobody_has_this();
static void initialise(plinian::sdk::Plugin&) {
  plinian_test_nobody_has_this();
}
PLINIAN_PLUGIN("bad", "1.0", "Nobody", "", initialise);
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
