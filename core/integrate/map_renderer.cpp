#include "core/integrate/map_renderer.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <optional>

#include "core/integrate/flat_scene.h"
#include "core/integrate/map_texel.h"
#include "core/scene/frame_layers.h"
#include "core/scene/rest_gauge.h"
#include "core/shared/pass_weight.h"
#include "core/shared/view_march.h"
#include "core/transmittance/map_key.h"

namespace plinian {
namespace {

using Clock = std::chrono::steady_clock;

/// The maps of one batch of lights, and what they were built for.
struct BatchMaps {
  std::vector<uvec4> texels;
  std::vector<std::optional<MapKey>> built;
};

/// Runs `work(row)` for every row on all cores; asks `progress` now and then, and throws RenderCancelled.
template <class Work>
void for_rows(int rows, double begin, double end, const Progress& progress, const Work& work) {
  std::atomic<int> done = 0;
  std::atomic<bool> cancelled = false;
  constexpr int strip = 16;
  for (int first = 0; first < rows && !cancelled; first += strip) {
    tbb::parallel_for(first, std::min(first + strip, rows), [&](int row) { work(row); });
    done += strip;
    if (progress && !progress(begin + (end - begin) * std::min(1.0, double(done) / rows))) cancelled = true;
  }
  if (cancelled) throw RenderCancelled();
}

void build_map(const FlatScene& flat, int map, std::vector<uvec4>& texels, const Progress& progress) {
  const MarchViews views = view_of(flat, nullptr);
  const int size = flat.layout.resolution, words = words_per_texel(flat.layout.coefficients);
  uvec4* out = texels.data() + std::size_t(map) * size * size * words;
  for_rows(size, 0.0, 0.0, progress, [&](int y) {
    for (int x = 0; x < size; ++x)
      write_map_texel(flat, views.scene, map, ivec2(x, y), out + (std::size_t(y) * size + x) * words);
  });
}

class MapRenderer final : public Renderer {
 public:
  Frame render(const SceneSnapshot& scene, const Passes& passes, const Progress& progress) override;
  const RenderStats& stats() const override { return stats_; }

 private:
  void build_maps(FlatScene& flat, BatchMaps& maps, const Progress& progress);

  std::vector<BatchMaps> batches_;
  std::vector<std::shared_ptr<const BrickVolume>>
      volumes_;  // kept, so that a key's address stays an identity
  RenderStats stats_;
};

void MapRenderer::build_maps(FlatScene& flat, BatchMaps& maps, const Progress& progress) {
  const std::size_t size = std::size_t(flat.layout.resolution) * flat.layout.resolution *
                           words_per_texel(flat.layout.coefficients) * flat.maps.size();
  if (maps.texels.size() != size || maps.built.size() != flat.maps.size()) {
    maps.texels.assign(size, uvec4(0u));
    maps.built.assign(flat.maps.size(), std::nullopt);
  }
  for (std::size_t i = 0; i < flat.maps.size(); ++i) {
    MapKey key = map_key(flat, int(i));
    if (maps.built[i])
      if (const auto power = map_power(*maps.built[i], key, flat.extinction_reuse)) {
        flat.maps[i].exponent *= *power;
        continue;
      }
    maps.built[i].reset();
    build_map(flat, int(i), maps.texels, progress);
    maps.built[i] = std::move(key);
    ++stats_.map_builds;
  }
  stats_.map_bytes += maps.texels.size() * sizeof(uvec4);
}

Frame MapRenderer::render(const SceneSnapshot& scene, const Passes& passes, const Progress& progress) {
  const FlatScene whole = flatten(scene);
  stats_.begin_picture();
  if (whole.media.empty()) {
    // Nothing of the scene before is kept: it may be large, and is not known to come again.
    batches_.clear();
    volumes_.clear();
    stats_.map_bytes = stats_.volume_bytes = 0;
    return empty_frame(scene);
  }
  const auto start = Clock::now();
  const double cpu_start = processor_milliseconds();
  std::vector<FlatScene> batches = light_batches(whole);
  batches_.resize(batches.size());
  stats_.map_bytes = stats_.volume_bytes = 0;
  for (const auto& volume : whole.volumes) stats_.volume_bytes += volume ? volume->bytes() : 0;
  for (std::size_t b = 0; b < batches.size(); ++b) build_maps(batches[b], batches_[b], progress);
  volumes_ = whole.volumes;
  const auto maps_done = Clock::now();
  const double cpu_maps = processor_milliseconds();

  const bool exact = has_exact_passes(scene.quality.view, passes.most);
  const std::vector<FlatScene> exact_parts = exact ? exact_batches(whole) : std::vector<FlatScene>();
  const int map_passes = exact_parts.empty() ? passes.most : 1;
  const double jobs =
      double(batches.size()) * map_passes + double(exact_parts.size()) * (passes.most - map_passes);
  double job = 0.0;
  FrameSums sums(scene, whole.lights.size());
  const CameraRays rays = camera_rays(scene.camera, scene.width, scene.height);
  // One pass of some lights; media are seen the same by all parts, so one of them counts.
  const auto render_part = [&](const FlatScene& flat, const uvec4* texels, std::size_t first_light, int pass,
                               bool with_media) {
    const MarchViews views = view_of(flat, texels);
    const float weight = shared::pass_weight(pass);
    for_rows(scene.height, job / jobs, (job + 1.0) / jobs, progress, [&](int y) {
      for (int x = 0; x < scene.width; ++x) {
        const vec3 direction = shared::pixel_direction(rays.forward, rays.right, rays.up, ivec2(x, y),
                                                       ivec2(scene.width, scene.height));
        const shared::ViewControls controls =
            shared::view_controls(ivec2(x, y), pass, flat.view.quantum, flat.view.step, flat.view.cutoff);
        const shared::ViewResult result =
            shared::march_view(views.scene, rays.origin, direction, scene.camera.near_clip, controls);
        const std::size_t pixel = std::size_t(y) * scene.width + x;
        if (with_media) {
          sums.transmittance[pixel] += weight * result.transmittance;
          sums.ambient[pixel] += weight * result.ambient;
          sums.emission[pixel] += weight * result.emission;
          if (pass == 0) sums.depth[pixel] = result.depth;
        }
        for (std::size_t l = 0; l < flat.lights.size(); ++l)
          sums.lights[first_light + l][pixel] += weight * result.light[l];
      }
    });
    ++job;
  };
  Refinement refinement(passes);
  int done = 0;
  do {
    std::size_t first_light = 0;
    if (done < map_passes)
      for (std::size_t b = 0; b < batches.size(); ++b) {
        render_part(batches[b], batches_[b].texels.data(), first_light, done, b == 0);
        first_light += batches[b].lights.size();
      }
    else
      for (std::size_t l = 0; l < exact_parts.size(); ++l)
        render_part(exact_parts[l], nullptr, l, done, l == 0);
    ++done;
  } while (
      refinement.wants_another(done, [&] { return resolve(sums, scene, shared::weight_of_passes(done)); }));
  stats_.passes = done;
  stats_.rest_change = refinement.rest_change();
  const auto milliseconds = [](auto from, auto to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
  };
  stats_.map_ms = milliseconds(start, maps_done);
  stats_.view_ms = milliseconds(maps_done, Clock::now());
  stats_.map_cpu_ms = cpu_maps - cpu_start;
  stats_.view_cpu_ms = processor_milliseconds() - cpu_maps;
  return resolve(std::move(sums), scene, shared::weight_of_passes(done));
}

}  // namespace

std::unique_ptr<Renderer> make_map_renderer() {
  return std::make_unique<MapRenderer>();
}

}  // namespace plinian
