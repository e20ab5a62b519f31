// What a transmittance map depends on, and so the only reasons for building it again: density field,
// transform, extinction beyond a tolerance, light frame, encoding, resolution. Albedo, phase function and the
// colour of a light are not among them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/integrate/flat_scene.h"

namespace plinian {

struct MapKey {
  struct MediumPart {
    const BrickVolume* volume;  // identity; whoever keeps a key keeps the volume
    vec4 local_from_world_x, local_from_world_y, local_from_world_z;
    int shape;
    float sigma_group;  // [1/world]
  };
  std::vector<MediumPart> media;  // of the map's colour group
  MapData frame;                  // exponent and layer do not count
  shared::EncodeControls encode;
  int resolution = 0;
};

/// The key of map number `map` of a scene.
MapKey map_key(const FlatScene& scene, int map);

/// Why a map built for `built` does not serve `wanted`; empty where it does. Extinction may differ by a share
/// of 1e-4: rounding, as when albedo changes while their sum stays.
std::string rebuild_reason(const MapKey& built, const MapKey& wanted);

/// To what power [-] T of a map built for `built` is T of `wanted`: 1 where it serves as it is; none where it
/// has to be built again. A map serves where all extinctions are as many times its own, between 1/reuse and
/// reuse times [TFM11 eq. 14].
/// Biased: the range of the series does not fit how light fades now. What it left out behind its threshold
/// stays out, of which a power under 1 makes more. Of ash, twice or half as dense, 38 dB are left of the 46
/// that a map of its own has against the picture at rest; SSIM falls from 0.998 to 0.993.
std::optional<float> map_power(const MapKey& built, const MapKey& wanted, float reuse);

}  // namespace plinian
