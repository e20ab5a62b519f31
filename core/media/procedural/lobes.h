// Lumps on lumps: balls that bear smaller balls, generation after generation. Their union is the billowing
// surface that a rising, churning plume shows; the gaps that the packing leaves are its crevices.
//
// All lengths are in object space, the unit cube that a procedural medium fills. What is left out: lobes do
// not know time, so a medium does not evolve.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/shared/glue.h"

namespace plinian::procedural {

struct Lobe {
  vec3 centre{0.0f};    // [object]
  float radius = 0.0f;  // [object] of the hull it stands for; younger lobes grow on this surface
};

/// How one generation grows on the one before.
struct Growth {
  float smallest = 0.3f;   // [-] least radius over the parent's
  float largest = 0.5f;    // [-] largest radius over the parent's
  float bias = 1.0f;       // [-] > 0; above 1 favours small lobes
  float spacing = 0.65f;   // [-] least distance of two lobes over the sum of their radii
  float stand_out = 0.1f;  // [-] height of a lobe's centre above its parent's surface, over its own radius
  float core = 0.95f;      // [-] what is left of a parent's radius under its lobes: less is deeper crevices
};

/// Multiplies the radius of a lobe that would stand at `centre`, facing `outward`; 0 lets none grow there.
using LobeScale = std::function<float(vec3 centre, vec3 outward)>;

/// Every generation of lobes, oldest first.
struct LobeFamily {
  std::vector<Lobe> lobes;  // ordered by generation, then from the largest to the smallest
  std::vector<float> body;  // [object] radius that the union is taken with: less than the lobe's own where
                            // it bears others
  std::vector<std::size_t> begin;  // first lobe of each generation, and one past the last of all
  std::size_t generations() const { return begin.empty() ? 0 : begin.size() - 1; }
};

/// Starts a family from placed lobes.
LobeFamily found_family(std::vector<Lobe> founders);

/// Grows one more generation. Lobes under `least_radius` [object] are left out, which moves no other: the
/// same seed gives the same lobes at every resolution, and a finer one only adds to them.
void grow(LobeFamily& family, const Growth& growth, std::uint32_t seed, float least_radius,
          const LobeScale& scale = {});

/// Takes lobes under `least_radius` [object] out of the youngest generation, which grew by `growth`.
void prune(LobeFamily& family, const Growth& growth, float least_radius);

/// A uniform scaling about (0.5, 0, 0.5) and a shift in x and z.
struct Fit {
  float scale = 1.0f;
  vec3 shift{0.0f};  // [object]
  vec3 object_from_design(vec3 p) const {
    return (p - vec3(0.5f, 0.0f, 0.5f)) * scale + vec3(0.5f, 0.0f, 0.5f) + shift;
  }
  vec3 design_from_object(vec3 p) const {
    return (p - shift - vec3(0.5f, 0.0f, 0.5f)) / scale + vec3(0.5f, 0.0f, 0.5f);
  }
};

/// Scales and centres a family so that it fills the unit cube but for `margin` [object]: lobes of the
/// youngest generation count with `reach` times their radius, since others will stand out from them. The
/// ground y = 0 stays where it is.
Fit fit_family(LobeFamily& family, float reach, float margin);

}  // namespace plinian::procedural
