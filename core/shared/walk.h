// Walking a ray through the media: from one stretch with density to the next, leaping over empty bricks.
//
// A walk yields segments [t, t_b] on which every medium's density is taken as linear between its values at
// the two ends. Biased: inside a voxel the true density along a ray is a cubic; the error falls with the
// square of the step. Two kinds of place would fall with the step itself, and make a first picture some 5%
// too bright: edges, where density begins inside a segment (see density_onset), and what is opaque within a
// voxel (see walk_advance). Values of density are relative ("stored"): MediumData::sigma_t is what a stored 1
// means.
#ifndef PLINIAN_SHARED_WALK_H
#define PLINIAN_SHARED_WALK_H
#include "core/shared/scene_access.h"
PLN_BEGIN

/// Segments of more optical depth than this are cut shorter, but not under this length.
PLN_CONST float steep_segment = 0.1f;     // [-]
PLN_CONST float shortest_segment = 0.3f;  // [voxels]

/// Walk::steep for light that has gathered tau [-] of optical depth: what little is left may be followed more
/// coarsely.
PLN_FN float steep_at(float tau) {
  return steep_segment * min(exp(tau), 10.0f);
}

/// A ray in the own space of one medium; t is the same as in world space. For voxels the origin is that of
/// the index tree's root, so that coordinates inside are never negative.
struct LocalRay {
  vec3 origin;
  vec3 direction;
  vec3 inverse;   // 1 / direction, finite
  float t_enter;  // interval in which the medium may have density; enter > leave where it is missed
  float t_leave;
  float per_step;  // [world] length of a step of one voxel; 1e30 where density is constant
};

struct Walk {
  LocalRay rays[MEDIA_CAPACITY];
  float a[MEDIA_CAPACITY];            // stored density at t
  float b[MEDIA_CAPACITY];            // stored density at t_b
  float empty_until[MEDIA_CAPACITY];  // [t] the medium is known to be empty up to here
  float t;
  float t_b;
  float t_end;     // the last medium is left here
  float spacing;   // [world] of the sampling points
  float shortest;  // [world] segments are not cut shorter
  float steep;     // [-] segments of more optical depth are; a march may raise it as its end draws near
  float comb;      // [t] the sampling point at or before t_b
  float ahead;     // [t] density is known there, too, where this is beyond t_b
  float density_ahead[MEDIA_CAPACITY];
};

PLN_FN vec3 local_point(MediumData medium, vec3 p) {
  return vec3(
      dot(vec3(medium.local_from_world_x.x, medium.local_from_world_x.y, medium.local_from_world_x.z), p) +
          medium.local_from_world_x.w,
      dot(vec3(medium.local_from_world_y.x, medium.local_from_world_y.y, medium.local_from_world_y.z), p) +
          medium.local_from_world_y.w,
      dot(vec3(medium.local_from_world_z.x, medium.local_from_world_z.y, medium.local_from_world_z.z), p) +
          medium.local_from_world_z.w);
}

PLN_FN vec3 local_vector(MediumData medium, vec3 d) {
  return vec3(
      dot(vec3(medium.local_from_world_x.x, medium.local_from_world_x.y, medium.local_from_world_x.z), d),
      dot(vec3(medium.local_from_world_y.x, medium.local_from_world_y.y, medium.local_from_world_y.z), d),
      dot(vec3(medium.local_from_world_z.x, medium.local_from_world_z.y, medium.local_from_world_z.z), d));
}

/// 1 / d with axis-parallel directions kept finite.
PLN_FN float safe_inverse(float d) {
  return abs(d) < 1e-18f ? 1e18f : 1.0f / d;
}

