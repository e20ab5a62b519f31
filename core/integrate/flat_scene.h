// A SceneSnapshot made flat: the structs that the shared marches read, and what of it asks for which code.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/scene/snapshot.h"
#include "core/shared/light_march.h"
#include "core/shared/scene_data.h"

namespace plinian {

/// What steers the view march; see ViewQuality.
struct FlatView {
  float quantum;  // [-]
  float step;     // [voxels]
  float cutoff;   // [-]
  LightLookup light;
  float march_step;   // [voxels]
  float march_depth;  // [-]
};

/// Owns what a MarchScene looks at, except for the map texels.
struct FlatScene {
  std::vector<MediumData> media;
  std::vector<std::shared_ptr<const BrickVolume>> volumes;  // one per medium; null for analytic shapes
  std::vector<LightData> lights;
  std::vector<MapData> maps;  // per light, colour group, face
  int group_count = 0;
  bool grey = true;       // every medium's extinction is the same in all channels
  bool analytic = false;  // a box or a sphere is among the media
  bool emissive = false;
  bool varied_light = false;  // hazes or lamps: light varies along a ray where little opacity is gained
  shared::EncodeControls encode{};
  float extinction_reuse = 1.0f;  // see SceneSnapshot
  MapLayout layout;
  FlatView view{};
};

/// Flattens a snapshot. Media without density are left out. Throws std::runtime_error where the scene has
/// more media or maps than the marches hold, naming the number.
FlatScene flatten(const SceneSnapshot& scene);

/// The scene cut into parts that one march holds: each has at most max_lights lights and max_maps maps,
/// counted from zero; media and all else are the same. Where the error of maps is asked for, every light is
/// alone, as in exact_batches().
std::vector<FlatScene> light_batches(const FlatScene& scene);

/// The same scene with one of its lights alone.
FlatScene light_alone(const FlatScene& scene, std::size_t light);

/// The same scene with every light alone and marched instead of read from maps: what approaches the
/// reference. One light at a time keeps nested marches within what a shader may iterate.
std::vector<FlatScene> exact_batches(const FlatScene& scene);

/// Views into `flat`; texels are the maps', in the layout of cosine_texel.h.
struct MarchViews {
  std::vector<const BrickVolume*> volumes;
  MarchScene scene;
};
MarchViews view_of(const FlatScene& flat, const uvec4* texels);

}  // namespace plinian
