// Grows lobes: candidates on every parent's sphere, refused where an older lobe already covers them, then
// taken from the largest to the smallest wherever none stands too close (dart throwing).
#include "core/media/procedural/lobes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/media/procedural/noise.h"

namespace plinian::procedural {
namespace {

constexpr float golden_angle = 2.39996323f;  // [rad]
constexpr int grid_size = 48;                // cells along a side of [-0.25, 1.25]^3

/// Lists of lobes by the grid cells that their neighbourhood touches.
class LobeGrid {
 public:
  LobeGrid() : cells_(std::size_t(grid_size) * grid_size * grid_size) {}

  void insert(std::uint32_t lobe, vec3 centre, float reach) {
    const ivec3 low = cell(centre - reach), high = cell(centre + reach);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) cells_[(z * grid_size + y) * grid_size + x].push_back(lobe);
  }

  const std::vector<std::uint32_t>& at(vec3 p) const {
    const ivec3 c = cell(p);
    return cells_[(c.z * grid_size + c.y) * grid_size + c.x];
  }

 private:
  static ivec3 cell(vec3 p) {
    return glm::clamp(ivec3(glm::floor((p + 0.25f) * (grid_size / 1.5f))), ivec3(0), ivec3(grid_size - 1));
  }
  std::vector<std::vector<std::uint32_t>> cells_;
};

struct Candidate {
  Lobe lobe;
  std::uint32_t parent;
};

/// What could grow on one parent: points spread evenly over its sphere, each with a size of its own.
void gather_candidates(const LobeFamily& family, std::uint32_t parent, const LobeGrid& older,
                       const Growth& growth, std::uint32_t seed, float least_radius, const LobeScale& scale,
                       std::vector<Candidate>& out) {
  const Lobe& bearer = family.lobes[parent];
  // A parent's key is where it stands, not its number, so that lobes left out elsewhere change nothing here.
  const auto bits = [](float v) { return glm::floatBitsToUint(v); };
  RandomStream random(hash(hash(bits(bearer.centre.x), bits(bearer.centre.y)), bits(bearer.centre.z) ^ seed));
  const vec3 axis = random.direction();
  const vec3 side =
      glm::normalize(glm::cross(axis, std::fabs(axis.y) < 0.7f ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  const vec3 other = glm::cross(axis, side);
  const float typical = 0.5f * (growth.smallest + growth.largest) * growth.spacing;
  const int count = std::clamp(static_cast<int>(12.0f / (typical * typical)), 24, 600);
  for (int i = 0; i < count; ++i) {
    const float z = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float ring = std::sqrt(1.0f - z * z);
    const float angle = golden_angle * static_cast<float>(i) + random.uniform(-0.5f, 0.5f);
    const vec3 outward = z * axis + ring * (cosine(angle) * side + sine(angle) * other);
    const float size = power(random.uniform(), growth.bias);
    const float jitter = random.uniform(-0.25f, 0.25f);
    float radius = bearer.radius * (growth.smallest + (growth.largest - growth.smallest) * size);
    const vec3 surface = bearer.centre + bearer.radius * outward;
    if (scale) radius *= scale(surface, outward);
    if (!(radius >= least_radius)) continue;
    const vec3 centre = surface + outward * (radius * (growth.stand_out + jitter));
    const bool covered = std::ranges::any_of(older.at(centre), [&](std::uint32_t o) {
      const Lobe& lobe = family.lobes[o];
      const vec3 d = centre - lobe.centre;
      const float clear = lobe.radius - 0.35f * radius;
      return o != parent && clear > 0.0f && glm::dot(d, d) < clear * clear;
    });
    if (!covered) out.push_back({{centre, radius}, parent});
  }
}

/// A parent whose lobes are too small to be shown swells to stand for them, so that a medium weighs the same
/// at every resolution. The factor is fitted to that: 64 and 256 voxels then differ by 1 to 5%.
float swell_of(const Growth& growth) {
  return 1.0f + 0.5f * (growth.smallest + growth.largest) * (1.0f + growth.stand_out);
}

/// The bodies of the generation before the youngest, which bears what is left of `growth` over
/// `least_radius`.
void settle_bodies(LobeFamily& family, const Growth& growth, float least_radius) {
  const std::size_t generations = family.generations();
  const float swell = swell_of(growth);
  for (std::size_t i = family.begin[generations - 2]; i < family.begin[generations - 1]; ++i) {
    const float radius = family.lobes[i].radius;
    // How many of its lobes are shown: their sizes are spread as gather_candidates() draws them.
    const float size = (least_radius / radius - growth.smallest) / (growth.largest - growth.smallest);
    const float shown = 1.0f - power(std::clamp(size, 0.0f, 1.0f), 1.0f / growth.bias);
    family.body[i] = radius * (swell + (growth.core - swell) * shown);
  }
}

}  // namespace

LobeFamily found_family(std::vector<Lobe> founders) {
  LobeFamily family;
  std::ranges::stable_sort(founders, std::greater{}, &Lobe::radius);
  family.lobes = std::move(founders);
  for (const Lobe& lobe : family.lobes) family.body.push_back(lobe.radius);
  family.begin = {0, family.lobes.size()};
  return family;
}

void grow(LobeFamily& family, const Growth& growth, std::uint32_t seed, float least_radius,
          const LobeScale& scale) {
  const std::size_t first = family.begin[family.generations() - 1], last = family.begin.back();
  LobeGrid older;
  for (std::size_t i = 0; i < last; ++i)
    older.insert(static_cast<std::uint32_t>(i), family.lobes[i].centre, family.lobes[i].radius);

  std::vector<std::vector<Candidate>> by_parent(last - first);
  tbb::parallel_for(first, last, [&](std::size_t parent) {
    gather_candidates(family, static_cast<std::uint32_t>(parent), older, growth, seed, least_radius, scale,
                      by_parent[parent - first]);
  });
  std::vector<Candidate> candidates;
  for (const auto& some : by_parent) candidates.insert(candidates.end(), some.begin(), some.end());
  // From the largest down, so that the small ones, which a coarse resolution leaves out, displace nobody.
  std::ranges::stable_sort(candidates, std::greater{}, [](const Candidate& c) { return c.lobe.radius; });

  LobeGrid taken;
  for (const Candidate& candidate : candidates) {
    const Lobe& lobe = candidate.lobe;
    const bool crowded = std::ranges::any_of(taken.at(lobe.centre), [&](std::uint32_t o) {
      const vec3 d = lobe.centre - family.lobes[o].centre;
      const float apart = growth.spacing * (lobe.radius + family.lobes[o].radius);
      return glm::dot(d, d) < apart * apart;
    });
    if (crowded) continue;
    taken.insert(static_cast<std::uint32_t>(family.lobes.size()), lobe.centre,
                 2.0f * growth.spacing * lobe.radius);
    family.lobes.push_back(lobe);
    family.body.push_back(lobe.radius);
  }
  family.begin.push_back(family.lobes.size());
  settle_bodies(family, growth, least_radius);
}

void prune(LobeFamily& family, const Growth& growth, float least_radius) {
  const std::size_t first = family.begin[family.generations() - 1];
  // Sorted from the largest down, so the small ones stand at the end.
  while (family.lobes.size() > first && family.lobes.back().radius < least_radius) family.lobes.pop_back();
  family.body.resize(family.lobes.size());
  family.begin.back() = family.lobes.size();
  settle_bodies(family, growth, least_radius);
}

Fit fit_family(LobeFamily& family, float reach, float margin) {
  vec3 low(1e3f), high(-1e3f);
  const std::size_t youngest = family.begin[family.generations() - 1];
  for (std::size_t i = 0; i < family.lobes.size(); ++i) {
    const float radius = family.lobes[i].radius * (i < youngest ? 1.0f : reach);
    low = glm::min(low, family.lobes[i].centre - radius);
    high = glm::max(high, family.lobes[i].centre + radius);
  }
  Fit fit;
  fit.scale = (1.0f - 2.0f * margin) / std::max({high.x - low.x, high.z - low.z, high.y + margin});
  const vec3 middle = 0.5f * (low + high) - 0.5f;
  fit.shift = -fit.scale * vec3(middle.x, 0.0f, middle.z);
  for (std::size_t i = 0; i < family.lobes.size(); ++i) {
    family.lobes[i].centre = fit.object_from_design(family.lobes[i].centre);
    family.lobes[i].radius *= fit.scale;
    family.body[i] *= fit.scale;
  }
  return fit;
}

}  // namespace plinian::procedural
