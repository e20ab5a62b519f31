// One jittered pass of the view march, added to what earlier passes gathered: see core/shared/view_march.h.
// Defines expected, beside those of scene_access.glsl: EMISSIVE_MEDIA, VARIED_LIGHT, LIGHT_MARCH, LIGHT_ERROR,
// LIGHT_MARCH_STEP, LIGHT_MARCH_DEPTH, PLANE_AMBIENT, PLANE_EMISSION, PLANE_LIGHTS.
#include "viewport/passes/scene_access.glsl"
#include "core/shared/pass_weight.h"
#include "core/shared/view_march.h"

layout(local_size_x = 16, local_size_y = 16) in;

// Layers: 0 transmittance and depth, PLANE_AMBIENT, PLANE_EMISSION (-1: none), PLANE_LIGHTS + l light l. Sums over
// passes, depth of the first.
layout(rgba32f, binding = 0) uniform image2DArray u_sums;
layout(std140, binding = 3) uniform ViewBlock {
  vec4 u_origin;    // [world] of the camera; w: near clip [world]
  vec4 u_forward;   // see CameraRays
  vec4 u_right;
  vec4 u_up;
  vec4 u_controls;  // quantum, step [voxels], cutoff, 0
  ivec4 u_frame;    // width, height, number of this pass, 1 where it is the first in u_sums
  ivec2 u_end;      // behind the last pixel to be rendered
};
layout(location = 0) uniform ivec2 u_first;  // pixel of the first invocation

void add_plane(ivec2 pixel, int plane, vec4 value) {
  if (u_frame.w == 0) {
    vec4 before = imageLoad(u_sums, ivec3(pixel, plane));
    value = vec4(before.xyz + value.xyz, before.w);
  }
  imageStore(u_sums, ivec3(pixel, plane), value);
}

void main() {
  const int scene = 0;
  copy_scene();
  // Lanes side by side make a block of 4 x 2 pixels: rays of a SIMD group stay close in both directions.
  int lane = int(gl_LocalInvocationIndex);
  ivec2 inside = ivec2((lane & 3) | ((lane >> 1) & 12), ((lane >> 2) & 1) | ((lane >> 4) & 14));
  ivec2 pixel = u_first + spread_group(gl_WorkGroupID.xy) * 16 + inside;
  if (pixel.x >= u_end.x || pixel.y >= u_end.y) return;
  vec3 direction = pixel_direction(u_forward.xyz, u_right.xyz, u_up.xyz, pixel, u_frame.xy);
  ViewControls controls = view_controls(pixel, u_frame.z, u_controls.x, u_controls.y, u_controls.z);
  ViewResult result = march_view(scene, u_origin.xyz, direction, u_origin.w, controls);

  float weight = pass_weight(u_frame.z);
  add_plane(pixel, 0, vec4(weight * result.transmittance, result.depth));
  if (PLANE_AMBIENT >= 0) add_plane(pixel, PLANE_AMBIENT, vec4(weight * result.ambient, 0.0));
  if (PLANE_EMISSION >= 0) add_plane(pixel, PLANE_EMISSION, vec4(weight * result.emission, 0.0));
  FOR_LIGHTS add_plane(pixel, PLANE_LIGHTS + l, vec4(weight * result.light[l], 0.0));
}
