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

TEST(CameraImporters, AChanFileSaysNeitherOrderNorUnitSoThatFlagsDo) {
  TemporaryFolder folder;
  TestWorkspace w;
  const std::string file = folder.write("move.chan", "1 100 200 300 10 20 30\n");
  const auto placed = [&](const std::string& flags) {
    const std::string camera = w.run("import " + file + " " + flags);
    const dmat4 matrix = [&] {
      w.view().camera = w.session().graph().get(camera).id;
      return w.snapshot().camera.world_from_camera;
    }();
    return std::pair(w.run("getAttr " + camera + ".rotate_order"), dvec3(matrix[3]));
  };
  EXPECT_EQ(placed(""), std::pair(std::string("zxy"), dvec3(100, 200, 300)));
  EXPECT_EQ(placed("-rotateOrder xyz -unit cm"), std::pair(std::string("xyz"), dvec3(1, 2, 3)));
  EXPECT_EQ(placed("-unit 0.5").second, dvec3(50, 100, 150));
  EXPECT_EQ(w.refusal("import " + file + " -rotateOrder zzz"),
            "import: -rotateOrder 'zzz' is none of xyz, yzx, zxy, xzy, yxz, zyx");
  EXPECT_EQ(w.refusal("import " + file + " -unit furlong"),
            "import: -unit expects mm, cm, m, km, in, ft or a number of metres, not 'furlong'");
  EXPECT_EQ(w.refusal("import " + file + " -grid density"),
            "import: -grid means nothing for files of the type 'chan', which take -rotateOrder, -unit");
  // Rows of channels alone, as Houdini writes them.
  folder.write("move.chan", "5 0 0 0 0 0 40\n4 0 0 0 0 0 40\n");
  EXPECT_EQ(w.refusal("import " + file),
            file + ":2: the first number of a line is its frame, and 4 does not come after 5");
}

}  // namespace
}  // namespace plinian::scene
