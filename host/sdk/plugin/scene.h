// What a shape adds to the picture: media, lights, cameras, bounds, in its own object space.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/context.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

using Colour = std::array<float, 3>;  // linear Rec.709
using Vector = std::array<float, 3>;

enum class MediumShape : std::uint32_t { voxels, box, sphere };  // box [-1, 1]^3, sphere of radius 1
enum class PhaseKind : std::uint32_t { isotropic, henyey_greenstein, schlick, two_lobe };
enum class LightType : std::uint32_t { directional, spot, point, ambient };
enum class Falloff : std::uint32_t { inverse_square, linear, none };
enum class FilmFit : std::uint32_t { fill, horizontal, vertical, overscan };

/// Fields as in PlinianMedium.
struct Medium {
  std::string name{};
  MediumShape shape = MediumShape::voxels;
  Volume volume{};
  Matrix object_from_medium = identity;
  float density_scale = 1.0f;
  Colour sigma_s{0.8f, 0.8f, 0.8f}, sigma_a{0.2f, 0.2f, 0.2f};
  PhaseKind phase = PhaseKind::isotropic;
  float g = 0.0f, g_back = 0.0f, blend = 0.0f;
  float emission_scale = 0.0f, emission_exposure = 0.0f;
  float temperature_scale = 1.0f, temperature_offset = 0.0f;
};

/// Fields as in PlinianLight.
struct Light {
  std::string name{};
  LightType type = LightType::directional;
  Vector toward{0.0f, 0.0f, 1.0f}, position{};
  Colour colour{1.0f, 1.0f, 1.0f};
  float intensity = 1.0f, exposure = 0.0f;
  Falloff falloff = Falloff::inverse_square;
  float radius = 0.0f, cone_angle = 40.0f, penumbra = 5.0f;
};

/// Fields as in PlinianCamera.
struct Camera {
  std::string name{};
  Matrix object_from_camera = identity;
  float focal_length = 35.0f;
  std::array<float, 2> film_back{36.0f, 24.0f};
  FilmFit fit = FilmFit::fill;
  std::array<float, 2> film_offset{};
  float pixel_aspect = 1.0f, near_clip = 0.0f;
};

namespace detail {

// The C form; good as long as the medium.
inline PlinianMedium plain(const Medium& m) {
  PlinianMedium plain{};
  plain.size = sizeof(plain);
  plain.name = m.name.c_str();
  plain.shape = std::uint32_t(m.shape);
  plain.volume = m.volume.handle;
  std::copy(m.object_from_medium.begin(), m.object_from_medium.end(), plain.object_from_medium);
  plain.density_scale = m.density_scale;
  std::copy(m.sigma_s.begin(), m.sigma_s.end(), plain.sigma_s);
  std::copy(m.sigma_a.begin(), m.sigma_a.end(), plain.sigma_a);
  plain.phase = std::uint32_t(m.phase);
  plain.g = m.g;
  plain.g_back = m.g_back;
  plain.blend = m.blend;
  plain.emission_scale = m.emission_scale;
  plain.emission_exposure = m.emission_exposure;
  plain.temperature_scale = m.temperature_scale;
  plain.temperature_offset = m.temperature_offset;
  return plain;
}

}  // namespace detail

/// How a medium looks, as an input of the data type "medium" has it; the default look where
/// nothing is connected. Its name, shape, volume and matrix are left for the caller.
inline Medium look_of(const Context& context, Attribute input) {
  Medium m;
  const auto* from = static_cast<const PlinianMedium*>(context.data(input));
  if (!from) return m;
  PlinianMedium plain{};  // one that was made by an older plug-in is shorter
  std::memcpy(&plain, from, std::min(sizeof(plain), from->size));
  m.density_scale = plain.density_scale;
  std::copy_n(plain.sigma_s, 3, m.sigma_s.begin());
  std::copy_n(plain.sigma_a, 3, m.sigma_a.begin());
  m.phase = PhaseKind(plain.phase);
  m.g = plain.g;
  m.g_back = plain.g_back;
  m.blend = plain.blend;
  m.emission_scale = plain.emission_scale;
  m.emission_exposure = plain.emission_exposure;
  m.temperature_scale = plain.temperature_scale;
  m.temperature_offset = plain.temperature_offset;
  return m;
}

/// Hands a look on, through an output of the data type "medium". content: equal for equal looks.
inline void set_look(Context& context, Attribute output, const Medium& look, std::uint64_t content) {
  auto plain = std::make_unique<PlinianMedium>(detail::plain(look));
  plain->name = nullptr;
  plain->volume = nullptr;
  context.set_data(output, PLINIAN_MEDIUM_TYPE, std::unique_ptr<const PlinianMedium>(std::move(plain)),
                   sizeof(PlinianMedium), content);
}

/// Takes what a shape contributes. Throws Error for what makes no sense.
class Contribution {
 public:
  Contribution(const PlinianContribute& table, PlinianContribution* contribution, const Context& context)
      : table_(table), contribution_(contribution), context_(context) {}

  void add(const Medium& m) {
    const PlinianMedium plain = detail::plain(m);
    context_.check(table_.add_medium(contribution_, &plain));
  }
  void add(const Light& l) {
    PlinianLight plain{};
    plain.size = sizeof(plain);
    plain.name = l.name.c_str();
    plain.type = std::uint32_t(l.type);
    std::copy(l.toward.begin(), l.toward.end(), plain.toward);
    std::copy(l.position.begin(), l.position.end(), plain.position);
    std::copy(l.colour.begin(), l.colour.end(), plain.colour);
    plain.intensity = l.intensity;
    plain.exposure = l.exposure;
    plain.falloff = std::uint32_t(l.falloff);
    plain.radius = l.radius;
    plain.cone_angle = l.cone_angle;
    plain.penumbra = l.penumbra;
    context_.check(table_.add_light(contribution_, &plain));
  }
  void add(const Camera& c) {
    PlinianCamera plain{};
    plain.size = sizeof(plain);
    plain.name = c.name.c_str();
    std::copy(c.object_from_camera.begin(), c.object_from_camera.end(), plain.object_from_camera);
    plain.focal_length = c.focal_length;
    std::copy(c.film_back.begin(), c.film_back.end(), plain.film_back);
    plain.fit = std::uint32_t(c.fit);
    std::copy(c.film_offset.begin(), c.film_offset.end(), plain.film_offset);
    plain.pixel_aspect = c.pixel_aspect;
    plain.near_clip = c.near_clip;
    context_.check(table_.add_camera(contribution_, &plain));
  }
  /// Of what only a viewport shows: the bounds of media are known.
  void add_bounds(const std::array<double, 3>& minimum, const std::array<double, 3>& maximum) {
    context_.check(table_.add_bounds(contribution_, minimum.data(), maximum.data()));
  }

 private:
  const PlinianContribute& table_;
  PlinianContribution* contribution_;
  const Context& context_;
};

}  // namespace sdk
}  // namespace plinian
