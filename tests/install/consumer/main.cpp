// A program of somebody else: ten lines that render a ball of smoke with the installed library.
#include <core/integrate/dual_march.h>
#include <core/scene/default_lights.h>

#include <cstdio>

int main() {
  plinian::SceneSnapshot scene{
      .media = {plinian::Medium{.shape = plinian::MediumShape::sphere}}, .width = 16, .height = 16};
  scene.camera = plinian::frame_bounds({}, plinian::scene_bounds(scene.media), 30.0, 0.0, 16, 16);
  scene.lights = {plinian::default_key(scene.camera)};
  const plinian::Frame frame = plinian::DualMarch().render(scene);
  std::printf("middle %g\n", frame.beauty[8 * 16 + 8].x);
  return frame.beauty[8 * 16 + 8].x > 0.01f ? 0 : 1;
}
