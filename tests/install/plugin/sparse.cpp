// Every struct that an author writes with the names of its fields, with nearly all of them left out: no
// compiler may warn of that.
#include <type_traits>

#include "host/sdk/plugin.h"

using namespace plinian::sdk;

namespace {

struct Nothing {};

template <class... Struct>
constexpr bool are_aggregates = (std::is_aggregate_v<Struct> && ...);
static_assert(are_aggregates<AttributeSpec, Argument, Command, FileType, MenuEntry, Handle, DataType, AnyDraw,
                             Draw<int, Nothing>, VolumeInfo, VolumeSource, Medium, Light, Camera>);

void initialise(Plugin& plugin) {
  NodeType type("sparse");
  type.add({.name = "in"});
  type.add({.name = "group", .type = "compound", .children = {{.name = "inner"}, {.type = "int"}}});
  type.handles = {{.name = "end"}, {.grip = Grip::distance, .attribute = "in"}};
  type.draw = draw_override(Draw<int, Nothing>{.affected_by = "in"});
  type.draw = AnyDraw{.affected_by = "in"};
  type.contribute = [](Context& context, Contribution& contribution) {
    contribution.add(Medium{.volume = context.make_volume(VolumeSource{.count = {8, 8, 8}})});
    contribution.add(Medium{.name = "ball", .shape = MediumShape::sphere});
    contribution.add(Light{.intensity = 2.0f});
    contribution.add(Camera{.focal_length = 50.0f});
  };
  plugin.add(type);
  plugin.add(Command{.name = "sparseCommand", .flags = {{.name = "fast", .kind = ""}, {.name = "to"}}});
  plugin.add(FileType{.name = "sparse", .extensions = "sparse"});
  plugin.add(DataType{.name = "sparse"});
  plugin.add(MenuEntry{.path = "Create/Sparse"});
}

}  // namespace

PLINIAN_PLUGIN("sparse", "1.0", "Somebody Else", "node:sparse command:sparseCommand file:sparse data:sparse",
               initialise);
