// From the graph to the snapshot: who is in it, where, and what an edit costs.
#include "host/scene/snapshot.h"

#include "core/integrate/flat_scene.h"
#include "core/transmittance/map_key.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::scene {
namespace {

TEST(Snapshot, ThingsStandWhereTheHierarchyPutsThem) {
  TestWorkspace w;
  w.run(
      "createNode transform -name outer\nsetAttr outer.translate 0 10 0\n"
      "createNode transform -name inner -parent outer\nsetAttr inner.rotate 0 90 0\n"
      "createNode atfmVolume -name ball -parent inner\nsetAttr ball.draw sphere\n"
      "createNode spotLight -name lamp -parent inner\nsetAttr lamp.translate 0 0 5\n"
      "createNode camera -name eye -parent outer\nsetAttr eye.translate 0 0 30");
  const SceneSnapshot s = w.snapshot();
  ASSERT_EQ(s.media.size(), 1u);
  EXPECT_EQ(s.media[0].name, "ball");
  EXPECT_EQ(dvec3(s.media[0].world_from_medium * dvec4(0, 0, 1, 1)), dvec3(1, 10, 0));
  ASSERT_EQ(s.lights.size(), 1u);
  EXPECT_EQ(s.lights[0].name, "lamp");
  EXPECT_EQ(s.lights[0].position, vec3(5, 10, 0));
  EXPECT_EQ(s.lights[0].toward, vec3(1, 0, 0)) << "it shines along its -z";
  EXPECT_EQ(dvec3(s.camera.world_from_camera[3]), dvec3(0, 10, 30));
}

TEST(Snapshot, ACameraUnderAScaleStaysRigid) {
  TestWorkspace w;
  w.run(
      "createNode transform -name t\nsetAttr t.scale 2 2 2\ncreateNode camera -name c -parent t\n"
      "setAttr c.translate 0 0 1\nsetAttr c.near_clip 0.5");
  const Camera camera = w.snapshot().camera;
  EXPECT_EQ(camera.world_from_camera[0], dvec4(1, 0, 0, 0));
  EXPECT_EQ(camera.world_from_camera[3], dvec4(0, 0, 2, 1));
  EXPECT_EQ(camera.near_clip, 1.0f);
}

// What the attribute editor clamps to must not be refused by whoever draws it.
TEST(Snapshot, WhatIsSetToTheEndOfAnOpenRangeIsDrawn) {
  TestWorkspace w;
  w.run(
      "createNode medium -name m\nsetAttr m.phase two_lobe\nsetAttr m.g 5\nsetAttr m.g_back -5\n"
      "createNode atfmVolume -name ball\nsetAttr ball.draw sphere\nconnectAttr m.out ball.medium\n"
      "createNode spotLight -name lamp\nsetAttr lamp.cone_angle 500");
  const SceneSnapshot s = w.snapshot();
  ASSERT_EQ(s.media.size(), 1u);
  EXPECT_GT(s.media[0].phase.g, 0.9999f);
  EXPECT_LT(s.media[0].phase.g, 1.0f);
  EXPECT_LT(s.media[0].phase.g_back, -0.9999f);
  ASSERT_EQ(s.lights.size(), 1u);
  EXPECT_GE(s.lights[0].cone_angle, 179.0f);
}

TEST(Snapshot, WhatIsHiddenOrNotIsolatedIsNotInIt) {
  TestWorkspace w;
  w.run(
      "createNode transform -name t\ncreateNode atfmVolume -name a -parent t\nsetAttr a.draw box\n"
      "createNode atfmVolume -name b\nsetAttr b.draw box\ncreateNode pointLight -name p\n"
      "createNode ambientLight -name sky\nsetAttr sky.intensity 0.5");
  EXPECT_EQ(w.snapshot().media.size(), 2u);
  EXPECT_EQ(w.snapshot().ambient, vec3(0.5f));
  w.run("setAttr t.visibility false\nsetAttr p.visibility false\nsetAttr sky.visibility false");
  EXPECT_EQ(w.snapshot().media.size(), 1u);
  EXPECT_EQ(w.snapshot().media[0].name, "b");
  EXPECT_TRUE(w.snapshot().lights.empty());
  EXPECT_EQ(w.snapshot().ambient, vec3(0.0f));
  w.run("setAttr t.visibility true\nsetAttr p.visibility true");
  w.view().isolated = {w.session().graph().get("t").id};
  EXPECT_EQ(w.snapshot().media.size(), 1u);
  EXPECT_EQ(w.snapshot().media[0].name, "a");
  ASSERT_EQ(w.snapshot().lights.size(), 1u) << "it is shown in the light of the scene";
  EXPECT_EQ(w.snapshot().lights[0].name, "p");
  EXPECT_EQ(w.snapshot().ambient, vec3(0.0f)) << "but not in what is hidden";
  w.run("setAttr sky.visibility true");
  EXPECT_EQ(w.snapshot().ambient, vec3(0.5f));
}

TEST(Snapshot, WhatIsIsolatedAwayIsNotComputed) {
  TestWorkspace w;
  w.run(
      "createNode atfmVolume -name a\nsetAttr a.draw box\ncreateNode volumeNoise -name n\n"
      "createNode atfmVolume -name b\nconnectAttr n.volume b.volume\ncreateNode camera -name c");
  w.view().isolated = {w.session().graph().get("a").id};
  EXPECT_EQ(w.snapshot().media.size(), 1u);
  EXPECT_TRUE(w.session().evaluator().is_dirty(w.session().graph().plug("n.volume")));
}

TEST(Snapshot, ADrivenVisibilityAndPlaceAreSeenAsTheyAreNow) {
  TestWorkspace w;
  w.run(
      "createNode transform -name t\ncreateNode atfmVolume -name a -parent t\nsetAttr a.draw box\n"
      "setKeyframe t.translate.x -time 1 -value 0 -interpolation linear\nsetKeyframe t.translate.x -time 11 "
      "-value 20\n"
      "setKeyframe t.visibility -time 1 -value 1 -interpolation stepped\nsetKeyframe t.visibility -time 11 "
      "-value 0\n"
      "currentTime 6");
  EXPECT_EQ(w.snapshot().media[0].world_from_medium[3].x, 10.0);
  w.run("currentTime 11");
  EXPECT_TRUE(w.snapshot().media.empty());
}

TEST(Snapshot, RenderSettingsSayTheCameraTheSizeAndTheQuality) {
  TestWorkspace w;
  w.run(
      "createNode camera -name first\ncreateNode camera -name second\nsetAttr second.focal_length 80\n"
      "createNode renderSettings -name r\nsetAttr r.width 320\nsetAttr r.fast.map.coefficients 9");
  EXPECT_EQ(w.snapshot().camera.focal_length, 35.0f);
  EXPECT_EQ(w.snapshot().width, 320);
  EXPECT_EQ(w.snapshot().quality.map.coefficients, 9);
  EXPECT_EQ(w.snapshot().quality.name, "fast");
  w.run("setAttr r.camera second\nsetAttr second.visibility false");
  EXPECT_EQ(w.snapshot().camera.focal_length, 80.0f);
  w.view().quality = "high";
  EXPECT_EQ(w.snapshot().quality.map.coefficients, 14);
  w.view().quality = "higher";
  EXPECT_EQ(error_of([&] { w.build(); }),
            "there is no quality set 'higher' (did you mean 'high'?); there are: fast, high");
}

TEST(Snapshot, AMediumWithoutAnyLightIsLitAsABareVolumeIs) {
  TestWorkspace w;
  EXPECT_TRUE(w.snapshot().lights.empty()) << "there is nothing to light";
  w.run("createNode atfmVolume -name a\nsetAttr a.draw sphere");
  const BuiltSnapshot built = w.build();
  ASSERT_EQ(built.snapshot.lights.size(), 2u);
  EXPECT_EQ(built.snapshot.lights[0].name, "key");
  EXPECT_EQ(built.snapshot.lights[1].name, "rim");
  EXPECT_NE(built.snapshot.ambient, vec3(0.0f));
  EXPECT_TRUE(std::any_of(built.notes.begin(), built.notes.end(),
                          [](const std::string& note) { return note.find("the scene has no lights") == 0; }));
  // Looking from elsewhere moves no light.
  w.run("createNode camera -name c\nframeView -azimuth 200");
  EXPECT_EQ(w.snapshot().lights[0].toward, built.snapshot.lights[0].toward);
  // A light that is switched off is a decision, and so is the setting.
  w.run("createNode pointLight -name p\nsetAttr p.visibility false");
  EXPECT_TRUE(w.snapshot().lights.empty());
  w.run("delete p\ncreateNode renderSettings -name r");
  EXPECT_EQ(w.snapshot().lights.size(), 2u);
  w.run("setAttr r.default_lights false");
  EXPECT_TRUE(w.snapshot().lights.empty());
  EXPECT_EQ(w.snapshot().ambient, vec3(0.0f));
}

TEST(Snapshot, AFailureLeavesOutItsShapeAndIsToldOnce) {
  TestWorkspace w;
  w.run(
      "createNode volumeRead -name r\nsetAttr r.file /nowhere/a.vdb\ncreateNode atfmVolume -name a\n"
      "connectAttr r.volume a.volume\ncreateNode atfmVolume -name b\nconnectAttr r.volume b.volume\n"
      "createNode atfmVolume -name c\nsetAttr c.draw box\ncreateNode atfmVolume -name d");
  const BuiltSnapshot built = w.build();
  EXPECT_EQ(built.snapshot.media.size(), 1u);
  ASSERT_EQ(built.problems.size(), 2u);
  EXPECT_TRUE(built.problems[0].starts_with("r.")) << built.problems[0];
  EXPECT_NE(built.problems[0].find("/nowhere/a.vdb"), std::string::npos) << built.problems[0];
  EXPECT_EQ(built.problems[1], "d.contribution: no volume is connected");
}

TEST(Snapshot, AnEditDoesOnlyItsOwnWork) {
  TestWorkspace w(small_scene());
  const SceneSnapshot first = w.snapshot();
  const auto rebuilt = [&](const SceneSnapshot& now) {
    const FlatScene before = flatten(first), after = flatten(now);
    EXPECT_EQ(before.maps.size(), after.maps.size());
    std::string reasons;
    for (int map = 0; map < int(before.maps.size()); ++map)
      reasons += rebuild_reason(map_key(before, map), map_key(after, map));
    return reasons;
  };
  // Nothing was changed: nothing runs.
  std::uint64_t before = w.computes();
  EXPECT_EQ(w.snapshot().media[0].volume, first.media[0].volume);
  EXPECT_EQ(w.computes(), before);
  // An equal value runs nothing.
  w.run("setAttr medium.albedo " + w.run("getAttr medium.albedo"));
  w.snapshot();
  EXPECT_EQ(w.computes(), before);
  // Albedo: the medium and the shape that takes it; the same volume and the same maps.
  w.run("setAttr medium.albedo 0.5 0.5 0.5");
  const SceneSnapshot greyer = w.snapshot();
  EXPECT_EQ(w.computes("medium"), 2u);
  EXPECT_EQ(w.computes("atfmVolume"), 2u);
  EXPECT_EQ(w.computes() - before, 2u);
  EXPECT_EQ(w.computes("volumeNoise"), 1u);
  EXPECT_EQ(greyer.media[0].sigma_s, vec3(0.5f));
  EXPECT_EQ(greyer.media[0].volume, first.media[0].volume);
  EXPECT_EQ(rebuilt(greyer), "");
  // A camera that moves runs no node at all, nor does a light or a volume that moves.
  before = w.computes();
  w.run("setAttr camera.translate.x 3\nsetAttr camera.rotate.y 10");
  EXPECT_EQ(w.snapshot().camera.world_from_camera[3].x, 3.0);
  EXPECT_EQ(w.computes(), before);
  EXPECT_EQ(rebuilt(w.snapshot()), "");
  w.run("setAttr key.rotate.y 10\nsetAttr medium_place.translate.y 2");
  EXPECT_EQ(w.snapshot().media[0].world_from_medium[3].y, 2.0);
  EXPECT_EQ(w.computes(), before);
  // Nothing here depends on time.
  w.run("currentTime 20");
  w.snapshot();
  EXPECT_EQ(w.computes(), before);
  // Undo finds what is known already.
  w.run("undo 4");
  EXPECT_EQ(w.snapshot().media[0].sigma_s, vec3(0.5f));
  w.run("undo");
  EXPECT_EQ(w.snapshot().media[0].sigma_s, first.media[0].sigma_s);
  EXPECT_EQ(w.computes(), before);
}

TEST(Snapshot, AFrameChangeRunsWhatDependsOnTimeAndNothingElse) {
  TestWorkspace w(small_scene());
  w.snapshot();
  w.run("setKeyframe medium.density_scale -time 1\nsetKeyframe medium.density_scale -time 10 -value 9");
  w.run("currentTime 1");
  w.snapshot();
  const auto noise = w.computes("volumeNoise"), light = w.computes("directionalLight"),
             camera = w.computes("camera");
  w.run("currentTime 10");
  EXPECT_EQ(w.snapshot().media[0].density_scale, 9.0f);
  EXPECT_EQ(w.computes("volumeNoise"), noise);
  EXPECT_EQ(w.computes("directionalLight"), light);
  EXPECT_EQ(w.computes("camera"), camera);
  const auto all = w.computes();
  w.run("currentTime 1");
  w.snapshot();
  EXPECT_EQ(w.computes(), all) << "scrubbing back is free";
}

TEST(Snapshot, WhatNeedsANodeOfAnUnknownTypeIsLeftOutWhereThatIsAskedFor) {
  TemporaryFolder folder;
  const std::string file = folder.write("a.plinian", R"(plinian scene 1.0
node cloudMaker maker
node atfmVolume whole
  .draw box
node atfmVolume fed
  .volume <- maker.out
node atfmVolume tinted
  .draw box
  .medium <- maker.look
end
)");
  TestWorkspace w;
  w.run("open \"" + file + "\"");
  EXPECT_EQ(w.build().problems, std::vector<std::string>{"fed.contribution: no volume is connected"});
  w.view().skip_unknown = true;
  const BuiltSnapshot built = w.build();
  EXPECT_TRUE(built.problems.empty());
  EXPECT_EQ(built.snapshot.media.size(), 2u);
  EXPECT_EQ(
      built.left_out,
      (std::vector<std::string>{
          "fed is left out: it needs maker, whose type 'cloudMaker' is not known here",
          "tinted is shown without what it takes from maker, whose type 'cloudMaker' is not known here"}));
  // What fails by itself still fails.
  w.run("createNode atfmVolume -name own");
  EXPECT_EQ(w.build().problems, std::vector<std::string>{"own.contribution: no volume is connected"});
}

TEST(Snapshot, ACameraUnderAShearStaysRigid) {
  TestWorkspace w;
  w.run(
      "createNode transform -name t\nsetAttr t.scale 1 3 1\ncreateNode transform -name turned -parent t\n"
      "setAttr turned.rotate 0 0 30\ncreateNode camera -name c -parent turned");
  const dmat4 camera = w.snapshot().camera.world_from_camera;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(glm::dot(dvec3(camera[i]), dvec3(camera[k])), i == k ? 1.0 : 0.0, 1e-12) << i << k;
}

}  // namespace
}  // namespace plinian::scene
