// The kinds of procedural media: their names, parameters, looks, and how a volume is made of one.
#include "core/media/procedural.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/media/procedural/kinds.h"

namespace plinian {
namespace {

using procedural::ShapeSettings;

constexpr int least_resolution = 16, largest_resolution = 1024;  // [voxels]
constexpr double side = 10.0;                                    // [world units] of the unit cube

struct Parameter {
  const char* name;
  float ShapeSettings::*value;
  float low, high;  // [-]
  const char* help;
};

constexpr Parameter billow_size = {"billow_size", &ShapeSettings::billow_size, 0.6f, 1.4f,
                                   "lobes over their usual size"};
constexpr Parameter displacement = {
    "displacement", &ShapeSettings::displacement, 0.0f, 1.5f,
    "how far lobes stand out, and how deep their crevices are, over the usual"};
constexpr Parameter sharpness = {"sharpness", &ShapeSettings::sharpness, 0.25f, 2.0f,
                                 "steepness of the edge: at 1 it rises from 10 to 90% within two voxels"};
constexpr Parameter veils = {"veils", &ShapeSettings::veils, 0.0f, 4.0f,
                             "density of the thin veils over the usual"};
constexpr Parameter heat = {"heat", &ShapeSettings::heat, 0.0f, 1.5f, "temperatures over the usual"};
constexpr Parameter umbrella = {"spread", &ShapeSettings::spread, 0.3f, 1.5f,
                                "width of the umbrella over the usual"};
constexpr Parameter width = {"spread", &ShapeSettings::spread, 0.5f, 1.5f, "width over the usual"};
constexpr Parameter wind = {"lean", &ShapeSettings::lean, -2.0f, 3.0f, "lean downwind over the usual"};
constexpr Parameter nose = {"lean", &ShapeSettings::lean, 0.0f, 2.0f, "overhang of the front over the usual"};

constexpr Parameter ash_parameters[] = {billow_size, displacement, sharpness, umbrella, wind, veils, heat};
constexpr Parameter cloud_parameters[] = {billow_size, displacement, sharpness, width, veils};
constexpr Parameter sandstorm_parameters[] = {billow_size, displacement, sharpness, nose, veils};
constexpr Parameter explosion_parameters[] = {billow_size, displacement, sharpness, width, heat};

struct Kind {
  const char* name;
  std::uint32_t first_seed;  // what seed 1 stands for: the composition that shows the kind best
  std::unique_ptr<procedural::Shape> (*make)(const ShapeSettings&);
  std::span<const Parameter> parameters;
  float density_scale;  // [1/world unit]
  vec3 albedo;          // [-]
  Phase phase;
  float emission_scale;
};

const Kind kinds[] = {
    {"ash",
     3,
     procedural::make_ash,
     ash_parameters,
     68.0f,
     {0.62f, 0.55f, 0.475f},
     {PhaseKind::two_lobe, 0.35f, -0.2f, 0.5f},
     6.0f},
    {"cloud",
     1,
     procedural::make_cloud,
     cloud_parameters,
     40.0f,
     {0.99f, 0.99f, 0.99f},
     {PhaseKind::two_lobe, 0.6f, -0.25f, 0.55f},
     0.0f},
    {"sandstorm",
     4,
     procedural::make_sandstorm,
     sandstorm_parameters,
     45.0f,
     {0.85f, 0.66f, 0.42f},
     {PhaseKind::two_lobe, 0.4f, -0.2f, 0.5f},
     0.0f},
    {"explosion",
     1,
     procedural::make_explosion,
     explosion_parameters,
     55.0f,
     {0.32f, 0.29f, 0.26f},
     {PhaseKind::two_lobe, 0.35f, -0.2f, 0.5f},
     4.0f},
};

const Kind& find_kind(const std::string& name) {
  const auto found = std::ranges::find(kinds, name, &Kind::name);
  if (found != std::end(kinds)) return *found;
  throw std::runtime_error(
      fmt::format("{}: no such procedural medium; there are: {}", name, fmt::join(procedural_kinds(), ", ")));
}

ShapeSettings checked(const Kind& kind, const ProceduralSettings& settings) {
  if (settings.resolution < least_resolution || settings.resolution > largest_resolution)
    throw std::runtime_error(fmt::format("{}: resolution {} is not in [{}, {}]", kind.name,
                                         settings.resolution, least_resolution, largest_resolution));
  ShapeSettings shape;
  shape.resolution = settings.resolution;
  shape.seed = settings.seed - 1u + kind.first_seed;
  for (const auto& [name, value] : settings.shape) {
    const auto found = std::ranges::find(kind.parameters, name, [](const Parameter& p) { return p.name; });
    if (found == kind.parameters.end()) {
      std::vector<std::string> names;
      for (const Parameter& p : kind.parameters) names.push_back(p.name);
      throw std::runtime_error(
          fmt::format("{}: no parameter '{}'; there are: {}", kind.name, name, fmt::join(names, ", ")));
    }
    if (!(value >= found->low && value <= found->high))  // NaN is refused too
      throw std::runtime_error(
          fmt::format("{}: {} {} is not in [{}, {}]", kind.name, name, value, found->low, found->high));
    shape.*(found->value) = value;
  }
  return shape;
}

}  // namespace

std::vector<std::string> procedural_kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.push_back(kind.name);
  return names;
}

std::vector<ProceduralParameter> procedural_parameters(const std::string& kind) {
  std::vector<ProceduralParameter> parameters;
  const ShapeSettings usual;
  for (const Parameter& p : find_kind(kind).parameters)
    parameters.push_back({p.name, usual.*(p.value), p.low, p.high, "-", p.help});
  return parameters;
}

ProceduralLook procedural_look(const std::string& name) {
  const Kind& kind = find_kind(name);
  ProceduralLook look;
  look.density_scale = kind.density_scale;
  look.sigma_s = kind.albedo;
  look.sigma_a = 1.0f - kind.albedo;
  look.phase = kind.phase;
  look.emission.scale = kind.emission_scale;
  return look;
}

std::shared_ptr<const BrickVolume> make_procedural(const ProceduralSettings& settings,
                                                   const ProceduralProgress& progress) {
  const Kind& kind = find_kind(settings.kind);
  const ShapeSettings shape_settings = checked(kind, settings);
  const std::unique_ptr<procedural::Shape> shape = kind.make(shape_settings);
  BrickVolumeBuilder builder;
  if (procedural::voxelise(*shape, settings.resolution, builder, progress).cancelled)
    throw ProceduralCancelled();
  const double voxel = side / settings.resolution;
  dmat4 medium_from_index(voxel);
  medium_from_index[3] = {0.5 * voxel - 0.5 * side, 0.5 * voxel, 0.5 * voxel - 0.5 * side, 1.0};
  return std::make_shared<const BrickVolume>(builder.build(medium_from_index));
}

void wear_look(const ProceduralLook& look, Medium& medium) {
  medium.density_scale = look.density_scale;
  medium.sigma_s = look.sigma_s;
  medium.sigma_a = look.sigma_a;
  medium.phase = look.phase;
  medium.emission = look.emission;
}

Medium procedural_medium(const ProceduralSettings& settings, const ProceduralProgress& progress) {
  const ProceduralLook look = procedural_look(settings.kind);
  Medium medium;
  medium.name = settings.kind;
  medium.volume = make_procedural(settings, progress);
  wear_look(look, medium);
  return medium;
}

}  // namespace plinian
