// One texel of a transmittance map, marched on the CPU and packed as the marches read it.
#pragma once

#include "core/integrate/flat_scene.h"

namespace plinian {

/// Marches the light ray of a texel and writes its words_per_texel() words. scene: view_of(flat, ...); map:
/// of flat.maps.
void write_map_texel(const FlatScene& flat, const MarchScene& scene, int map, ivec2 texel, uvec4* words);

}  // namespace plinian
