// Presets and looks: put on whole, undone whole, saved, found, and told of when they change.
#include <cstdlib>

#include "core/media/procedural.h"
#include "core/scene/preset.h"
#include "core/scene/quality_parameters.h"
#include "host/scene/looks.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::scene {
namespace {

// The shipped presets stand for a show's, and the user's folder is an empty one.
struct Presets : testing::Test {
  void SetUp() override {
    std::filesystem::create_directories(folder.path() / "show");
    std::filesystem::copy(std::string(PLINIAN_SOURCE_DIR) + "/presets", folder.path() / "show/presets",
                          std::filesystem::copy_options::recursive);
    ::setenv("PLINIAN_PATH", (folder / "show").c_str(), 1);
    ::setenv("XDG_CONFIG_HOME", (folder / "user").c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("PLINIAN_PATH");
    ::unsetenv("XDG_CONFIG_HOME");
  }
  TemporaryFolder folder;
};

void expect_equal(const Quality& a, const Quality& b) {
  for (const Parameter<Quality>& p : quality_parameters())
    EXPECT_EQ(to_text(p.spec, *p.get(a)), to_text(p.spec, *p.get(b))) << p.spec.name;
}

TEST_F(Presets, APresetResetsASetInOneStepAndLeavesWhatIsConnectedAlone) {
  TestWorkspace w(small_scene());
  const Quality shipped = quality_of(w.session(), "fast");
  w.run(
      "setAttr settings.fast.map.coefficients 3\nsetAttr settings.fast.view.step 5\nsetAttr "
      "settings.fast.map.threshold 0.5");
  w.run(
      "createNode transform -name driver\nsetAttr driver.translate.x 7\n"
      "connectAttr driver.translate.x settings.fast.view.shade_samples\nlockAttr "
      "settings.fast.map.threshold");
  const std::size_t steps = w.session().history().undo_names().size();
  std::string told;
  w.session().on_note = [&](const std::string& line) { told += line; };
  EXPECT_EQ(w.run("preset apply fast"), "fast");
  EXPECT_EQ(
      told,
      "left as it is: settings.fast.map.threshold is locked; settings.fast.view.shade_samples is driven "
      "by driver.translate.x");
  EXPECT_EQ(w.session().history().undo_names().size(), steps + 1);
  Quality now = quality_of(w.session(), "fast");
  EXPECT_EQ(now.view.shade_samples, 7);
  EXPECT_EQ(now.map.threshold, 0.5f);
  now.view.shade_samples = shipped.view.shade_samples;
  now.map.threshold = shipped.map.threshold;
  expect_equal(now, shipped);
  w.run("undo");
  EXPECT_EQ(quality_of(w.session(), "fast").map.coefficients, 3);
}

TEST_F(Presets, SwitchingBetweenTheSetsLosesNoTuningAndIsNoEdit) {
  TestWorkspace w(small_scene());
  w.run("setAttr settings.fast.map.coefficients 3\nsetAttr settings.high.map.coefficients 12");
  const std::size_t steps = w.session().history().undo_names().size();
  const SceneSnapshot before = w.snapshot();
  EXPECT_EQ(w.run("quality high"), "high");
  EXPECT_EQ(w.snapshot().quality.map.coefficients, 12);
  EXPECT_EQ(w.run("quality fast\nquality"), "fast\nfast");
  expect_equal(w.snapshot().quality, before.quality);
  EXPECT_EQ(w.snapshot().media[0].volume, before.media[0].volume);
  EXPECT_EQ(w.session().history().undo_names().size(), steps);
  EXPECT_EQ(w.refusal("quality higher"),
            "there is no quality set 'higher' (did you mean 'high'?); there are: fast, high");
}

TEST_F(Presets, ALookIsThatOfTheProceduralMediumOfItsName) {
  for (const std::string kind : {"ash", "cloud", "sandstorm", "explosion"}) {
    TestWorkspace w(small_scene("sphere"));
    EXPECT_EQ(w.run("preset apply " + kind), "medium");
    const Medium medium = w.snapshot().media[0];
    const ProceduralLook look = procedural_look(kind);
    EXPECT_EQ(medium.sigma_s, look.sigma_s) << kind;
    EXPECT_EQ(medium.sigma_a, look.sigma_a) << kind;
    EXPECT_EQ(medium.phase.kind, look.phase.kind) << kind;
    EXPECT_EQ(medium.phase.g, look.phase.g) << kind;
    EXPECT_EQ(medium.phase.g_back, look.phase.g_back) << kind;
    EXPECT_EQ(medium.phase.blend, look.phase.blend) << kind;
    EXPECT_EQ(medium.emission.scale, look.emission.scale) << kind;
  }
}

TEST_F(Presets, ALookIsPutOnWholeInOneStepButForDensity) {
  TestWorkspace w(small_scene("sphere"));
  w.run(
      "setAttr medium.density_scale 3\nsetAttr medium.emission_exposure 2\nsetAttr medium.g 0.9\n"
      "setKeyframe medium.blend -value 0.25");
  const std::size_t steps = w.session().history().undo_names().size();
  w.run("preset apply cloud medium");
  EXPECT_EQ(w.session().history().undo_names().size(), steps + 1);
  const Medium medium = w.snapshot().media[0];
  EXPECT_EQ(medium.density_scale, 3.0f) << "it belongs to the volume";
  EXPECT_EQ(medium.emission.exposure, 0.0f) << "what a look leaves out is at its default";
  EXPECT_EQ(medium.phase.g, 0.6f);
  EXPECT_EQ(medium.phase.blend, 0.25f) << "it is keyed";
  w.run("undo");
  EXPECT_EQ(w.snapshot().media[0].phase.g, 0.9f);
}

TEST_F(Presets, AreSavedToTheUsersFolderAndFoundThere) {
  TestWorkspace w(small_scene("sphere"));
  w.run(
      "setAttr settings.high.map.coefficients 5\nsetAttr medium.albedo 0.25 0.5 0.75\nsetAttr medium.phase "
      "schlick");
  EXPECT_EQ(w.run("preset save mine high"), folder / "user/plinian/presets/mine.json");
  EXPECT_EQ(w.run("preset save blue medium"), folder / "user/plinian/presets/looks/blue.json");
  TestWorkspace other(small_scene("sphere"));
  EXPECT_EQ(other.run("preset apply mine"), "fast");
  EXPECT_EQ(quality_of(other.session(), "fast").map.coefficients, 5);
  EXPECT_EQ(quality_of(other.session(), "fast").name, "mine");
  other.run("preset apply blue");
  EXPECT_EQ(other.snapshot().media[0].sigma_s, vec3(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(other.snapshot().media[0].phase.kind, PhaseKind::schlick);
  EXPECT_NE(other.run("preset list").find("look blue"), std::string::npos);
  EXPECT_EQ(other.refusal("preset apply blu medium").substr(0, 21), "preset: blu: no such ");
  EXPECT_NE(other.refusal("preset apply fsat").find("(did you mean 'fast'?)"), std::string::npos);
  EXPECT_EQ(other.refusal("preset save ../x"), "preset: '../x' cannot name a preset: no dots and slashes");
  EXPECT_NE(other.refusal("preset apply ash key").find("key is no medium"), std::string::npos);
}

TEST_F(Presets, ASceneTellsWhenTheLookItUsedHasChanged) {
  TestWorkspace w(small_scene("sphere"));
  w.run("preset apply ash\nsave " + folder / "a.plinian");
  TestWorkspace same;
  same.run("open " + folder / "a.plinian");
  EXPECT_TRUE(same.warnings.empty()) << same.warnings.front();
  const std::string look = folder / "show/presets/looks/ash.json";
  folder.write("show/presets/looks/ash.json",
               R"({"plinian_look": {"major": 1, "minor": 0}, "name": "another", "albedo": 0.1, "g": 0.2,
                   "_": "a comment"})");
  TestWorkspace changed;
  changed.run("open " + folder / "a.plinian");
  ASSERT_EQ(changed.warnings.size(), 1u);
  EXPECT_TRUE(changed.warnings[0].starts_with("medium: the look 'ash' says something else now"))
      << changed.warnings[0];
  // The scene itself stays what it was.
  EXPECT_EQ(changed.snapshot().media[0].phase.g, 0.35f);
  std::filesystem::remove(look);
  TestWorkspace gone;
  gone.run("open " + folder / "a.plinian");
  ASSERT_EQ(gone.warnings.size(), 1u);
  EXPECT_NE(gone.warnings[0].find("ash: no such look"), std::string::npos) << gone.warnings[0];
}

TEST_F(Presets, ABadLookIsOneLine) {
  const auto refusal = [&](const std::string& text) {
    return error_of([&] { load_look(folder.write("bad.json", text)); });
  };
  const std::string version = R"({"plinian_look": {"major": 1, "minor": 0}, )";
  EXPECT_NE(refusal(version + R"("albdo": 1})").find("albdo: unknown key (did you mean 'albedo'?)"),
            std::string::npos);
  EXPECT_NE(
      refusal(version + R"("albedo": 2})").find("albedo: expected a number or 3 numbers from 0 to 1, got 2"),
      std::string::npos);
  EXPECT_NE(refusal(version + R"("albedo": 1, "sigma_s": 1})").find("cannot stand beside"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"albedo": 1})").find("not a look"), std::string::npos);
  EXPECT_NE(refusal(R"({"plinian_look": {"major": 2}})").find("reads version 1, not 2"), std::string::npos);
}

}  // namespace
}  // namespace plinian::scene
