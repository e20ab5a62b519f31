#include "core/image/image_io.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::scene {
namespace {

TEST(CameraImporters, AChanFileIsAKeyedCamera) {
  TemporaryFolder folder;
  TestWorkspace w;
  folder.write("move.chan", "1 0 0 10 0 0 0 30\n3 4 0 10 0 90 0 60\n\n");
  EXPECT_EQ(w.run("import " + folder / "move.chan"), "move");
  w.run("currentTime 2");
  EXPECT_DOUBLE_EQ(w.snapshot().camera.world_from_camera[3].x, 2.0);
  w.run("currentTime 3");
  const SceneSnapshot s = w.snapshot();
  // Looking along -z, turned by 90 degrees about y, is looking along -x.
  EXPECT_NEAR(s.camera.world_from_camera[2].x, 1.0, 1e-12);
  // Its vertical field of view is 60 degrees, whatever the picture's shape.
  EXPECT_NEAR(glm::length(camera_rays(s.camera, 300, 100).up), std::tan(glm::radians(30.0)), 1e-6);
}

TEST(CameraImporters, ABadChanFileIsOneLineThatNamesTheLine) {
  TemporaryFolder folder;
  TestWorkspace w;
  folder.write("a.chan", "1 0 0 10 0 0 0\n2 0 0 x 0 0 0\n");
  EXPECT_TRUE(w.refusal("import " + folder / "a.chan").starts_with(folder / "a.chan:2: "));
  folder.write("a.chan", "1 0 0 10\n");
  EXPECT_NE(w.refusal("import " + folder / "a.chan").find("a.chan:1: expected a frame"), std::string::npos);
  folder.write("a.chan", "# nothing\n");
  EXPECT_NE(w.refusal("import " + folder / "a.chan").find("holds no frame"), std::string::npos);
  EXPECT_EQ(w.run("ls -type camera"), "");
}

TEST(CameraImporters, TheHeaderOfAnExrGivesItsCameraBack) {
  TemporaryFolder folder;
  Image image = make_image(4, 4);
  Camera camera = look_at({3, 4, 10}, {0, 2, 0}, {0, 1, 0}, 40.0);
  camera.focal_length = 50.0f;
  add_camera_metadata(image, camera);
  write_image(folder / "shot.exr", image);
  TestWorkspace w;
  EXPECT_EQ(w.run("import " + folder / "shot.exr"), "shot");
  const Camera read = w.snapshot().camera;
  for (int i = 0; i < 16; ++i)
    EXPECT_NEAR(read.world_from_camera[i / 4][i % 4], camera.world_from_camera[i / 4][i % 4], 1e-5) << i;
  EXPECT_EQ(read.focal_length, 50.0f);
  write_image(folder / "plain.exr", make_image(4, 4));
  EXPECT_NE(w.refusal("import " + folder / "plain.exr").find("has no camera"), std::string::npos);
}

}  // namespace
}  // namespace plinian::scene
