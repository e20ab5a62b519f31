// Procedural media: ash, cloud, sandstorm, explosion. Each fills the unit cube of its object space, stands on
// the ground y = 0, +y up, and becomes a sparse volume 10 world units (metres) wide without ever being dense.
//
// Deterministic: the same settings give the same bytes on every run and with any number of threads. Features
// stay where they are when the resolution changes; a finer one adds smaller lobes and a sharper edge.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/media/medium.h"

namespace plinian {

/// Names of the procedural media, the default scene's first.
std::vector<std::string> procedural_kinds();

/// One number that shapes a kind.
struct ProceduralParameter {
  std::string name;
  float default_value, low, high;  // [unit]
  std::string unit;                // "-": none
  std::string help;
};

/// The shape parameters of a kind. Throws std::runtime_error on an unknown kind, naming those there are.
std::vector<ProceduralParameter> procedural_parameters(const std::string& kind);

struct ProceduralSettings {
  std::string kind = "ash";
  int resolution = 256;                // [voxels] along a side of the cube, in [16, 1024]
  std::uint32_t seed = 1;              // [-] another one of the same kind
  std::map<std::string, float> shape;  // shape parameters that are not at their default
};

/// Called with a share of the work done in [0, 1], from any thread but never from two at once; returning
/// false cancels.
using ProceduralProgress = std::function<bool(double)>;

/// Thrown by make_procedural() when its progress returned false.
struct ProceduralCancelled : std::runtime_error {
  ProceduralCancelled() : std::runtime_error("cancelled") {}
};

/// The optical properties that a kind is meant to be seen with, sigma_s + sigma_a = 1.
struct ProceduralLook {
  float density_scale = 1.0f;         // [1/world unit] extinction where density is 1
  vec3 sigma_s{0.8f}, sigma_a{0.2f};  // [1/world unit] albedo and its complement
  Phase phase;
  Emission emission;
};

/// Throws std::runtime_error on an unknown kind.
ProceduralLook procedural_look(const std::string& kind);

/// Gives a medium a look; its volume and place stay.
void wear_look(const ProceduralLook& look, Medium& medium);

/// Makes the volume: density in [0, 1] without unit, temperature [K] where the kind is hot; its index space
/// is centred on the y axis with cubic voxels of 10 / resolution world units. Throws std::runtime_error on an
/// unknown kind or parameter, or on a value out of its range.
std::shared_ptr<const BrickVolume> make_procedural(const ProceduralSettings& settings,
                                                   const ProceduralProgress& progress = {});

/// The volume with its look. Throws as make_procedural().
Medium procedural_medium(const ProceduralSettings& settings, const ProceduralProgress& progress = {});

}  // namespace plinian
