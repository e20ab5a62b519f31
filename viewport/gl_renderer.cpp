// How the GL renderer puts its passes together: volumes and maps that the scene still needs stay on the GPU
// from one call to the next; everything is made again when the context was lost.
#include "viewport/gl_renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "core/integrate/media_pixels.h"
#include "core/scene/frame_layers.h"
#include "core/scene/rest_gauge.h"
#include "core/shared/pass_weight.h"
#include "core/transmittance/map_key.h"
#include "viewport/gl/egl_context.h"
#include "viewport/passes/map_pass.h"
#include "viewport/passes/view_pass.h"

namespace plinian {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Thrown where the context has gone; what was on the GPU is lost with it.
struct ContextLost : std::runtime_error {
  ContextLost() : std::runtime_error("the OpenGL context was lost") {}
};

/// What is kept on the GPU for one batch of lights.
struct BatchState {
  gl::TexelBuffer maps;  // see map_texel() in scene_access.glsl
  gl::Texture sums;
  std::size_t map_texels = 0;  // RGBA32UI
  ivec3 sums_size{0};
  std::vector<std::optional<MapKey>> built;  // one per layer of maps
  gl::Buffer block;                          // for light_maps(): lights and maps, see light_lookup.glsl
  std::shared_ptr<const std::string> glsl;   // likewise
  std::size_t light_count = 0;               // of the last picture; 0: it had no maps
  std::uint64_t version = 0;                 // of the texels of the maps
};

/// Everything that lives on the GPU: gone as a whole when the context is lost.
struct GpuState {
  struct CachedVolume {
    std::shared_ptr<const BrickVolume> volume;  // kept, so that its address stays its identity
    passes::VolumeTextures textures;
  };
  std::unordered_map<const BrickVolume*, CachedVolume> volumes;
  passes::SceneBlocks blocks;
  passes::MapPass map_pass;
  passes::ViewPass view_pass;
  std::vector<BatchState> batches;        // map-based passes
  std::vector<BatchState> exact_batches;  // passes that march to the light: sums only

  void end_picture() {
    map_pass.end_picture();
    view_pass.end_picture();
  }
};

class GlRenderer final : public Renderer {
 public:
  explicit GlRenderer(bool own_context) : own_context_(own_context) {
    if (own_context_) context_.emplace();
  }
  ~GlRenderer() override {
    if (context_) context_->try_make_current();
  }

  Frame render(const SceneSnapshot& scene, const Passes& passes, const Progress& progress) override;
  const RenderStats& stats() const override { return stats_; }
  std::vector<GlLightMap> light_maps() const;

 private:
  bool context_lost();
  void make_context_again();
  void let_go();
  std::vector<const passes::VolumeTextures*> upload(const FlatScene& flat);
  std::shared_ptr<const std::string> kept_text(std::string text);
  void publish(const FlatScene& flat, BatchState& batch);
  bool build_maps(FlatScene& flat, BatchState& batch, const std::function<bool()>& go_on);
  Frame render_once(const SceneSnapshot& scene, const Passes& passes, const Progress& progress);

