#include "core/scene/scene_loader.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::scene {
namespace {

TEST(ViewCommands, FrameViewShowsEverythingFromWhereTheCameraLooks) {
  TestWorkspace w(small_scene("sphere"));
  w.run("setAttr medium_place.translate 50 0 0\nsetAttr camera.rotate 0 90 0");
  EXPECT_EQ(w.run("frameView"), "camera");
  const SceneSnapshot s = w.snapshot();
  const dvec3 eye(s.camera.world_from_camera[3]), back(s.camera.world_from_camera[2]);
  EXPECT_NEAR(back.x, 1.0, 1e-9) << "it looks along -x as before";
  EXPECT_NEAR(eye.y, 0.0, 0.1);
  EXPECT_GT(eye.x, 51.0);
  EXPECT_LT(eye.x, 60.0);
  w.run("frameView -azimuth 0 -elevation 90");
  EXPECT_NEAR(w.snapshot().camera.world_from_camera[2].y, 1.0, 1e-9);
  w.run("undo");
  EXPECT_NEAR(w.snapshot().camera.world_from_camera[2].x, 1.0, 1e-9);
}

TEST(ViewCommands, FrameViewFromStraightAboveKeepsTheSideThatItWasTurnedTo) {
  TestWorkspace w(small_scene("sphere"));
  w.run("setAttr camera.rotate -90 40 0\nframeView");
  const dmat4 stands = w.snapshot().camera.world_from_camera;
  EXPECT_NEAR(glm::distance(dvec3(stands[0]),
                            dvec3(std::cos(glm::radians(40.0)), 0.0, -std::sin(glm::radians(40.0)))),
              0.0, 1e-6);
}

TEST(ViewCommands, FrameViewGoesOnTellingWhileWorkersMakeTheVolumeAndCanBeGivenUp) {
  TestWorkspace w(small_scene("cloud"));
  w.run("setAttr medium_noise.resolution 96");
  w.run("setAttr camera.translate 1 2 3");
  int told = 0;
  w.session().on_progress = [&](double) { return ++told < 3; };
  EXPECT_THROW(w.session().execute("frameView"), SceneLoadCancelled);
  EXPECT_GE(told, 3);
  EXPECT_EQ(w.run("getAttr camera.translate.x"), "1");
  told = 0;
  w.session().on_progress = [&](double) { return ++told > 0; };
  const std::uint64_t made = w.computes("volumeNoise");
  w.run("frameView");
  EXPECT_GT(told, 4);
  EXPECT_EQ(w.computes("volumeNoise"), made + 1);
  EXPECT_NE(w.run("getAttr camera.translate.x"), "1");
  told = 0;
  w.run("frameView");
  EXPECT_EQ(told, 0) << "it is there";
}

TEST(ViewCommands, FrameViewWorksUnderATransformAndForSingleNodes) {
  TestWorkspace w;
  w.run(
      "createNode transform -name t\nsetAttr t.translate 1 2 3\nsetAttr t.rotate 10 20 30\ncreateNode camera "
      "-name c -parent t\n"
      "createNode transform -name far\nsetAttr far.translate 0 0 -100\ncreateNode atfmVolume -name "
      "a\nsetAttr a.draw box\n"
      "createNode atfmVolume -name b -parent far\nsetAttr b.draw box\nframeView b -azimuth 90 -elevation 0");
  const dmat4 camera = w.snapshot().camera.world_from_camera;
  EXPECT_NEAR(camera[3].z, -100.0, 1e-6);
  EXPECT_NEAR(camera[2].x, 1.0, 1e-9);
}

TEST(ViewCommands, IsolateAndSnapshotTellWhatIsSeen) {
  TestWorkspace w;
  w.run(
      "createNode atfmVolume -name a\nsetAttr a.draw box\ncreateNode atfmVolume -name b\nsetAttr b.draw "
      "box\nisolate a");
  EXPECT_NE(w.run("snapshot").find("medium a 0 voxels"), std::string::npos);
  EXPECT_EQ(w.run("snapshot").find("medium b"), std::string::npos);
  const std::string isolated = w.run("snapshot");
  w.run("isolate -off");
  EXPECT_NE(w.run("snapshot").find("medium b"), std::string::npos);
  EXPECT_NE(w.run("snapshot"), isolated);
}

TEST(ViewCommands, FrameViewRefusesWhatCannotBeFramed) {
  TestWorkspace w;
  EXPECT_EQ(w.refusal("frameView"), "frameView: the scene has no camera: createNode camera makes one");
  w.run("createNode camera -name c\ncreateNode directionalLight -name sun");
  EXPECT_EQ(w.refusal("frameView"), "frameView: there is nothing to frame: no volume is shown");
  w.run("createNode atfmVolume -name a\nsetAttr a.draw box");
  EXPECT_EQ(w.refusal("frameView sun"), "frameView: there is no volume to frame in sun");
  EXPECT_EQ(w.refusal("frameView -camera sun"), "frameView: sun (directionalLight) is no camera");
  w.run("setAttr a.draw volume");
  EXPECT_EQ(
      w.refusal("frameView"),
      "frameView: there is nothing to frame: no volume is shown: a.contribution: no volume is connected");
}

TEST(ViewCommands, AReferenceHasToBeThere) {
  TemporaryFolder folder;
  TestWorkspace w;
  EXPECT_EQ(w.refusal("loadReference \"" + folder / "missing.exr" + "\""),
            "loadReference: " + folder / "missing.exr" + ": there is no such file");
  EXPECT_EQ(w.refusal("loadReference \"" + folder / "ref.####.exr" + "\""),
            "loadReference: " + folder / "ref.####.exr" + ": no file of that sequence is there");
  EXPECT_EQ(w.run("ls -type referenceImage"), "");
}

}  // namespace
}  // namespace plinian::scene