PLN_FN LocalRay local_ray(PLN_SCENE, int m, vec3 origin, vec3 direction, float t_near) {
  LocalRay ray;
  ray.origin = local_point(MEDIUM(m), origin);
  ray.direction = local_vector(MEDIUM(m), direction);
  ray.inverse =
      vec3(safe_inverse(ray.direction.x), safe_inverse(ray.direction.y), safe_inverse(ray.direction.z));
  // The box is cut short by less than rounding could carry a point out of the index tree; density is zero
  // there.
  float guard = MEDIUM(m).shape == shape_voxels ? 2e-3f : 0.0f;
  vec3 low = (MEDIUM(m).bounds_min + guard - ray.origin) * ray.inverse;
  vec3 high = (MEDIUM(m).bounds_max - guard - ray.origin) * ray.inverse;
  vec3 enter = min(low, high);
  vec3 leave = max(low, high);
  ray.t_enter = max(max(enter.x, enter.y), max(enter.z, t_near));
  ray.t_leave = min(leave.x, min(leave.y, leave.z));
  ray.per_step = 1.0f / max(length(ray.direction), 1e-18f);
  if (ANALYTIC_MEDIA) {
    if (MEDIUM(m).shape == shape_sphere) {
      // Roots of |o + t d|^2 = 1 in the form that does not cancel.
      float a = dot(ray.direction, ray.direction);
      float b = dot(ray.origin, ray.direction) / a;
      vec3 nearest = ray.origin - b * ray.direction;
      float discriminant = (1.0f - dot(nearest, nearest)) / a;
      float half_chord = sqrt(max(discriminant, 0.0f));
      ray.t_enter = max(-b - half_chord, t_near);
      ray.t_leave = discriminant > 0.0f ? -b + half_chord : -1.0f;
    }
    // One segment holds all of a homogeneous medium.
    if (MEDIUM(m).shape != shape_voxels) ray.per_step = 1e30f;
  }
  if (MEDIUM(m).shape == shape_voxels) ray.origin = ray.origin - vec3(MEDIUM(m).root_origin);
  return ray;
}

/// The cell of the index tree that holds a voxel cell, counted from the root's origin. Returns its entry;
/// corner [voxels], size [voxels].
PLN_FN uvec2 find_cell(PLN_SCENE, int m, ivec3 cell, PLN_OUT(ivec3) corner, PLN_OUT(int) size) {
  if (!DEEP_TREES) {
    ivec3 brick = ivec3(cell.x >> 3, cell.y >> 3, cell.z >> 3);
    corner = ivec3(cell.x & ~7, cell.y & ~7, cell.z & ~7);
    size = 8;
    return root_entry(scene, m, brick);
  }
  int shift = 3 + 3 * MEDIUM(m).levels;
  ivec3 root_cell = ivec3(cell.x >> shift, cell.y >> shift, cell.z >> shift);
  uvec2 entry = root_entry(scene, m, root_cell);
  corner = root_cell * (1 << shift);
  while (shift > 3 && entry.x >= 0x80000000u) {
    shift -= 3;
    ivec3 offset = cell - corner;
    ivec3 child = ivec3(offset.x >> shift, offset.y >> shift, offset.z >> shift);
    entry = node_entry(scene, m, entry.x & 0x7fffffffu, child);
    corner = corner + child * (1 << shift);
  }
  size = 1 << shift;
  return entry;
}

/// Where a ray leaves an empty cell and the empty neighbours within `reach` cells of it [t].
PLN_FN float leave_empty(LocalRay ray, float reach, vec3 corner, float size) {
  vec3 middle = corner + 0.5f * size;
  float half_size = (reach + 0.5f) * size;
  // The far planes, as the ray sees them.
  vec3 far = (middle - ray.origin) * ray.inverse + half_size * abs(ray.inverse);
  return min(far.x, min(far.y, far.z));
}

/// Stored density of voxel medium m at t. Where there is none, empty_until tells how far that holds.
PLN_FN float probe(PLN_SCENE, int m, LocalRay ray, float t, PLN_INOUT(float) empty_until) {
  vec3 p = ray.origin + t * ray.direction;
  ivec3 corner;
  int size;
  uvec2 entry = find_cell(scene, m, ivec3(p), corner, size);
  vec3 local = p - vec3(corner);
  bool brick = entry.x >= 0x80000000u;
  vec3 upper = vec3(greaterThanEqual(local, vec3(4.0f)));
  bool occupied = brick && (entry.y >> uint(upper.x + 2.0f * upper.y + 4.0f * upper.z) & 1u) != 0u;
  if (!occupied) {
    // An octant of a brick, or a cell of the tree.
    float reach = brick ? 0.0f : float(max(int(entry.x), 1) - 1);
    empty_until = max(leave_empty(ray, reach, vec3(corner) + (brick ? 4.0f * upper : vec3(0.0f)),
                                  brick ? 4.0f : float(size)),
                      t);
  }
  float density = 0.0f;
  // A loop of one turn: llvmpipe would take both sides of an if.
  while (occupied) {
    density = entry_scale(entry) * brick_density(scene, m, entry.x & 0x7fffffffu, local);
    occupied = false;
  }
  return density;
}

