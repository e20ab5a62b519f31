// The table of quality parameters.
#include "core/scene/quality_parameters.h"

namespace plinian {

namespace {

template <auto Field>
Parameter<Quality> map(ParameterSpec spec) {
  spec.name = "map." + spec.name;
  return parameter<&Quality::map, Field>(std::move(spec));
}

template <auto Field>
Parameter<Quality> view(ParameterSpec spec) {
  spec.name = "view." + spec.name;
  return parameter<&Quality::view, Field>(std::move(spec));
}

}  // namespace

const std::vector<Parameter<Quality>>& quality_parameters() {
  using Range = ParameterRange;
  static const std::vector<Parameter<Quality>> table = {
      map<&MapQuality::encoding>({.name = "encoding",
                                  .help = "cosine series over the whole light ray (tfm) or over the range "
                                          "in which light dies (atfm)",
                                  .choices = {"tfm", "atfm"}}),
      map<&MapQuality::coefficients>(
          {.name = "coefficients", .range = Range::closed(2, 16), .help = "cosine terms per texel"}),
      map<&MapQuality::threshold>({.name = "threshold",
                                   .range = Range::open(0, 1),
                                   .help = "transmittance under which a light ray counts as dead"}),
      map<&MapQuality::kmin_rule>({.name = "kmin_rule",
                                   .help = "where an adaptive range begins: at the first density, as "
                                           "published, or where light begins to die",
                                   .choices = {"first_density", "veil_proof"}}),
      map<&MapQuality::kmin_transmittance>(
          {.name = "kmin_transmittance",
           .range = Range::above_to(0, 1),
           .help = "transmittance under which veil_proof lets the range begin"}),
      map<&MapQuality::end_rule>({.name = "end_rule",
                                  .help = "behind a dense range: no light, or the last value of the series",
                                  .choices = {"zero", "last_value"}}),
      map<&MapQuality::density_weighting>({.name = "density_weighting",
                                           .range = Range::closed(1, 100),
                                           .help = "w: the map stores T^(1/w); 1 turns it off"}),
      map<&MapQuality::resolution>({.name = "resolution",
                                    .range = Range::closed(16, 8192),
                                    .unit = "texels",
                                    .help = "side of a light's view"}),
      map<&MapQuality::detect_step>({.name = "detect_step",
                                     .range = Range::closed(0.05, 64),
                                     .unit = "voxels",
                                     .help = "step of the march that finds the range"}),
      map<&MapQuality::refine_steps>({.name = "refine_steps",
                                      .range = Range::closed(4, 4096),
                                      .help = "samples of the march that fills the range"}),
      view<&ViewQuality::shade_samples>({.name = "shade_samples",
                                         .range = Range::closed(1, 1024),
                                         .help = "light lookups along an opaque view ray, placed at equal "
                                                 "opacity"}),
      view<&ViewQuality::step>({.name = "step",
                                .range = Range::closed(0.05, 64),
                                .unit = "voxels",
                                .help = "between density samples along a view ray"}),
      view<&ViewQuality::transmittance_cutoff>(
          {.name = "transmittance_cutoff",
           .range = Range::closed(0, 0.5),
           .help = "a view ray ends where no more than this shines through"}),
      view<&ViewQuality::passes>({.name = "passes",
                                  .range = Range::closed(1, 65536),
                                  .help = "jittered passes of a picture at most"}),
      view<&ViewQuality::rest_change>(
          {.name = "rest_change",
           .range = Range::closed(0, 255),
           .unit = "8-bit steps",
           .help = "a picture is done where the mean change still to come is no more than this; 0: after all "
                   "passes"}),
      view<&ViewQuality::exact_light_at_rest>(
          {.name = "exact_light_at_rest",
           .help = "further passes at rest march to the light instead of reading the map"}),
      view<&ViewQuality::light>(
          {.name = "light",
           .help = "where light comes from: transmittance maps, or a march to the light from "
                   "every shading point; error: no light, but how far the one is from the other",
           .choices = {"map", "march", "error"}}),
      view<&ViewQuality::march_step>({.name = "march_step",
                                      .range = Range::closed(0.05, 64),
                                      .unit = "voxels",
                                      .help = "step of a marched light ray"}),
      view<&ViewQuality::march_depth>({.name = "march_depth",
                                       .range = Range::closed(0.1, 100),
                                       .help = "optical depth at which a marched light ray ends"}),
  };
  return table;
}

}  // namespace plinian
