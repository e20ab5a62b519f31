// Field by field.
#include "host/window/view/same_picture.h"

#include <algorithm>

#include "core/scene/quality_parameters.h"

namespace plinian::window {

namespace {

bool same(const Medium& a, const Medium& b) {
  return a.name == b.name && a.shape == b.shape && a.volume == b.volume &&
         a.world_from_medium == b.world_from_medium && a.density_scale == b.density_scale &&
         a.sigma_s == b.sigma_s && a.sigma_a == b.sigma_a && a.phase.kind == b.phase.kind &&
         a.phase.g == b.phase.g && a.phase.g_back == b.phase.g_back && a.phase.blend == b.phase.blend &&
         a.emission.scale == b.emission.scale && a.emission.exposure == b.emission.exposure &&
         a.emission.temperature_scale == b.emission.temperature_scale &&
         a.emission.temperature_offset == b.emission.temperature_offset;
}

bool same(const Light& a, const Light& b) {
  return a.name == b.name && a.type == b.type && a.toward == b.toward && a.position == b.position &&
         a.colour == b.colour && a.intensity == b.intensity && a.exposure == b.exposure &&
         a.falloff == b.falloff && a.radius == b.radius && a.cone_angle == b.cone_angle &&
         a.penumbra == b.penumbra;
}

bool same(const Quality& a, const Quality& b) {
  return std::all_of(
      quality_parameters().begin(), quality_parameters().end(),
      [&](const Parameter<Quality>& p) { return to_text(p.spec, *p.get(a)) == to_text(p.spec, *p.get(b)); });
}

template <class T>
bool all_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same(x, y); });
}

}  // namespace

bool same_camera(const Camera& a, const Camera& b) {
  return a.world_from_camera == b.world_from_camera && a.focal_length == b.focal_length &&
         a.film_back == b.film_back && a.fit == b.fit && a.film_offset == b.film_offset &&
         a.pixel_aspect == b.pixel_aspect && a.near_clip == b.near_clip;
}

bool same_picture(const SceneSnapshot& a, const SceneSnapshot& b) {
  return a.width == b.width && a.height == b.height && a.ambient == b.ambient &&
         a.background == b.background && same_camera(a.camera, b.camera) && all_same(a.media, b.media) &&
         all_same(a.lights, b.lights) && same(a.quality, b.quality);
}

}  // namespace plinian::window