/// Density of any medium at t inside its interval, zero outside; keeps empty_until up to date.
PLN_FN float walk_density(PLN_SCENE, int m, LocalRay ray, float t, PLN_INOUT(float) empty_until) {
  if (ANALYTIC_MEDIA && MEDIUM(m).shape != shape_voxels) return 1.0f;
  return probe(scene, m, ray, t, empty_until);
}

/// Starts a walk of the media of colour group `group` (all of them where it is negative) at t_near >= 0. The
/// first segment is empty: walk_advance() finds the next. Sampling points are `step` voxels apart and begin
/// `lead` voxels before the media.
PLN_FN Walk walk_begin(PLN_SCENE, vec3 origin, vec3 direction, float t_near, float step, float lead,
                       int group) {
  Walk walk;
  walk.t = 1e30f;
  walk.t_end = 0.0f;
  float per_step = 1e30f;  // [world]
  FOR_MEDIA {
    walk.rays[m] = local_ray(scene, m, origin, direction, t_near);
    if (group >= 0 && MEDIUM(m).group != group) walk.rays[m].t_leave = -1.0f;
    bool hit = walk.rays[m].t_leave > walk.rays[m].t_enter;
    walk.a[m] = 0.0f;
    walk.b[m] = 0.0f;
    walk.density_ahead[m] = 0.0f;
    walk.empty_until[m] = hit ? walk.rays[m].t_enter : 1e30f;
    if (hit) {
      walk.t = min(walk.t, walk.rays[m].t_enter);
      walk.t_end = max(walk.t_end, walk.rays[m].t_leave);
      per_step = min(per_step, walk.rays[m].per_step);
    }
    // A ray that starts inside starts with the density there.
    bool inside = hit && walk.rays[m].t_enter <= t_near;
    while (inside) {
      walk.b[m] = walk_density(scene, m, walk.rays[m], walk.rays[m].t_enter, walk.empty_until[m]);
      inside = false;
    }
  }
  per_step = min(per_step, max(walk.t_end - walk.t, 1e-18f));
  // Far from the camera a step must not drown in rounding: the slack of walk_advance stands well above it.
  walk.spacing = max(step * per_step, 2e-5f * walk.t_end);
  walk.shortest = max(shortest_segment * per_step, 5e-6f * walk.t_end);
  walk.steep = steep_segment;
  walk.t_b = walk.t;
  walk.comb = walk.t - lead * per_step;
  walk.ahead = walk.t;
  return walk;
}

/// Densities at the end of the segment.
PLN_FN void walk_segment_end(PLN_SCENE, PLN_INOUT(Walk) walk) {
  FOR_MEDIA {
    float density = 0.0f;
    if (ANALYTIC_MEDIA || SEVERAL_MEDIA) {
      float middle = 0.5f * (walk.t + walk.t_b);
      bool inside = middle > walk.rays[m].t_enter && middle < walk.rays[m].t_leave;
      bool analytic = ANALYTIC_MEDIA && MEDIUM(m).shape != shape_voxels;
      if (middle >= walk.rays[m].t_leave) walk.empty_until[m] = 1e30f;
      bool look = inside && (analytic || walk.t_b >= walk.empty_until[m]);
      while (look) {
        density = walk_density(scene, m, walk.rays[m], walk.t_b, walk.empty_until[m]);
        look = false;
      }
      if (analytic || !inside) walk.a[m] = density;
    } else {
      density = probe(scene, m, walk.rays[m], walk.t_b, walk.empty_until[m]);
    }
    walk.b[m] = density;
  }
}

/// Where density begins that is zero at t and is not at t_b, about a voxel on [t]. It begins at a plane of
/// the voxel grid; the ray may cross several on the way, and the last one is right on average.
PLN_FN float density_onset(LocalRay ray, float t, float t_b) {
  vec3 ahead = vec3(greaterThan(ray.direction, vec3(0.0f)));
  vec3 p = ray.origin + t_b * ray.direction;
  vec3 behind = abs((p - floor(p) - 1.0f + ahead) * ray.inverse);
  return max(t_b - min(behind.x, min(behind.y, behind.z)), t);
}

