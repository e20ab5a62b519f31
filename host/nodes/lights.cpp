// The node types "directionalLight", "spotLight" and "pointLight".
//
// attribute            unit
// translate, rotate    as of a transform; a light shines along its -z, as in Maya
// colour, kelvin       linear Rec.709, or K where use_kelvin is on
// intensity            irradiance facing the light; of a spot or point at 1 m
// exposure             stops on intensity
// falloff, radius      of a spot or point: how irradiance falls with distance, and from where on (m)
// cone_angle, penumbra degrees, of a spot
#include "core/lights/light.h"
#include "core/media/blackbody.h"
#include "core/scene/scene_parameters.h"
#include "host/nodes/core_attributes.h"
#include "host/nodes/node_types.h"
#include "host/nodes/placement_attributes.h"

namespace plinian::nodes {

namespace {

using sdk::Attribute;

void add_light(sdk::Plugin& plugin, const char* name, const char* help, LightType kind) {
  sdk::NodeType type(name);
  type.help = help;
  const plinian::Light usual;
  const auto& parameters = light_parameters();
  const PlacementAttributes placement(type);
  const auto add = [&](const char* parameter, AttributeTouch touch) {
    return type.add(attribute_of(parameters, parameter, std::move(touch)));
  };
  const Attribute use_kelvin = type.add({.name = "use_kelvin",
                                         .type = "bool",
                                         .help = "The colour is that of a black body.",
                                         .group = "Light"});
  const Attribute colour =
      add("colour", {.default_value = "1 1 1", .group = "Light", .shown_when = "use_kelvin=false"});
  const Attribute kelvin = add("kelvin", {.default_value = "6500",
                                          .group = "Light",
                                          .shown_when = "use_kelvin=true",
                                          .soft_minimum = 1500,
                                          .soft_maximum = 12000});
  const Attribute intensity = add("intensity", {.default_value = "1", .group = "Light", .soft_maximum = 20});
  const Attribute exposure = add("exposure", {.group = "Light", .soft_minimum = -8, .soft_maximum = 8});
  Attribute falloff, radius, cone_angle, penumbra;
  if (kind != LightType::directional) {
    falloff = add("falloff", {.group = "Light"});
    radius = add("radius", {.group = "Light", .soft_maximum = 5});
  }
  if (kind == LightType::spot) {
    cone_angle = add("cone_angle", {.default_value = spelled(usual.cone_angle), .group = "Cone"});
    penumbra = add("penumbra", {.default_value = spelled(usual.penumbra), .group = "Cone"});
  }
  type.contribute = [=](sdk::Context& context, sdk::Contribution& contribution) {
    const auto number = [&](Attribute a) { return float(context.number(a)); };
    const vec3 tint =
        context.number(use_kelvin) != 0.0 ? planck_colour(number(kelvin)) : to_vec3(context.vector(colour));
    sdk::Light light;
    light.type = sdk::LightType(int(kind));
    light.colour = {tint.x, tint.y, tint.z};
    light.intensity = number(intensity);
    light.exposure = number(exposure);
    if (kind != LightType::directional) {
      light.falloff = sdk::Falloff(int(context.number(falloff)));
      light.radius = number(radius);
    }
    if (kind == LightType::spot) {
      light.cone_angle = number(cone_angle);
      light.penumbra = number(penumbra);
    }
    contribution.add(light);
  };
  plugin.add(type);
}

}  // namespace

void add_lights(sdk::Plugin& plugin) {
  add_light(plugin, "directionalLight", "Light from far away, as of the sun; it shines along its -z.",
            LightType::directional);
  add_light(plugin, "spotLight", "A lamp with a cone, that shines along its -z.", LightType::spot);
  add_light(plugin, "pointLight", "A lamp that shines every way.", LightType::point);
}

}  // namespace plinian::nodes
