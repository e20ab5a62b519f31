// The node type "ambientLight": light from everywhere, scattered without shadow.
//
// attribute  unit
// colour     linear Rec.709
// intensity  radiance
// exposure   stops on intensity
// visibility off: it gives no light
#include "core/scene/scene_parameters.h"
#include "host/nodes/core_attributes.h"
#include "host/nodes/node_types.h"

namespace plinian::nodes {

void add_ambient_light(sdk::Plugin& plugin) {
  sdk::NodeType type("ambientLight");
  type.help = "Light from everywhere, scattered without shadow.";
  const auto& parameters = light_parameters();
  const sdk::Attribute colour =
      type.add(attribute_of(parameters, "colour", {.default_value = "1 1 1", .group = "Light"}));
  const sdk::Attribute intensity = type.add(attribute_of(
      parameters, "intensity",
      {.default_value = "1", .help = "Radiance from every side.", .group = "Light", .soft_maximum = 1}));
  const sdk::Attribute exposure = type.add(
      attribute_of(parameters, "exposure", {.group = "Light", .soft_minimum = -8, .soft_maximum = 8}));
  type.add({.name = "visibility",
            .type = "bool",
            .default_value = "true",
            .help = "Off: it gives no light.",
            .group = "Light",
            .of_picture = false});
  type.contribute = [=](sdk::Context& context, sdk::Contribution& contribution) {
    const auto tint = context.vector(colour);
    sdk::Light light;
    light.type = sdk::LightType::ambient;
    light.colour = {tint[0], tint[1], tint[2]};
    light.intensity = float(context.number(intensity));
    light.exposure = float(context.number(exposure));
    contribution.add(light);
  };
  plugin.add(type);
}

}  // namespace plinian::nodes
