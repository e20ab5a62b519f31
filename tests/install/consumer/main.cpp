// A program of somebody else: ten lines that render a ball of smoke with the installed library.
#include <core/integrate/dual_march.h>
#include <core/scene/default_lights.h>
#include <viewport/gl_renderer.h>

#include <cstdio>

int main(int argc, char**) {
  using namespace plinian;
  SceneSnapshot scene{.media = {Medium{.shape = MediumShape::sphere}}, .width = 16, .height = 16};
  scene.camera = frame_bounds({}, scene_bounds(scene.media), 30.0, 0.0, 16, 16);
  scene.lights = {default_key(scene.camera)};
  const Frame frame = argc > 1 ? make_gl_renderer()->render(scene, 1) : DualMarch().render(scene);
  std::printf("middle %g\n", frame.beauty[8 * 16 + 8].x);
  return frame.beauty[8 * 16 + 8].x > 0.01f ? 0 : 1;
}