/// Length along a segment of linear extinction at which `tau` is gathered. sigma_a, sigma_b [1/world] at its
/// ends, dt [world] its length; tau [-] at most the optical depth of the segment. Returns [world] in [0, dt].
PLN_FN float length_to_optical_depth(float sigma_a, float sigma_b, float dt, float tau) {
  float root = sqrt(max(sigma_a * sigma_a + 2.0f * (sigma_b - sigma_a) * tau / max(dt, 1e-30f), 0.0f));
  return min(2.0f * tau / max(sigma_a + root, 1e-30f), dt);
}

/// Moves on to the next segment: over empty space at one leap, else to the next of the ray's sampling points,
/// which lie evenly whatever was leapt over; less far where matter is dense. Density is looked up once at the
/// most: where the segment turns out to be too opaque it is given no length, and the next one ends before the
/// place that was looked at, which is kept. So no lookup is wasted, and no ray waits for another's.
/// To be called while t_b < t_end.
PLN_FN void walk_advance(PLN_SCENE, PLN_INOUT(Walk) walk) {
  float leap = walk.t_end;
  float sigma = 0.0f;
  float sigma_ahead = 0.0f;
  FOR_MEDIA {
    walk.a[m] = walk.b[m];
    leap = min(leap, walk.empty_until[m]);
    sigma += walk.a[m] * MEDIUM(m).sigma_group;
    sigma_ahead += walk.density_ahead[m] * MEDIUM(m).sigma_group;
  }
  walk.t = walk.t_b;
  float rest = walk.ahead - walk.t;
  bool known = rest > 0.0f;
  // With some slack: rounding must not decide over segments of the shortest length.
  float divisible = 1.05f * walk.shortest;
  bool steep = known && (sigma + sigma_ahead) * rest > 2.0f * walk.steep && rest > divisible;
  // To the last sampling point before matter may begin.
  float per_spacing = 1.0f / walk.spacing;
  float landing = walk.comb + floor((leap - walk.comb) * per_spacing) * walk.spacing;
  walk.t = !known && leap > walk.t ? max(walk.t, landing) : walk.t;
  walk.comb += floor((walk.t - walk.comb) * per_spacing) * walk.spacing;
  walk.comb += walk.t > walk.comb + 0.98f * walk.spacing ? walk.spacing : 0.0f;
  // Inside dense matter a segment is short from the start.
  float length_ahead = min(
      max(length_to_optical_depth(sigma, sigma_ahead, rest, 0.7f * walk.steep), walk.shortest), 0.75f * rest);
  float new_end =
      min(min(walk.comb + walk.spacing, walk.t + max(1.5f * walk.steep / max(sigma, 1e-20f), walk.shortest)),
          walk.t_end);
  walk.t_b = steep ? walk.t + length_ahead : known ? walk.ahead : new_end;
  if (ANALYTIC_MEDIA || SEVERAL_MEDIA) {
    // A segment ends where a medium begins or ends.
    FOR_MEDIA {
      if (walk.rays[m].t_enter > walk.t) walk.t_b = min(walk.t_b, walk.rays[m].t_enter);
      if (walk.rays[m].t_leave > walk.t) walk.t_b = min(walk.t_b, walk.rays[m].t_leave);
    }
  }
  FOR_MEDIA walk.b[m] = walk.density_ahead[m];
  bool looks = !known || steep;
  while (looks) {
    walk_segment_end(scene, walk);
    looks = false;
  }
  bool empty_before = true;
  float sigma_b = 0.0f;
  FOR_MEDIA {
    sigma_b += walk.b[m] * MEDIUM(m).sigma_group;
    empty_before = empty_before && walk.a[m] == 0.0f;
  }
  float dt = walk.t_b - walk.t;
  bool refused = (sigma + sigma_b) * dt > 2.0f * walk.steep && dt > divisible;
  if (refused) {
    walk.ahead = walk.t_b;
    walk.t_b = walk.t;
  }
  FOR_MEDIA {
    if (refused) {
      walk.density_ahead[m] = walk.b[m];
      walk.b[m] = walk.a[m];
    }
  }
  bool begins = !refused && empty_before && sigma_b > 0.0f;
  float onset = walk.t_b;
  FOR_MEDIA {
    float here = density_onset(walk.rays[m], walk.t, walk.t_b);
    onset = MEDIUM(m).shape == shape_voxels && walk.b[m] > 0.0f ? min(onset, here) : onset;
  }
  walk.t = begins && onset < walk.t_b ? onset : walk.t;
}

PLN_END
#endif
