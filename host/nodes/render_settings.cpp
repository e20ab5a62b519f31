// The node type "renderSettings": how good a picture is to be, and how large.
//
// attribute         unit
// width, height     pixels
// background        radiance: constant sky behind the media
// camera            the camera that is looked through; none: the first one there is
// fast.*, high.*    two complete sets of what core/scene/quality_parameters.h declares
// fast.preset       name of the preset that the set was last taken from
//
// Which set is on belongs to whoever looks, as time does, and is no attribute.
#include <nlohmann/json.hpp>

#include "core/scene/parameter_json.h"
#include "core/scene/quality_parameters.h"
#include "core/scene/scene_parameters.h"
#include "host/nodes/core_attributes.h"
#include "host/nodes/node_types.h"
#include "shipped_presets.h"

namespace plinian::nodes {

namespace {

// The value of a parameter in a shipped preset, as scene files spell it.
std::string shipped_value(const nlohmann::json& preset, const ParameterSpec& parameter) {
  const std::size_t dot = parameter.name.find('.');
  const nlohmann::json& value = preset.at(parameter.name.substr(0, dot)).at(parameter.name.substr(dot + 1));
  return to_text(parameter, read_parameter(parameter, value, parameter.name));
}

// One set: the parameters "map.threshold", ... as compounds of compounds.
sdk::AttributeSpec quality_set(const std::string& name, const std::string& help, const char* text) {
  const nlohmann::json preset = nlohmann::json::parse(text);
  sdk::AttributeSpec set{.name = name, .type = "compound", .help = help, .group = name, .keyable = false};
  set.children.push_back({.name = "preset",
                          .type = "string",
                          .default_value = name,
                          .help = "The preset that the values were last taken from."});
  for (const Parameter<Quality>& parameter : quality_parameters()) {
    const std::size_t dot = parameter.spec.name.find('.');
    const std::string object = parameter.spec.name.substr(0, dot);
    if (set.children.back().name != object) set.children.push_back({.name = object, .type = "compound"});
    set.children.back().children.push_back(
        attribute_of(parameter.spec, {.name = parameter.spec.name.substr(dot + 1),
                                      .default_value = shipped_value(preset, parameter.spec)}));
  }
  return set;
}

}  // namespace

void add_render_settings(sdk::Plugin& plugin) {
  sdk::NodeType type("renderSettings");
  type.help = "How good a picture is to be, and how large. There is one of it in a scene.";
  type.unique = true;
  for (const char* side : {"width", "height"})
    type.add({.name = side,
              .type = "int",
              .default_value = "512",
              .help = std::string("Of the picture: its ") + side + ".",
              .unit = "pixels",
              .group = "Picture",
              .minimum = 1,
              .maximum = 32768,
              .soft_maximum = 4096,
              .keyable = false});
  type.add(attribute_of(scene_parameters(), "background", {.group = "Picture"}));
  type.add({.name = "camera",
            .type = "node",
            .help = "The camera that is looked through; none: the first one there is.",
            .group = "Picture",
            .keyable = false});
  type.add({.name = "default_lights",
            .type = "bool",
            .default_value = "true",
            .help = "Where the scene has no light, a key, a rim and a dim sky stand in for them.",
            .group = "Picture",
            .keyable = false});
  type.add(
      quality_set("fast", "What the picture is made with while a hand is on the controls.", shipped_fast));
  type.add(quality_set("high", "What a picture to judge by is made with.", shipped_high));
  // Scenes of version 1 were dark without lights.
  type.version = 2;
  type.migrate = [](int, sdk::Migration& migration) { migration.set("default_lights", "false"); };
  plugin.add(type);
}

}  // namespace plinian::nodes
