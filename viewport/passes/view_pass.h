// One jittered pass of the view march on the GPU.
#pragma once

#include <functional>

#include "core/integrate/flat_scene.h"
#include "core/scene/pixel_box.h"
#include "core/scene/snapshot.h"
#include "viewport/passes/program_cache.h"
#include "viewport/passes/scene_blocks.h"

namespace plinian::passes {

/// Which layers of the sums hold what: 0 transmittance and depth, then ambient and emission where the scene
/// has them
/// (-1 where not), then one for each light.
struct PlaneLayout {
  int ambient = -1;
  int emission = -1;
  int first_light = 1;
  int count = 1;
};
PlaneLayout plane_layout(const FlatScene& flat, const SceneSnapshot& scene);

class ViewPass {
 public:
  /// Adds pass number `pass` to the planes of `sums` (RGBA32F, see plane_layout()), or writes them where it
  /// is the `first` there, in the pixels of `box` and some beside it. `go_on` is asked between tiles; returns
  /// false where it said no. maps may be empty where light is marched.
  bool render(const SceneBlocks& blocks, const FlatScene& flat, const SceneSnapshot& scene,
              const gl::TexelBuffer& maps, int pass, bool first, PixelBox box, const gl::Texture& sums,
              const std::function<bool()>& go_on);
  /// To be called behind the last pass of a picture: see ProgramCache.
  void end_picture() { programs_.end_picture(); }

 private:
  ProgramCache programs_{"viewport/passes/view.comp"};
  gl::Buffer view_;
};

}  // namespace plinian::passes
