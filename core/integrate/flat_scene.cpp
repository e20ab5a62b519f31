#include "core/integrate/flat_scene.h"

#include <cmath>
#include <stdexcept>

#include "core/lights/light_frame.h"
#include "core/shared/light_falloff.h"
#include "core/shared/phase.h"

namespace plinian {
namespace {

static_assert(int(PhaseKind::two_lobe) == shared::phase_two_lobe && int(LightType::point) == light_point &&
              int(MediumShape::sphere) == shape_sphere && int(Falloff::none) == shared::falloff_none);

struct LocalBox {
  dvec3 low, high;
  dmat4 world_from_local;
};

LocalBox local_box(const Medium& medium) {
  if (medium.shape != MediumShape::voxels) return {dvec3(-1.0), dvec3(1.0), medium.world_from_medium};
  return {dvec3(medium.volume->bounds_min), dvec3(medium.volume->bounds_max),
          medium.world_from_medium * medium.volume->medium_from_index};
}

MediumData flatten(const Medium& medium, const LocalBox& box) {
  MediumData data{};
  const dmat4 local_from_world = glm::inverse(box.world_from_local);
  const auto row = [&](int r) {
    return vec4(local_from_world[0][r], local_from_world[1][r], local_from_world[2][r],
                local_from_world[3][r]);
  };
  data.local_from_world_x = row(0);
  data.local_from_world_y = row(1);
  data.local_from_world_z = row(2);
  data.bounds_min = vec3(box.low);
  data.bounds_max = vec3(box.high);
  data.shape = int(medium.shape);
  float stored_one = medium.density_scale;  // density * density_scale of a stored density of 1
  float temperature_one = 1.0f;
  if (medium.shape == MediumShape::voxels) {
    stored_one *= medium.volume->density_max;
    temperature_one = medium.volume->temperature_max;
    data.root_origin = medium.volume->origin;
    data.root_dims = medium.volume->root_dims;
    data.levels = medium.volume->levels;
  }
  data.density_scale = stored_one;
  data.sigma_t = (medium.sigma_s + medium.sigma_a) * stored_one;
  data.sigma_s = medium.sigma_s * stored_one;
  data.emission = medium.emission.scale * std::exp2(medium.emission.exposure) * stored_one;
  data.temperature_scale = medium.emission.temperature_scale * temperature_one;
  data.temperature_offset = medium.emission.temperature_offset;
  data.phase_kind = int(medium.phase.kind);
  data.g = medium.phase.g;
  data.g_back = medium.phase.g_back;
  data.blend = medium.phase.blend;
  return data;
}

LightData flatten(const Light& light) {
  LightData data{};
  data.power = light.power();
  data.type = int(light.type);
  data.position = light.position;
  data.radius = light.radius;
  data.toward = glm::normalize(light.toward);
  data.falloff = int(light.falloff);
  const float half = glm::radians(light.cone_angle) * 0.5f;
  data.cone_outer = shared::squared_chord(half);
  data.cone_inner = shared::squared_chord(std::max(half - glm::radians(light.penumbra), 0.0f));
  return data;
}

/// The smallest channel that extinguishes at all: exponents from it are at least 1, which keeps the error of
/// a truncated tail from growing [TFM11 6.1]. 0 where nothing extinguishes.
float reference_channel(vec3 sigma_t) {
  float smallest = 0.0f;
  for (int c = 0; c < 3; ++c)
    if (sigma_t[c] > 0.0f && (smallest == 0.0f || sigma_t[c] < smallest)) smallest = sigma_t[c];
  return smallest;
}

}  // namespace

FlatScene flatten(const SceneSnapshot& scene) {
  FlatScene flat;
  Corners corners;
  std::vector<vec3> group_colours;  // exponents: sigma_t / reference channel
  for (const Medium& medium : scene.media) {
    if (medium.shape == MediumShape::voxels && (!medium.volume || medium.volume->empty())) continue;
    const LocalBox box = local_box(medium);
    MediumData data = flatten(medium, box);
    data.sigma_group = reference_channel(data.sigma_t);
    const vec3 colour = data.sigma_group > 0.0f ? data.sigma_t / data.sigma_group : vec3(0.0f);
    // Proportional extinctions share a map; so does a medium that extinguishes nothing.
    int group = 0;
    const auto proportional = [&](vec3 other) {
      return data.sigma_group == 0.0f ||
             glm::all(glm::lessThan(glm::abs(colour - other), 1e-4f * (colour + 1.0f)));
    };
    while (group < int(group_colours.size()) && !proportional(group_colours[group])) ++group;
    if (group == int(group_colours.size())) group_colours.push_back(colour);
    if (group_colours[group] == vec3(0.0f)) group_colours[group] = colour;
    data.group = group;
    flat.grey = flat.grey && (data.sigma_group == 0.0f ? true : colour == vec3(1.0f));
    flat.analytic = flat.analytic || medium.shape != MediumShape::voxels;
    flat.emissive = flat.emissive || data.emission > 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
      const dvec3 p(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                    corner & 4 ? box.high.z : box.low.z);
      corners.push_back(dvec3(box.world_from_local * dvec4(p, 1.0)));
    }
    flat.media.push_back(data);
    flat.volumes.push_back(medium.shape == MediumShape::voxels ? medium.volume : nullptr);
  }
  flat.group_count = int(group_colours.size());
  if (int(flat.media.size()) > max_media)
    throw std::runtime_error("the scene has " + std::to_string(flat.media.size()) + " media; at most " +
                             std::to_string(max_media) + " can overlap in one picture");

