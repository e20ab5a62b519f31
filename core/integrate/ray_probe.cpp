#include "core/integrate/ray_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/integrate/map_texel.h"
#include "core/integrate/medium_walk.h"
#include "core/shared/view_march.h"

namespace plinian {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double mean(const dvec3& v) {
  return (v.x + v.y + v.z) / 3.0;
}

/// The density that a ray meets in all media, looked up in any order.
class Path {
 public:
  Path(const SceneSnapshot& scene, const Ray& ray, double from) {
    for (const Medium& medium : scene.media) {
      One& one = media_.emplace_back();
      one.extinction = double(medium.density_scale) * (dvec3(medium.sigma_s) + dvec3(medium.sigma_a));
      MediumWalk(medium).pieces(ray, from, infinity, infinity, one.pieces);
      for (const DensityPiece& piece : one.pieces) {
        one.before.push_back(one.before.empty() ? 0.0 : one.before.back() + one.last);
        one.last = piece.integral(piece.end);
        begin = std::min(begin, piece.begin);
        end = std::max(end, piece.end);
      }
    }
  }

  double begin = infinity, end = -infinity;  // [world] of all density
  bool is_empty() const { return !(begin < end); }

  dvec3 sigma_t(double t) const {
    dvec3 sum(0.0);
    for (const One& one : media_)
      if (const DensityPiece* piece = one.at(t); piece && t <= piece->end)
        sum += one.extinction * piece->density(t);
    return sum;
  }
  dvec3 transmittance(double t) const {
    dvec3 tau(0.0);
    for (const One& one : media_)
      if (const DensityPiece* piece = one.at(t))
        tau += one.extinction * (one.before[std::size_t(piece - one.pieces.data())] +
                                 piece->integral(std::min(t, piece->end)));
    return glm::exp(-tau);
  }

 private:
  struct One {
    dvec3 extinction;  // [1/world] per unit of the file's density
    std::vector<DensityPiece> pieces;
    std::vector<double> before;  // [unit of the file * world] integral of density in front of each piece
    double last = 0.0;

    /// The last piece that begins at or before t, or null.
    const DensityPiece* at(double t) const {
      const auto after =
          std::upper_bound(pieces.begin(), pieces.end(), t,
                           [](double value, const DensityPiece& p) { return value < p.begin; });
      return after == pieces.begin() ? nullptr : &*std::prev(after);
    }
  };
  std::vector<One> media_;
};

/// The texels of a light's maps that a point's light ray lies between: all that decoding along it reads.
struct FewTexels {
  FewTexels(const FlatScene& whole, std::size_t light, vec3 point) : flat(light_alone(whole, light)) {
    const MarchViews views = view_of(flat, nullptr);
    const int size = flat.layout.resolution, words = words_per_texel(flat.layout.coefficients),
              face = shared::map_face(views.scene, 0, point);
    const std::size_t layer = std::size_t(size) * std::size_t(size) * std::size_t(words);
    texels.assign(layer * std::size_t(flat.group_count), uvec4(0u));
    for (int group = 0; group < flat.group_count; ++group) {
      const int map = flat.lights[0].first_map + group * flat.lights[0].faces + face;
      // At the lamp itself, where the ray begins, any face may be asked.
      for (int f = 0; f < flat.lights[0].faces; ++f) flat.maps[std::size_t(map - face + f)].layer = group;
      // In this order: there the place is none, and becomes 0.
      const vec2 place = glm::min(
          vec2(float(size - 1)),
          glm::max(vec2(0.0f), vec2(shared::map_place(views.scene, map, point)) * float(size) - 0.5f));
      const ivec2 corner = glm::min(ivec2(place), ivec2(size - 2)), nearest = ivec2(place + 0.5f);
      const auto at = [&](ivec2 texel) {
        return texels.data() + std::size_t(group) * layer +
               (std::size_t(texel.y) * std::size_t(size) + std::size_t(texel.x)) * std::size_t(words);
      };
      for (const ivec2 offset : {ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1)})
        write_map_texel(flat, views.scene, map, corner + offset, at(corner + offset));
      const uint bits = at(nearest)->w;
      const float depth = flat.maps[std::size_t(map)].k_max;
      bounds.push_back({shared::bounds_k_min(bits, depth), shared::bounds_k_max(bits, depth),
                        shared::bounds_dense(bits), bits == shared::missed_bounds()});
    }
  }

