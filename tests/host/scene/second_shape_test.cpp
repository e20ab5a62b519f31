// A volume shape of somebody else's beside atfmVolume: each throws its shadow on the other.
#include <cstdlib>

#include "core/image/metrics.h"
#include "core/integrate/dual_march.h"
#include "core/integrate/map_renderer.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::scene {
namespace {

constexpr int size = 96;

// Built outside the tree by the installation's test, else as a part of the tests.
std::string library() {
  const char* folder = std::getenv("PLINIAN_SECOND_SHAPE");
  return std::string(folder ? folder : PLINIAN_TEST_PLUGINS) + "/puff.so";
}

// Ball and puff overlap by a third; the camera looks along -z, light comes from the side of `toward`.
std::string overlapping(const std::string& light_turn) {
  return "loadPlugin \"" + library() +
         "\"\n"
         "createNode medium -name smoke\nsetAttr smoke.density_scale 6\n"
         "createNode transform -name left\nsetAttr left.translate -0.6 0 0\n"
         "createNode atfmVolume -name ball -parent left\nsetAttr ball.draw sphere\n"
         "connectAttr smoke.out ball.medium\n"
         "createNode transform -name right\nsetAttr right.translate 0.7 0.1 0.2\n"
         "createNode puff -name puff1 -parent right\nconnectAttr smoke.out puff1.medium\n"
         "createNode transform -name lamp\nsetAttr lamp.rotate 0 " +
         light_turn +
         " 0\ncreateNode directionalLight -name key -parent lamp\nsetAttr key.exposure 2\n"
         "createNode transform -name stand\nsetAttr stand.translate 0 0 7\n"
         "createNode camera -name eye -parent stand\nsetAttr eye.focal_length 45";
}

SceneSnapshot snapshot_of(TestWorkspace& w) {
  w.view().size = ivec2(size, size);
  return w.snapshot();
}

// Mean radiance of a patch of 9 x 9 pixels around a point of the picture's middle row [share of its width].
double brightness(const Frame& frame, double x) {
  double sum = 0.0;
  for (int dy = -4; dy <= 4; ++dy)
    for (int dx = -4; dx <= 4; ++dx)
      sum += frame.beauty[std::size_t((size / 2 + dy) * size + int(x * size) + dx)].y;
  return sum / 81.0;
}

TEST(SecondShape, OverlapsAnAtfmVolumeAsTheReferenceSees) {
  TestWorkspace w;
  w.run(overlapping("-60"));
  const SceneSnapshot snapshot = snapshot_of(w);
  ASSERT_EQ(snapshot.media.size(), 2u);
  const Frame picture = make_map_renderer()->render(snapshot, 1);
  const Frame reference = DualMarch().render(snapshot);
  const auto pair = pair_pictures(frame_to_image(picture), frame_to_image(reference));
  EXPECT_GT(pixel_metrics(pair).psnr, 35.0);
}

TEST(SecondShape, AndAnAtfmVolumeShadowEachOther) {
  for (const bool from_right : {true, false}) {
    TestWorkspace w;
    w.run(overlapping(from_right ? "90" : "-90"));
    // A directional light shines along -z, so that turned by 90 degrees about y it stands at +x.
    const std::string blocker = from_right ? "right" : "left";
    const double behind = from_right ? 0.3 : 0.7;
    const double shadowed = brightness(make_map_renderer()->render(snapshot_of(w), 1), behind);
    w.run("setAttr " + blocker + ".visibility false");
    const double lit = brightness(make_map_renderer()->render(snapshot_of(w), 1), behind);
    EXPECT_GT(lit, 0.01) << blocker;
    EXPECT_LT(shadowed, 0.5 * lit) << blocker;
  }
}

TEST(SecondShape, IsUndoneUnloadedAndComesBack) {
  TestWorkspace w;
  w.run(overlapping("0"));
  EXPECT_NE(w.refusal("unloadPlugin puff").find("puff1"), std::string::npos);
  w.run("delete puff1");
  EXPECT_EQ(w.snapshot().media.size(), 1u);
  w.run("undo");
  EXPECT_EQ(w.snapshot().media.size(), 2u);
  w.run("setAttr puff1.visibility off");
  EXPECT_EQ(w.snapshot().media.size(), 1u) << "every shape can be hidden, whoever declares it";
  w.run("undo\nunloadPlugin -force puff");
  EXPECT_EQ(w.snapshot().media.size(), 1u) << "an unknown node adds nothing, and keeps its place";
  w.run("loadPlugin \"" + library() + "\"");
  EXPECT_EQ(w.snapshot().media.size(), 2u);
}

}  // namespace
}  // namespace plinian::scene