  const MapQuality& quality = scene.quality.map;
  for (const Light& light : scene.lights) {
    LightData data = flatten(light);
    data.first_map = int(flat.maps.size());
    if (!corners.empty()) {
      const std::vector<MapData> frames = light_frames(light, corners, quality.resolution);
      data.faces = int(frames.size());
      for (int g = 0; g < flat.group_count; ++g)
        for (MapData map : frames) {
          map.layer = int(flat.maps.size());
          map.group = g;
          map.exponent = group_colours[g];
          map.resolution = quality.resolution;
          flat.maps.push_back(map);
        }
    }
    flat.lights.push_back(data);
    flat.varied_light = flat.varied_light || light.type != LightType::directional;
  }
  flat.varied_light = flat.varied_light || flat.analytic;
  flat.encode.coefficients = quality.coefficients;
  flat.encode.adaptive = quality.encoding == Encoding::atfm;
  flat.encode.veil_proof = quality.kmin_rule == KminRule::veil_proof;
  flat.encode.end_zero = quality.end_rule == EndRule::zero;
  flat.encode.kmin_transmittance = quality.kmin_transmittance;
  flat.encode.threshold = quality.threshold;
  flat.encode.inverse_weighting = 1.0f / quality.density_weighting;
  flat.encode.step = quality.detect_step;
  flat.encode.refine_steps = quality.refine_steps;
  const ViewQuality& view = scene.quality.view;
  flat.view = {1.0f / float(view.shade_samples),
               view.step,
               view.transmittance_cutoff,
               view.light,
               view.march_step,
               view.march_depth};
  flat.extinction_reuse = scene.extinction_reuse;
  flat.layout = {quality.resolution, quality.coefficients, quality.density_weighting};
  return flat;
}

namespace {

/// Lights [first, last) of a scene with their maps, renumbered from zero.
FlatScene part_of(const FlatScene& scene, std::size_t first, std::size_t last) {
  FlatScene part = scene;
  part.lights.assign(scene.lights.begin() + first, scene.lights.begin() + last);
  part.maps.clear();
  for (LightData& light : part.lights) {
    const int maps = light.faces * scene.group_count;
    const auto begin = scene.maps.begin() + light.first_map;
    light.first_map = int(part.maps.size());
    part.maps.insert(part.maps.end(), begin, begin + maps);
  }
  for (std::size_t i = 0; i < part.maps.size(); ++i) part.maps[i].layer = int(i);
  return part;
}

}  // namespace

std::vector<FlatScene> light_batches(const FlatScene& scene) {
  if (scene.view.light == LightLookup::error && !scene.lights.empty()) {
    std::vector<FlatScene> batches = exact_batches(scene);
    for (FlatScene& part : batches) part.view.light = LightLookup::error;
    return batches;
  }
  std::vector<FlatScene> batches;
  std::size_t first = 0;
  do {
    std::size_t last = first;
    for (int maps = 0; last < scene.lights.size() && last - first < std::size_t(max_lights); ++last) {
      maps += scene.lights[last].faces * scene.group_count;
      if (maps > max_maps) break;
    }
    batches.push_back(part_of(scene, first, last));
    first = last;
  } while (first < scene.lights.size());
  return batches;
}

FlatScene light_alone(const FlatScene& scene, std::size_t light) {
  return part_of(scene, light, light + 1);
}

std::vector<FlatScene> exact_batches(const FlatScene& scene) {
  std::vector<FlatScene> batches;
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    FlatScene part = light_alone(scene, l);
    part.view.light = LightLookup::march;
    // Further passes shade four times as finely as this says; a march per lookup is too dear for that.
    part.view.quantum = std::min(4.0f * part.view.quantum, 1.0f);
    part.view.march_step = 0.5f;
    part.view.march_depth = 16.0f;
    batches.push_back(std::move(part));
  }
  return batches;
}

MarchViews view_of(const FlatScene& flat, const uvec4* texels) {
  MarchViews views;
  for (const auto& volume : flat.volumes) views.volumes.push_back(volume.get());
  views.scene = {flat.media.data(),
                 views.volumes.data(),
                 int(flat.media.size()),
                 flat.lights.data(),
                 int(flat.lights.size()),
                 flat.maps.data(),
                 texels,
                 flat.layout,
                 flat.group_count,
                 flat.varied_light,
                 flat.view.light == LightLookup::march,
                 flat.view.light == LightLookup::error,
                 flat.view.march_step,
                 flat.view.march_depth};
  return views;
}

}  // namespace plinian
