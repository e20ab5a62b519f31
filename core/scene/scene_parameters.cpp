// The tables of scene keys.
#include "core/scene/scene_parameters.h"

namespace plinian {

using Range = ParameterRange;

const std::vector<Parameter<MediumDescription>>& medium_parameters() {
  using M = MediumDescription;
  static const std::vector<Parameter<M>> table = {
      parameter<&M::name>({.name = "name", .help = "what --set calls it"}),
      parameter<&M::volume>({.name = "volume", .help = "a .vdb file, a procedural medium, box or sphere"}),
      parameter<&M::grid>({.name = "grid", .help = "density grid: NAME, NAME[INDEX] or NAME[*] (their sum)"}),
      parameter<&M::temperature_grid>(
          {.name = "temperature_grid", .help = "grid of temperatures, or none; not given: found by name"}),
      parameter<&M::level_set>({.name = "level_set",
                                .help = "what to do with a level set: refuse, or fog (convert)",
                                .choices = {"refuse", "fog"}}),
      parameter<&M::frustum>({.name = "frustum",
                              .help = "what to do with a frustum transform: refuse, or resample",
                              .choices = {"refuse", "resample"}}),
      parameter<&M::resolution>({.name = "resolution",
                                 .range = Range::closed(16, 1024),
                                 .unit = "voxels",
                                 .help = "of a procedural medium's longest side"}),
      parameter<&M::seed>({.name = "seed", .range = Range::at_least(0), .help = "of a procedural medium"}),
      parameter<&M::up_axis>(
          {.name = "up_axis", .help = "which way is up in the file", .choices = {"y", "z"}}),
      parameter<&M::file_unit>({.name = "file_unit",
                                .range = Range::above(0),
                                .unit = "m",
                                .help = "length of one unit of the file"}),
      parameter<&M::rescale>({.name = "rescale",
                              .help = "what stays where file_unit or scale resizes a volume",
                              .choices = {"extinction", "optical_depth"}}),
      parameter<&M::translate>({.name = "translate", .unit = "m", .help = "placement in the world"}),
      parameter<&M::rotate>({.name = "rotate", .unit = "degrees", .help = "about x, then y, then z"}),
      parameter<&M::scale>({.name = "scale", .help = "size along x, y, z; negative mirrors", .grey = true}),
      parameter<&M::density_scale>({.name = "density_scale",
                                    .range = Range::at_least(0),
                                    .help = "factor on density; not given: median optical depth 12"}),
      parameter<&M::albedo>({.name = "albedo",
                             .range = Range::closed(0, 1),
                             .help = "share of the extinction that scatters",
                             .grey = true,
                             .excludes = {"sigma_s", "sigma_a"}}),
      parameter<&M::extinction>({.name = "extinction",
                                 .range = Range::at_least(0),
                                 .unit = "1/m",
                                 .help = "sigma_t colour at density * density_scale = 1",
                                 .grey = true,
                                 .excludes = {"sigma_s", "sigma_a"}}),
      parameter<&M::sigma_s>({.name = "sigma_s",
                              .range = Range::at_least(0),
                              .unit = "1/m",
                              .help = "scattering, instead of albedo and extinction",
                              .grey = true,
                              .excludes = {"albedo", "extinction"}}),
      parameter<&M::sigma_a>({.name = "sigma_a",
                              .range = Range::at_least(0),
                              .unit = "1/m",
                              .help = "absorption, instead of albedo and extinction",
                              .grey = true,
                              .excludes = {"albedo", "extinction"}}),
      parameter<&M::phase>({.name = "phase",
                            .help = "phase function; not given: henyey_greenstein where g is given",
                            .choices = {"isotropic", "henyey_greenstein", "schlick", "two_lobe"}}),
      parameter<&M::g>(
          {.name = "g", .range = Range::open(-1, 1), .help = "mean cosine; > 0 scatters forward"}),
      parameter<&M::g_back>({.name = "g_back", .range = Range::open(-1, 1), .help = "of the second lobe"}),
      parameter<&M::blend>(
          {.name = "blend", .range = Range::closed(0, 1), .help = "share of the second lobe"}),
      parameter<&M::emission_scale>(
          {.name = "emission_scale",
           .range = Range::at_least(0),
           .help = "radiance per length at density * density_scale = 1 and 1800 K"}),
      parameter<&M::emission_exposure>({.name = "emission_exposure",
                                        .range = Range::closed(-64, 64),
                                        .unit = "stops",
                                        .help = "on emission"}),
      parameter<&M::temperature_scale>(
          {.name = "temperature_scale",
           .range = Range::at_least(0),
           .unit = "K per unit of the grid",
           .help = "not given: 1, or a peak of 1800 K where the grid peaks under 100"}),
      parameter<&M::temperature_offset>({.name = "temperature_offset", .unit = "K", .help = "added to it"}),
  };
  return table;
}

const std::vector<Parameter<CameraDescription>>& camera_parameters() {
  using C = CameraDescription;
  static const std::vector<Parameter<C>> table = {
      parameter<&C::eye>(
          {.name = "eye", .unit = "m", .help = "where it stands", .excludes = {"translate", "rotate"}}),
      parameter<&C::target>({.name = "target",
                             .unit = "m",
                             .help = "what it looks at; not given: the middle of the media",
                             .excludes = {"translate", "rotate"}}),
      parameter<&C::up>({.name = "up", .help = "up in the picture, with eye", .excludes = {"rotate"}}),
      parameter<&C::translate>({.name = "translate",
                                .unit = "m",
                                .help = "as in Maya, instead of eye",
                                .excludes = {"eye", "target", "up"}}),
      parameter<&C::rotate>({.name = "rotate",
                             .unit = "degrees",
                             .help = "as in Maya: about x, then y, then z, instead of target",
                             .excludes = {"eye", "target", "up"}}),
      parameter<&C::fov_y_degrees>({.name = "fov_y_degrees",
                                    .range = Range::open(0, 180),
                                    .unit = "degrees",
                                    .help = "vertical field of view",
                                    .excludes = {"focal_length"}}),
      parameter<&C::focal_length>({.name = "focal_length",
                                   .range = Range::at_least(0.1),
                                   .unit = "mm",
                                   .help = "of the lens (35)",
                                   .excludes = {"fov_y_degrees"}}),
      parameter<&C::film_back>({.name = "film_back",
                                .range = Range::at_least(0.01),
                                .unit = "mm",
                                .help = "width, height (36,24)"}),
      parameter<&C::film_fit>({.name = "film_fit",
                               .help = "how the film meets a picture of another shape",
                               .choices = {"fill", "horizontal", "vertical", "overscan"}}),
      parameter<&C::film_offset>({.name = "film_offset", .unit = "mm", .help = "shift of the film"}),
      parameter<&C::pixel_aspect>({.name = "pixel_aspect",
                                   .range = Range::closed(0.01, 100),
                                   .help = "width of a pixel over its height"}),
      parameter<&C::near_clip>(
          {.name = "near_clip", .range = Range::at_least(0), .unit = "m", .help = "nothing nearer is seen"}),
      parameter<&C::azimuth>({.name = "azimuth",
                              .unit = "degrees",
                              .help = "from where a camera without eye looks: 0 from +z, 90 from +x"}),
      parameter<&C::elevation>({.name = "elevation",
                                .range = Range::closed(-90, 90),
                                .unit = "degrees",
                                .help = "likewise: 0 level, 90 from above"}),
  };
  return table;
}

const std::vector<Parameter<LightDescription>>& light_parameters() {
  using L = LightDescription;
  static const std::vector<Parameter<L>> table = {
      parameter<&L::name>({.name = "name", .help = "of its layer in the picture"}),
      parameter<&L::type>(
          {.name = "type", .help = "kind of light", .choices = {"directional", "spot", "point"}}),
      parameter<&L::toward>(
          {.name = "toward", .help = "points to the light: directional, spot", .excludes = {"target"}}),
      parameter<&L::position>({.name = "position", .unit = "m", .help = "of a spot or point light"}),
      parameter<&L::target>({.name = "target",
                             .unit = "m",
                             .help = "what a spot points at; not given: the middle of the media",
                             .excludes = {"toward"}}),
      parameter<&L::colour>({.name = "colour",
                             .range = Range::at_least(0),
                             .help = "linear Rec.709",
                             .grey = true,
                             .excludes = {"kelvin", "irradiance"}}),
      parameter<&L::kelvin>({.name = "kelvin",
                             .range = Range::closed(800, 40000),
                             .unit = "K",
                             .help = "colour of a black body of that temperature",
                             .excludes = {"colour", "irradiance"}}),
      parameter<&L::intensity>({.name = "intensity",
                                .range = Range::at_least(0),
                                .help = "irradiance facing the light; of a spot or point at distance 1",
                                .excludes = {"irradiance"}}),
      parameter<&L::irradiance>({.name = "irradiance",
                                 .range = Range::at_least(0),
                                 .help = "intensity and colour in one",
                                 .grey = true,
                                 .excludes = {"intensity", "colour", "kelvin"}}),
      parameter<&L::exposure>({.name = "exposure",
                               .range = Range::closed(-64, 64),
                               .unit = "stops",
                               .help = "intensity is multiplied by 2^exposure"}),
      parameter<&L::falloff>({.name = "falloff",
                              .help = "with distance, of a spot or point",
                              .choices = {"inverse_square", "linear", "none"}}),
      parameter<&L::radius>({.name = "radius",
                             .range = Range::at_least(0),
                             .unit = "m",
                             .help = "falloff stops growing inside it"}),
      parameter<&L::cone_angle>({.name = "cone_angle",
                                 .range = Range::open(0, 180),
                                 .unit = "degrees",
                                 .help = "full angle of a spot"}),
      parameter<&L::penumbra>({.name = "penumbra",
                               .range = Range::closed(0, 90),
                               .unit = "degrees",
                               .help = "soft edge inside a spot's cone"}),
  };
  return table;
}

const std::vector<Parameter<SceneDescription>>& scene_parameters() {
  using S = SceneDescription;
  static const std::vector<Parameter<S>> table = {
      parameter<&S::ambient>({.name = "ambient",
                              .range = Range::at_least(0),
                              .unit = "radiance",
                              .help = "light from everywhere, scattered without shadow",
                              .grey = true}),
      parameter<&S::background>({.name = "background",
                                 .range = Range::at_least(0),
                                 .unit = "radiance",
                                 .help = "constant sky behind the media",
                                 .grey = true}),
  };
  return table;
}

}  // namespace plinian