  FlatScene flat;  // of that light alone
  std::vector<uvec4> texels;
  std::vector<LightRayProbe::Bounds> bounds;
};

}  // namespace

RayProbe::RayProbe(const SceneSnapshot& scene) : scene_(scene), flat_(flatten(scene)) {}

ViewRayProbe RayProbe::view_ray(ivec2 pixel, int count) const {
  const CameraRays rays = camera_rays(scene_.camera, scene_.width, scene_.height);
  ViewRayProbe probe;
  probe.origin = dvec3(rays.origin);
  probe.direction = glm::normalize(dvec3(
      shared::pixel_direction(rays.forward, rays.right, rays.up, pixel, ivec2(scene_.width, scene_.height))));
  probe.depth = infinity;
  const Path path(scene_, {probe.origin, probe.direction}, scene_.camera.near_clip);
  if (path.is_empty()) return probe;
  for (int i = 0; i < count; ++i) {
    const double t = glm::mix(path.begin, path.end, double(i) / double(count - 1));
    probe.samples.push_back({t, path.sigma_t(t), path.transmittance(t)});
  }
  if (mean(path.transmittance(path.end)) <= 0.5) {
    double low = path.begin, high = path.end;
    for (int i = 0; i < 60; ++i)
      (mean(path.transmittance(0.5 * (low + high))) > 0.5 ? low : high) = 0.5 * (low + high);
    probe.depth = 0.5 * (low + high);
  }
  return probe;
}

LightRayProbe RayProbe::light_ray(const dvec3& point, std::size_t light, int count) const {
  const Light& lamp = scene_.lights.at(light);
  LightRayProbe probe;
  probe.light = lamp.name;
  if (flat_.media.empty()) {
    probe.exact = probe.map = dvec3(1.0);
    probe.k = 0.0;
    return probe;
  }
  const FewTexels few(flat_, light, vec3(point));
  const MarchViews views = view_of(few.flat, few.texels.data());
  probe.bounds = few.bounds;

  Ray ray;
  if (lamp.type == LightType::directional) {
    ray.direction = -glm::normalize(dvec3(lamp.toward));
    probe.k = glm::dot(dvec4(few.flat.maps[0].row_k), dvec4(point, 1.0));
  } else {
    probe.k = glm::length(point - dvec3(lamp.position));
    ray.direction = probe.k > 0.0 ? (point - dvec3(lamp.position)) / probe.k : dvec3(0, 0, 1);
  }
  ray.origin = point - probe.k * ray.direction;
  const Path path(scene_, ray, 0.0);
  const auto sample = [&](double k) -> LightRayProbe::Sample {
    return {k, path.transmittance(k),
            dvec3(shared::light_transmittance(views.scene, 0, vec3(ray.origin + k * ray.direction), false))};
  };
  const LightRayProbe::Sample here = sample(probe.k);
  probe.exact = here.exact;
  probe.map = here.map;

  double begin = std::min(path.begin, probe.k), end = probe.k;
  for (const LightRayProbe::Bounds& bounds : probe.bounds) {
    if (bounds.missed) continue;
    begin = std::min(begin, bounds.k_min);
    end = std::max(end, bounds.k_max);
  }
  const double margin = 0.05 * (end - begin);
  begin = std::max(0.0, begin - margin);
  end += margin;
  for (int i = 0; i < count; ++i)
    probe.samples.push_back(sample(glm::mix(begin, end, double(i) / double(count - 1))));
  return probe;
}

}  // namespace plinian