  bool own_context_;
  bool lost_ = false;  // the context has gone
  std::optional<gl::EglContext> context_;
  std::optional<GpuState> gpu_;
  RenderStats stats_;
  std::uint64_t map_versions_ = 0;                         // ever given
  std::vector<std::shared_ptr<const std::string>> texts_;  // of the last kinds of maps, for shaders
};

std::vector<const passes::VolumeTextures*> GlRenderer::upload(const FlatScene& flat) {
  const auto start = Clock::now();
  // What the scene no longer shows goes first: two volumes may not fit side by side.
  std::erase_if(gpu_->volumes, [&](const auto& cached) {
    return std::none_of(flat.volumes.begin(), flat.volumes.end(),
                        [&](const auto& v) { return v.get() == cached.first; });
  });
  std::vector<const passes::VolumeTextures*> textures;
  for (const auto& volume : flat.volumes) {
    if (!volume) {
      textures.push_back(nullptr);
      continue;
    }
    auto found = gpu_->volumes.find(volume.get());
    if (found == gpu_->volumes.end()) {
      found =
          gpu_->volumes.emplace(volume.get(), GpuState::CachedVolume{volume, passes::upload_volume(*volume)})
              .first;
      ++stats_.volume_uploads;
    }
    textures.push_back(&found->second.textures);
  }
  stats_.volume_bytes = 0;
  for (const auto& [key, cached] : gpu_->volumes) stats_.volume_bytes += cached.textures.bytes;
  stats_.upload_ms = milliseconds_since(start);
  return textures;
}

// Returns whether a map that was there serves by a power, which is then among its exponents.
bool GlRenderer::build_maps(FlatScene& flat, BatchState& batch, const std::function<bool()>& go_on) {
  const std::size_t texels = std::size_t(flat.layout.resolution) * flat.layout.resolution *
                             words_per_texel(flat.layout.coefficients) *
                             std::max<std::size_t>(1, flat.maps.size());
  if (batch.map_texels != texels || batch.built.size() != flat.maps.size()) {
    batch.maps = gl::make_texel_buffer(GL_RGBA32UI, texels, sizeof(uvec4), nullptr);
    batch.map_texels = texels;
    batch.built.assign(flat.maps.size(), std::nullopt);
    batch.version = ++map_versions_;
  }
  bool raises = false;
  for (std::size_t i = 0; i < flat.maps.size(); ++i) {
    MapKey key = map_key(flat, int(i));
    const auto power = batch.built[i] ? map_power(*batch.built[i], key, flat.extinction_reuse) : std::nullopt;
    if (power) {
      raises = raises || *power != 1.0f;
      flat.maps[i].exponent *= *power;
      continue;
    }
    batch.built[i].reset();
    batch.version = ++map_versions_;
    if (!gpu_->map_pass.build(gpu_->blocks, flat, int(i), batch.maps, go_on)) throw RenderCancelled();
    batch.built[i] = std::move(key);
    ++stats_.map_builds;
  }
  stats_.map_bytes += texels * sizeof(uvec4);
  return raises;
}

// The same object for the same text, so that whoever made a program with it finds that again: quick maps and
// those at rest take turns.
std::shared_ptr<const std::string> GlRenderer::kept_text(std::string text) {
  for (const auto& kept : texts_)
    if (*kept == text) return kept;
  constexpr std::size_t most = 8;
  if (texts_.size() == most) texts_.erase(texts_.begin());
  texts_.push_back(std::make_shared<const std::string>(std::move(text)));
  return texts_.back();
}

// What light_maps() tells of a batch of lights whose maps are built.
void GlRenderer::publish(const FlatScene& flat, BatchState& batch) {
  struct Block {
    LightData lights[max_lights];
    MapData maps[max_maps];
  };
  const auto block = std::make_unique<Block>();
  std::copy(flat.lights.begin(), flat.lights.end(), block->lights);
  std::copy(flat.maps.begin(), flat.maps.end(), block->maps);
  if (!batch.block) batch.block = gl::make_buffer(sizeof(Block), nullptr);
  gl::update_buffer(batch.block, sizeof(Block), block.get());
  std::string glsl = gl::shader_part("viewport/passes/light_lookup.glsl",
                                     {{"GROUP_COUNT", std::to_string(flat.group_count)},
                                      {"MAP_COEFFICIENTS", std::to_string(flat.layout.coefficients)},
                                      {"MAP_WEIGHTING", std::to_string(flat.layout.weighting)}});
  if (!batch.glsl || *batch.glsl != glsl) batch.glsl = kept_text(std::move(glsl));
  batch.light_count = flat.lights.size();
}

std::vector<GlLightMap> GlRenderer::light_maps() const {
  std::vector<GlLightMap> result;
  if (!gpu_) return result;
  for (const BatchState& batch : gpu_->batches)
    for (std::size_t l = 0; l < batch.light_count; ++l)
      result.push_back({batch.maps.texture.name(), batch.block.name(), int(l), batch.glsl, batch.version});
  return result;
}

/// Adds what passes of `weight` together of a batch left in `box` of its planes to the sums of a picture; its
/// lights begin at number first_light. Outside the box nothing stands in the way.
void read_sums(const gl::Texture& planes, const FlatScene& flat, const SceneSnapshot& scene, PixelBox box,
               float weight, std::size_t first_light, bool with_media, FrameSums& sums) {
  std::vector<vec4> plane(std::size_t(box.size.x) * box.size.y);
  const auto read = [&](int layer) {
    if (!box.empty())
      glGetTextureSubImage(planes.name(), 0, box.first.x, box.first.y, layer, box.size.x, box.size.y, 1,
                           GL_RGBA, GL_FLOAT, GLsizei(plane.size() * sizeof(vec4)), plane.data());
  };
  const passes::PlaneLayout layout = passes::plane_layout(flat, scene);
  if (with_media) {
    read(0);
    set_media_plane(sums, scene.width, box, plane, weight);
    if (layout.ambient >= 0) {
      read(layout.ambient);
      add_plane(sums.ambient, scene.width, box, plane);
    }
    if (layout.emission >= 0) {
      read(layout.emission);
      add_plane(sums.emission, scene.width, box, plane);
    }
  }
  for (std::size_t l = 0; l < flat.lights.size(); ++l) {
    read(layout.first_light + int(l));
    add_plane(sums.lights[first_light + l], scene.width, box, plane);
  }
}

Frame GlRenderer::render(const SceneSnapshot& scene, const Passes& passes, const Progress& progress) {
  if (passes.most < 1) throw std::invalid_argument("a picture takes at least one pass");
  try {
    return render_once(scene, passes, progress);
  } catch (const RenderCancelled&) {
    throw;
  } catch (const std::runtime_error&) {
    // On a lost context whatever comes next fails: an upload, a shader, a query.
    if (!context_lost()) throw;
  }
  make_context_again();
  try {
    return render_once(scene, passes, progress);
  } catch (const ContextLost&) {
    make_context_again();
    throw std::runtime_error(
        "the OpenGL context was lost again in the same picture; the driver resets the GPU");
  }
}

// Asks whether the context has gone; once it has, it stays so until it is made anew.
bool GlRenderer::context_lost() {
  if (!lost_)
    lost_ = (context_ && !context_->try_make_current()) || glGetGraphicsResetStatus() != GL_NO_ERROR;
  return lost_;
}

// A context of our own is made anew; a window makes its own.
void GlRenderer::make_context_again() {
  lost_ = false;
  if (!own_context_) {
    gpu_.reset();
    throw ContextLost();
  }
  context_.reset();
  context_.emplace();
  gpu_.reset();
  // The names of what was lost mean nothing to the new context, which says so.
  while (glGetError() != GL_NO_ERROR) continue;
}

// Gives everything back. Of what is only deleted, llvmpipe keeps what was bound last until something else is
// rendered (maps of 25 MiB of three lights), and compiled programs.
void GlRenderer::let_go() {
  gpu_.reset();
  if (!own_context_) return;
  context_.reset();
  context_.emplace();
}

Frame GlRenderer::render_once(const SceneSnapshot& scene, const Passes& passes, const Progress& progress) {
  if (context_lost()) throw ContextLost();
  const FlatScene whole = flatten(scene);
  stats_.begin_picture();
  if (whole.media.empty()) {
    // Nothing of the scene before is kept: it may be large, and is not known to come again.
    if (gpu_) let_go();
    stats_.volume_bytes = stats_.map_bytes = 0;
    return empty_frame(scene);
  }
  if (gpu_)
    for (BatchState& batch : gpu_->batches) batch.light_count = 0;
  if (!gpu_) gpu_.emplace();
  const auto textures = upload(whole);
  const PixelBox box = media_pixels(whole, scene.camera, scene.width, scene.height);

  double done = 0.0;
  const std::function<bool()> go_on =
      progress ? std::function<bool()>([&] { return progress(done); }) : std::function<bool()>();
  // Passes beyond the first march to the light where the quality asks for it.
  const bool exact = has_exact_passes(scene.quality.view, passes.most) && !scene.lights.empty();
  std::vector<FlatScene> batches = light_batches(whole);
  std::vector<FlatScene> exact_parts = exact ? exact_batches(whole) : std::vector<FlatScene>();
  gpu_->batches.resize(batches.size());
  gpu_->exact_batches.resize(exact_parts.size());
  const int map_passes = exact_parts.empty() ? passes.most : 1;
  const double jobs =
      double(batches.size()) * map_passes + double(exact_parts.size()) * (passes.most - map_passes);
  double job = 0.0;

  stats_.map_bytes = 0;
  // One pass of some lights; `first` where it is the first in their sums.
  const FlatScene* in_blocks = nullptr;
  const auto render_part = [&](FlatScene& flat, BatchState& state, int pass, bool first) {
    if (in_blocks != &flat) gpu_->blocks.update(flat, textures);
    in_blocks = &flat;
    auto start = Clock::now();
    double cpu_start = processor_milliseconds();
    if (first && flat.view.light != LightLookup::march) {
      if (build_maps(flat, state, go_on)) gpu_->blocks.update(flat, textures);
      publish(flat, state);
      glFinish();
    }
    stats_.map_ms += milliseconds_since(start);
    stats_.map_cpu_ms += processor_milliseconds() - cpu_start;
    start = Clock::now();
    cpu_start = processor_milliseconds();
    const passes::PlaneLayout layout = passes::plane_layout(flat, scene);
    const ivec3 size(scene.width, scene.height, layout.count);
    if (state.sums_size != size) {
      state.sums = gl::make_texture_array(GL_RGBA32F, size);
      state.sums_size = size;
    }
    done = job++ / jobs;
    if (!gpu_->view_pass.render(gpu_->blocks, flat, scene, state.maps, pass, first, box, state.sums, go_on))
      throw RenderCancelled();
    glFinish();
    stats_.view_ms += milliseconds_since(start);
    stats_.view_cpu_ms += processor_milliseconds() - cpu_start;
  };

  // What all parts have gathered in so many passes.
  const auto gather = [&](int passes_done) {
    const float weight = shared::weight_of_passes(passes_done),
                weight_of_maps = shared::weight_of_passes(std::min(passes_done, map_passes));
    FrameSums sums(scene, whole.lights.size());
    std::size_t first_light = 0;
    for (std::size_t b = 0; b < batches.size(); ++b) {
      read_sums(gpu_->batches[b].sums, batches[b], scene, box, weight_of_maps, first_light, b == 0, sums);
      first_light += batches[b].lights.size();
    }
    if (passes_done > map_passes) {
      // Media are seen the same by every light's passes: those of the first count.
      FrameSums rest(scene, whole.lights.size());
      for (std::size_t b = 0; b < exact_parts.size(); ++b)
        read_sums(gpu_->exact_batches[b].sums, exact_parts[b], scene, box, weight - weight_of_maps, b, b == 0,
                  rest);
      add_passes(sums, rest);
    }
    return resolve(std::move(sums), scene, weight);
  };

  Refinement refinement(passes);
  int pass = 0;
  do {
    if (pass < map_passes)
      for (std::size_t b = 0; b < batches.size(); ++b)
        render_part(batches[b], gpu_->batches[b], pass, pass == 0);
    else
      for (std::size_t b = 0; b < exact_parts.size(); ++b)
        render_part(exact_parts[b], gpu_->exact_batches[b], pass, pass == map_passes);
    ++pass;
  } while (refinement.wants_another(pass, [&] { return gather(pass); }));
  if (context_lost()) throw ContextLost();

  Frame frame = gather(pass);
  gpu_->end_picture();
  gl::check_errors("a frame");
  stats_.passes = pass;
  stats_.rest_change = refinement.rest_change();
  return frame;
}

}  // namespace

std::vector<GlLightMap> light_maps(Renderer& renderer) {
  const auto* gl = dynamic_cast<const GlRenderer*>(&renderer);
  return gl ? gl->light_maps() : std::vector<GlLightMap>();
}

std::unique_ptr<Renderer> make_gl_renderer() {
  return std::make_unique<GlRenderer>(true);
}

std::unique_ptr<Renderer> make_gl_renderer_on_current_context() {
  return std::make_unique<GlRenderer>(false);
}

}  // namespace plinian
