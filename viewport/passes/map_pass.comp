// Builds the texels of one transmittance map: see core/shared/light_march.h.
#include "viewport/passes/scene_access.glsl"
#include "core/shared/light_march.h"

layout(local_size_x = 16, local_size_y = 16) in;

layout(rgba32ui, binding = 0) writeonly uniform uimageBuffer u_texels;
layout(std140, binding = 3) uniform EncodeBlock {
  ivec4 u_encode_ints;    // adaptive, veil proof, end zero, refine steps
  vec4 u_encode_floats;   // kmin transmittance, threshold, 1 / weighting, step [voxels]
};
layout(location = 0) uniform int u_map;
layout(location = 1) uniform ivec2 u_first;  // texel of the first invocation

void main() {
  const int scene = 0;
  copy_scene();
  ivec2 texel = u_first + spread_group(gl_WorkGroupID.xy) * 16 + ivec2(gl_LocalInvocationID.xy);
  if (texel.x >= MAP_RESOLUTION || texel.y >= MAP_RESOLUTION) return;
  vec2 uv = (vec2(texel) + 0.5) / float(MAP_RESOLUTION);
  EncodeControls controls = EncodeControls(MAP_COEFFICIENTS, u_encode_ints.x, u_encode_ints.y, u_encode_ints.z,
                                           u_encode_floats.x, u_encode_floats.y, u_encode_floats.z,
                                           u_encode_floats.w, u_encode_ints.w);
  float c[16];
  uint bounds = encode_texel(scene, map_ray_origin(scene, u_map, uv), map_ray_direction(scene, u_map, uv),
                             MAP(u_map).group, MAP(u_map).k_max, controls, c);
  int words = MAP_COEFFICIENTS > 6 ? (MAP_COEFFICIENTS > 14 ? 3 : 2) : 1;
  int place = ((MAP(u_map).layer * MAP_RESOLUTION + texel.y) * MAP_RESOLUTION + texel.x) * words;
  imageStore(u_texels, place,
             uvec4(packHalf2x16(vec2(c[0], c[1])), packHalf2x16(vec2(c[2], c[3])), packHalf2x16(vec2(c[4], c[5])), bounds));
#if MAP_COEFFICIENTS > 6
  imageStore(u_texels, place + 1,
             uvec4(packHalf2x16(vec2(c[6], c[7])), packHalf2x16(vec2(c[8], c[9])), packHalf2x16(vec2(c[10], c[11])),
                   packHalf2x16(vec2(c[12], c[13]))));
#endif
#if MAP_COEFFICIENTS > 14
  imageStore(u_texels, place + 2, uvec4(packHalf2x16(vec2(c[14], c[15])), 0u, 0u, 0u));
#endif
}
