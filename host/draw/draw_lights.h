// The lights of the picture beneath what plug-ins draw, with the maps by which shaders look them up.
#pragma once

#include <vector>

#include "core/lights/light.h"
#include "core/scene/snapshot.h"
#include "host/sdk/abi.h"
#include "viewport/gl_renderer.h"

namespace plinian::draw {

/// A light, and its map where the renderer has one (where not, GlLightMap::glsl is null).
struct DrawLight {
  Light light;
  GlLightMap map = {};
};

/// The lights of a picture of that scene. maps: of it, in the order of its lights; fewer where it had none.
std::vector<DrawLight> lights_of(const SceneSnapshot& scene, const std::vector<GlLightMap>& maps);

/// Lights as plug-ins are given them.
class PlainLights {
 public:
  PlainLights() = default;
  explicit PlainLights(std::vector<DrawLight> lights);
  PlainLights(const PlainLights&) = delete;
  PlainLights& operator=(PlainLights&&) = default;

  /// Good for as long as this is neither destroyed nor assigned to.
  void put_into(PlinianDrawContext& context) const;

 private:
  std::vector<DrawLight> from_;
  std::vector<PlinianDrawLight> lights_;
  std::vector<PlinianLightMap> maps_;
  std::vector<const PlinianLightMap*> map_of_light_;
};

}  // namespace plinian::draw
