// Small pictures of the scene in each look.
#include "host/window/looks/look_pictures.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "core/integrate/map_renderer.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::window {
namespace {

// The shipped looks, and none of a user's.
struct LookPicturesTest : testing::Test {
  void SetUp() override {
    ::setenv("PLINIAN_PATH", PLINIAN_SOURCE_DIR, 1);
    ::setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
    ASSERT_EQ(scene::look_names().size(), 4u);
  }
  void TearDown() override {
    ::unsetenv("PLINIAN_PATH");
    ::unsetenv("XDG_CONFIG_HOME");
  }
  TemporaryFolder folder;
};

TEST_F(LookPicturesTest, WearWhatTheCommandPutsOn) {
  for (const std::string& look : scene::look_names()) {
    scene::TestWorkspace w(scene::small_scene("sphere"));
    w.run("setAttr medium.density_scale 3\nsetAttr medium.g 0.9\nsetAttr medium.emission_exposure 2");
    const Medium tried = in_look(w.snapshot(), scene::load_look(look).medium).media[0];
    w.run("preset apply " + look);
    const Medium worn = w.snapshot().media[0];
    EXPECT_EQ(tried.sigma_s, worn.sigma_s) << look;
    EXPECT_EQ(tried.sigma_a, worn.sigma_a) << look;
    EXPECT_EQ(tried.phase.kind, worn.phase.kind) << look;
    EXPECT_EQ(tried.phase.g, worn.phase.g) << look;
    EXPECT_EQ(tried.phase.g_back, worn.phase.g_back) << look;
    EXPECT_EQ(tried.phase.blend, worn.phase.blend) << look;
    EXPECT_EQ(tried.emission.scale, worn.emission.scale) << look;
    EXPECT_EQ(tried.emission.exposure, worn.emission.exposure) << look;
    EXPECT_EQ(tried.density_scale, worn.density_scale) << look;
  }
}

TEST_F(LookPicturesTest, AreMadeOnceForASceneWhateverItWears) {
  scene::TestWorkspace w(scene::small_scene("sphere"));
  std::atomic<int> made{0};
  LookPictures pictures(make_map_renderer, [&] { ++made; });
  const auto pictures_of = [&](const SceneSnapshot& scene) {
    const int before = made;
    pictures.update(scene, {});
    for (int i = 0; i < 600 && made == before; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(made, before + 1);
    return pictures.pictures();
  };
  const auto first = pictures_of(w.snapshot());
  ASSERT_TRUE(first);
  ASSERT_EQ(first->size(), scene::look_names().size());
  for (const LookPicture& look : *first) {
    ASSERT_TRUE(look.picture) << look.look << ": " << look.problem;
    EXPECT_EQ(look.picture->height, LookPictures::height);
    EXPECT_EQ(look.picture->bytes.size(), std::size_t(look.picture->width) * LookPictures::height * 3);
    if (&look != &first->front()) {
      EXPECT_NE(look.picture->bytes, first->front().picture->bytes) << look.look;
    }
  }
  w.run("preset apply cloud");
  pictures.update(w.snapshot(), {});
  w.run("setAttr medium.g 0.1\nsetAttr settings.fast.view.step 3");
  pictures.update(w.snapshot(), {});
  w.run("setAttr medium.density_scale 2");
  pictures_of(w.snapshot());
  EXPECT_EQ(made, 2) << "only the last of these shows in them";
}

}  // namespace
}  // namespace plinian::window
