// The node type "medium": how a volume takes up and gives off light.
//
// attribute                         unit
// density_scale                     1 / unit of the volume
// coefficients                      which two say it: albedo and extinction, or sigma_s and sigma_a
// albedo, extinction                -, 1/m where density * density_scale is 1
// sigma_s, sigma_a                  1/m, likewise
// phase, g, g_back, blend           -
// emission_scale, emission_exposure radiance per length at 1800 K, stops
// temperature_scale, _offset        K per stored kelvin, K
// look, look_hash                   the look that was last put on, and what it said then
// out                               for the shape that draws the volume
//
// Ranges, units and help are those of core/scene/scene_parameters.h.
#include "core/media/medium.h"

#include "core/scene/scene_parameters.h"
#include "host/nodes/core_attributes.h"
#include "host/nodes/node_types.h"

namespace plinian::nodes {

namespace {

using sdk::Attribute;

sdk::Colour to_colour(vec3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace

void add_medium(sdk::Plugin& plugin) {
  sdk::NodeType type("medium");
  type.help = "How a volume takes up, scatters and gives off light.";
  const plinian::Medium usual;
  const auto& parameters = medium_parameters();
  const auto add = [&](const char* name, AttributeTouch touch) {
    touch.affects = "out";
    return type.add(attribute_of(parameters, name, std::move(touch)));
  };
  const Attribute density_scale = add("density_scale", {.default_value = "1",
                                                        .help = "Factor on density.",
                                                        .soft_minimum = 0.01,
                                                        .soft_maximum = 1000,
                                                        .widget = "factor"});
  const Attribute coefficients = type.add(
      {.name = "coefficients",
       .type = "enum",
       .help = "Which two colours say what happens to light: albedo and extinction, or scattering and "
               "absorption.",
       .group = "Scattering",
       .choices = "albedo_extinction,sigma",
       .affects = "out"});
  const char* const by_albedo = "coefficients=albedo_extinction";
  const char* const by_sigma = "coefficients=sigma";
  const Attribute albedo =
      add("albedo", {.default_value = "0.8 0.8 0.8", .group = "Scattering", .shown_when = by_albedo});
  const Attribute extinction =
      add("extinction",
          {.default_value = "1 1 1", .group = "Scattering", .shown_when = by_albedo, .soft_maximum = 10});
  const Attribute sigma_s = add("sigma_s", {.default_value = spelled(usual.sigma_s),
                                            .help = "Scattering.",
                                            .group = "Scattering",
                                            .shown_when = by_sigma,
                                            .soft_maximum = 10});
  const Attribute sigma_a = add("sigma_a", {.default_value = spelled(usual.sigma_a),
                                            .help = "Absorption.",
                                            .group = "Scattering",
                                            .shown_when = by_sigma,
                                            .soft_maximum = 10});
  const Attribute phase = add("phase", {.help = "Which way light is scattered.", .group = "Phase Function"});
  const char* const has_lobe = "phase=henyey_greenstein,schlick,two_lobe";
  const Attribute g = add("g", {.group = "Phase Function", .shown_when = has_lobe});
  const Attribute g_back = add("g_back", {.group = "Phase Function", .shown_when = "phase=two_lobe"});
  const Attribute blend = add("blend", {.group = "Phase Function", .shown_when = "phase=two_lobe"});
  const Attribute emission_scale = add("emission_scale", {.group = "Emission", .soft_maximum = 10});
  const Attribute emission_exposure =
      add("emission_exposure", {.group = "Emission", .soft_minimum = -8, .soft_maximum = 8});
  // Volumes hold kelvins; what a unit of the file is was settled when it was read.
  sdk::AttributeSpec scale = attribute_of(parameters, "temperature_scale",
                                          {.default_value = "1",
                                           .help = "Factor on the volume's temperature.",
                                           .group = "Emission",
                                           .affects = "out",
                                           .soft_maximum = 4});
  scale.unit = "K/K";
  const Attribute temperature_scale = type.add(scale);
  const Attribute temperature_offset =
      add("temperature_offset", {.group = "Emission", .soft_minimum = 0, .soft_maximum = 2000});
  for (const char* name : {"look", "look_hash"})
    type.add({.name = name,
              .type = "string",
              .help = name == std::string("look") ? "The look that was put on last."
                                                  : "What that look said then, as a number.",
              .group = "Look",
              .hidden = name == std::string("look_hash"),
              .keyable = false,
              .widget = name == std::string("look") ? "look" : ""});
  const Attribute out = type.add({.name = "out",
                                  .type = "data",
                                  .help = "For the shape that draws the volume.",
                                  .data_type = PLINIAN_MEDIUM_TYPE,
                                  .output = true});
  type.compute = [=](sdk::Context& context, Attribute) {
    const auto number = [&](Attribute a) { return float(context.number(a)); };
    const auto colour = [&](Attribute a) { return to_vec3(context.vector(a)); };
    sdk::Medium look;
    look.density_scale = number(density_scale);
    if (context.number(coefficients) == 0.0) {
      const vec3 share = colour(albedo), all = colour(extinction);
      look.sigma_s = to_colour(all * share);
      look.sigma_a = to_colour(all * (vec3(1.0f) - share));
    } else {
      look.sigma_s = to_colour(colour(sigma_s));
      look.sigma_a = to_colour(colour(sigma_a));
    }
    look.phase = sdk::PhaseKind(int(context.number(phase)));
    look.g = number(g);
    look.g_back = number(g_back);
    look.blend = number(blend);
    look.emission_scale = number(emission_scale);
    look.emission_exposure = number(emission_exposure);
    look.temperature_scale = number(temperature_scale);
    look.temperature_offset = number(temperature_offset);
    sdk::set_look(context, out, look, 0);  // known by what it was computed from
  };
  plugin.add(type);
}

}  // namespace plinian::nodes
