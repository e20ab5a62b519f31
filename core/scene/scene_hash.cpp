// Scene hash: fields one by one, so that padding and field order in memory do not matter.
#include "core/scene/scene_hash.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <type_traits>

namespace plinian {

namespace {

class Hasher {
 public:
  // The finaliser of MurmurHash3 (Appleby, public domain) over a running state.
  void add_word(std::uint64_t word) {
    state_ = (std::rotl(state_, 23) ^ word) * 0xff51afd7ed558ccdull;
    state_ ^= state_ >> 33;
  }
  template <class T>
  void add(const T& value) {
    if constexpr (std::is_enum_v<T> || std::is_integral_v<T>)
      add_word(std::uint64_t(value));
    else if constexpr (std::is_same_v<T, float>)
      add_word(std::bit_cast<std::uint32_t>(value == 0.0f ? 0.0f : value));  // -0 shows what 0 shows
    else if constexpr (std::is_same_v<T, double>)
      add_word(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value));
    else
      for (int i = 0; i < value.length(); ++i) add(value[i]);  // vectors and matrices
  }
  template <class T>
  void add_array(const std::vector<T>& values) {
    static_assert(std::has_unique_object_representations_v<T>);
    add(values.size());
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    std::size_t left = values.size() * sizeof(T);
    for (; left >= 8; left -= 8, bytes += 8) {
      std::uint64_t word;
      std::memcpy(&word, bytes, 8);
      add_word(word);
    }
    std::uint64_t rest = 0;
    std::memcpy(&rest, bytes, left);
    add_word(rest);
  }
  template <class... T>
  void add_all(const T&... values) {
    (add(values), ...);
  }
  std::uint64_t result() const { return state_; }

 private:
  std::uint64_t state_ = 0x9e3779b97f4a7c15ull;
};

void add_volume(Hasher& hash, const BrickVolume& volume) {
  hash.add_all(volume.origin, volume.root_dims, volume.levels, volume.density_max, volume.temperature_max,
               volume.medium_from_index);
  hash.add_array(volume.density);
  hash.add_array(volume.temperature);
  // Bricks say nothing of where they are; the tree does.
  for (const auto* entries : {&volume.root, &volume.nodes}) {
    hash.add(entries->size());
    for (const BrickEntry& entry : *entries) hash.add_all(entry.x, entry.y);
  }
}

void add_medium(Hasher& hash, const Medium& medium) {
  hash.add_all(medium.shape, medium.world_from_medium, medium.density_scale, medium.sigma_s, medium.sigma_a,
               medium.phase.kind, medium.phase.g, medium.phase.g_back, medium.phase.blend);
  hash.add_all(medium.emission.scale, medium.emission.exposure, medium.emission.temperature_scale,
               medium.emission.temperature_offset);
  if (medium.shape == MediumShape::voxels && medium.volume) add_volume(hash, *medium.volume);
}

}  // namespace

std::uint64_t scene_hash(const SceneSnapshot& scene) {
  Hasher hash;
  const Camera& camera = scene.camera;
  hash.add_all(camera.world_from_camera, camera.focal_length, camera.film_back, camera.fit,
               camera.film_offset, camera.pixel_aspect, camera.near_clip, scene.width, scene.height,
               scene.ambient, scene.background);
  hash.add(scene.media.size());
  for (const Medium& medium : scene.media) add_medium(hash, medium);
  hash.add(scene.lights.size());
  for (const Light& light : scene.lights)
    hash.add_all(light.type, light.toward, light.position, light.colour, light.intensity, light.exposure,
                 light.falloff, light.radius, light.cone_angle, light.penumbra);
  return hash.result();
}

std::uint64_t volume_hash(const BrickVolume& volume) {
  Hasher hash;
  add_volume(hash, volume);
  return hash.result();
}

std::string scene_hash_text(const SceneSnapshot& scene) {
  return fmt::format("{:016x}", scene_hash(scene));
}

}  // namespace plinian
