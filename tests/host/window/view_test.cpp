// What a quick picture costs, what it may reuse, and when two snapshots show the same.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/integrate/map_renderer.h"
#include "host/window/view/developer.h"
#include "host/window/view/interactive_cost.h"
#include "host/window/view/quick_maps.h"
#include "host/window/view/relight.h"
#include "host/window/view/same_picture.h"

namespace plinian::window {
namespace {

SceneSnapshot ball() {
  SceneSnapshot scene;
  Medium medium;
  medium.shape = MediumShape::sphere;
  medium.density_scale = 4.0f;
  scene.media.push_back(medium);
  Light key;
  key.name = "key";
  scene.lights.push_back(key);
  scene.camera = look_at({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 40.0);
  return scene;
}

TEST(InteractiveCost, ASlowPixelMakesASmallPictureAndAFastOneAWholeOne) {
  const ivec2 pane(800, 600);
  InteractiveCost slow(50.0), fast(50.0);
  for (int i = 0; i < 20; ++i) {
    slow.took(slow.size(pane), 0.1 * slow.size(pane).x * slow.size(pane).y);
    fast.took(fast.size(pane), 0.00001 * fast.size(pane).x * fast.size(pane).y);
  }
  EXPECT_EQ(slow.size(pane), ivec2(200, 150)) << "never under a quarter of the sides";
  EXPECT_EQ(fast.size(pane), pane);
  EXPECT_EQ(slow.size({100, 60}), ivec2(64, 60)) << "nor under 64 pixels where there are so many";
}

// A cost at the edge between two sizes does not make the picture flutter between them.
TEST(InteractiveCost, DoesNotFlutter) {
  const ivec2 pane(800, 600);
  InteractiveCost cost(50.0);
  const double edge = 50.0 / (400.0 * 300.0);  // [ms] of a pixel: just right for half the sides
  ivec2 last = cost.size(pane);
  int changes = 0;
  for (int i = 0; i < 40; ++i) {
    const ivec2 size = cost.size(pane);
    changes += size != last;
    last = size;
    cost.took(size, edge * (i % 2 ? 1.02 : 0.98) * size.x * size.y);
  }
  EXPECT_LE(changes, 2);
}

TEST(QuickMaps, AreFullWhereTheyAreThereAndSmallWhereTheyMustBeBuilt) {
  QuickMaps maps;
  SceneSnapshot scene = ball();
  EXPECT_EQ(maps.resolution(scene), 256) << "nothing is there yet";
  maps.rendered(scene);
  EXPECT_EQ(maps.resolution(scene), 512);
  SceneSnapshot moved = scene;
  moved.camera = look_at({3.0, 1.0, 4.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 40.0);
  moved.media[0].phase = {PhaseKind::henyey_greenstein, 0.5f};
  EXPECT_EQ(maps.resolution(moved), 512) << "neither the camera nor the phase function touches a map";
  SceneSnapshot lit = scene;
  lit.lights[0].toward = vec3(1.0f, 0.0f, 0.0f);
  EXPECT_EQ(maps.resolution(lit), 256);
  lit.quality.map.resolution = 256;
  maps.rendered(lit);
  lit.quality.map.resolution = 512;
  lit.camera = moved.camera;
  EXPECT_EQ(maps.resolution(lit), 256) << "small ones that are there serve as well as none";
  maps.forget();
  EXPECT_EQ(maps.resolution(scene), 256);
}

TEST(QuickMaps, AreAsSmallAsTheTimeAsksFor) {
  QuickMaps slow(60.0), fast(60.0);
  const SceneSnapshot scene = ball();
  for (int i = 0; i < 20; ++i) {
    slow.took(256, 600.0);
    fast.took(128, 1.0);
    slow.resolution(scene);
    fast.resolution(scene);
  }
  EXPECT_EQ(slow.resolution(scene), 64) << "a tenth of the texels at least";
  EXPECT_EQ(fast.resolution(scene), 256);
}

TEST(SamePicture, CountsWhatIsSeenAndNothingElse) {
  const SceneSnapshot scene = ball();
  EXPECT_TRUE(same_picture(scene, scene));
  const auto differs = [&](auto change) {
    SceneSnapshot other = scene;
    change(other);
    return !same_picture(scene, other);
  };
  EXPECT_TRUE(differs([](SceneSnapshot& s) { s.camera.focal_length = 50.0f; }));
  EXPECT_TRUE(differs([](SceneSnapshot& s) { s.media[0].phase.g = 0.1f; }));
  EXPECT_TRUE(differs([](SceneSnapshot& s) { s.media.clear(); }));
  EXPECT_TRUE(differs([](SceneSnapshot& s) { s.lights[0].exposure = 1.0f; }));
  EXPECT_TRUE(differs([](SceneSnapshot& s) { s.quality.view.step = 1.0f; }));
  EXPECT_TRUE(differs([](SceneSnapshot& s) { s.background = vec3(0.1f); }));
  EXPECT_TRUE(differs([](SceneSnapshot& s) { s.width = 100; }));
  EXPECT_FALSE(differs([](SceneSnapshot& s) { s.quality.name = "mine"; }));
}

// What is made of layers is what would have been rendered.
TEST(Relight, IsWhatARendererWouldMakeOfTheOtherLight) {
  SceneSnapshot scene = ball();
  scene.width = scene.height = 48;
  scene.ambient = vec3(0.1f, 0.2f, 0.3f);
  scene.background = vec3(0.05f);
  scene.lights.push_back(scene.lights[0]);
  scene.lights[1].name = "rim";
  scene.lights[1].toward = vec3(-1.0f, 0.0f, 0.0f);
  SceneSnapshot wanted = scene;
  wanted.lights[0].exposure = 1.5f;
  wanted.lights[1].colour = vec3(1.0f, 0.5f, 0.0f);
  wanted.ambient = vec3(0.05f, 0.2f, 0.6f);
  const auto renderer = make_map_renderer();
  const Frame before = renderer->render(scene, 1), truth = renderer->render(wanted, 1);
  const auto made = relit(before, scene, wanted);
  ASSERT_TRUE(made);
  double largest = 0.0;
  for (std::size_t i = 0; i < truth.beauty.size(); ++i)
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, double(std::abs(made->beauty[i][c] - truth.beauty[i][c])));
  EXPECT_LT(largest, 1e-5);
  double change = 0.0;
  for (std::size_t i = 0; i < truth.beauty.size(); ++i)
    change = std::max(change, double(std::abs(before.beauty[i].x - truth.beauty[i].x)));
  EXPECT_GT(change, 0.05) << "there was something to be made";
}

TEST(Relight, RefusesWhatItCannotTell) {
  SceneSnapshot scene = ball();
  scene.width = scene.height = 8;
  const Frame frame = make_map_renderer()->render(scene, 1);
  const auto refuses = [&](auto change) {
    SceneSnapshot wanted = scene;
    change(wanted);
    return !relit(frame, scene, wanted);
  };
  EXPECT_FALSE(refuses([](SceneSnapshot& s) { s.lights[0].exposure = -1.0f; }));
  EXPECT_TRUE(refuses([](SceneSnapshot& s) { s.lights[0].toward = vec3(1.0f, 0.0f, 0.0f); }));
  EXPECT_TRUE(refuses([](SceneSnapshot& s) { s.lights.clear(); }));
  EXPECT_TRUE(refuses([](SceneSnapshot& s) { s.media[0].density_scale = 2.0f; }));
  EXPECT_TRUE(refuses([](SceneSnapshot& s) { s.ambient = vec3(0.1f); }))
      << "what was dark has no layer to scale";
}

TEST(Relight, LeavesTheErrorOfMapsAsItIs) {
  SceneSnapshot scene = ball();
  scene.width = scene.height = 16;
  scene.quality.view.light = LightLookup::error;
  const Frame frame = make_map_renderer()->render(scene, 1);
  SceneSnapshot brighter = scene;
  brighter.lights[0].exposure = 3.0f;
  const auto made = relit(frame, scene, brighter);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->lights[0].radiance, frame.lights[0].radiance);
}

TEST(Development, OfTheErrorOfMapsIsOfTheWorstLightWhereSomethingIsSeen) {
  auto picture = std::make_shared<ViewPicture>();
  picture->scene.quality.view.light = LightLookup::error;
  Frame& frame = picture->frame;
  frame.width = 3;
  frame.height = 1;
  frame.beauty.assign(3, vec3(0.0f));
  frame.transmittance = {vec3(0.5f), vec3(0.0f), vec3(1.0f)};
  frame.depth = {1.0f, 1.0f, INFINITY};
  frame.ambient = frame.emission = frame.background = frame.beauty;
  frame.lights = {{"key", {vec3(0.01f), vec3(0.02f), vec3(0.0f)}},
                  {"rim", {vec3(0.02f), vec3(0.0f), vec3(0.0f)}}};
  std::atomic<int> woken{0};
  Developer developer([&] { ++woken; });
  const auto developed = [&](const Development& how) {
    const int before = woken;
    developer.ask(picture, how);
    while (woken == before) std::this_thread::yield();
    return developer.developed();
  };
  Development how;
  how.layer = "map error";
  DevelopedPtr seen = developed(how);
  ASSERT_TRUE(seen->map_error);
  EXPECT_FLOAT_EQ(seen->map_error->pixels[0], 0.04f) << "of what is half transparent";
  EXPECT_FLOAT_EQ(seen->map_error->pixels[1], 0.02f);
  EXPECT_EQ(seen->map_error->pixels[2], 0.0f);
  EXPECT_NEAR(seen->map_error->mean, 0.03, 1e-6);
  EXPECT_NEAR(seen->map_error->worst, 0.04, 1e-6);
  EXPECT_GT(seen->bytes[0], seen->bytes[3]) << "more is brighter";
  how.solo = {"key"};
  EXPECT_NEAR(developed(how)->map_error->worst, 0.02, 1e-6);
  // As light, once asked for, only a picture of light is shown; until then the last good one stays.
  const DevelopedPtr last = developer.developed();
  developer.ask(picture, Development());
  auto light = std::make_shared<ViewPicture>(*picture);
  light->scene.quality.view.light = LightLookup::map;
  picture = light;
  seen = developed(Development());
  EXPECT_NE(seen, last);
  EXPECT_FALSE(seen->map_error);
  EXPECT_EQ(seen->picture, light);
}

TEST(Development, ShowsLightsAloneLayersAndAlpha) {
  Frame frame;
  frame.width = 2;
  frame.height = 1;
  frame.beauty = {vec3(6.0f), vec3(1.0f)};
  frame.transmittance = {vec3(0.25f), vec3(1.0f)};
  frame.depth = {2.0f, INFINITY};
  frame.ambient = {vec3(1.0f), vec3(0.0f)};
  frame.emission = {vec3(2.0f), vec3(0.0f)};
  frame.lights = {{"key", {vec3(2.0f), vec3(0.0f)}}, {"rim", {vec3(1.0f), vec3(0.0f)}}};
  const auto first = [&](const Development& how) { return visible_layers(frame, how).channels[0].values[0]; };
  Development how;
  EXPECT_EQ(first(how), 6.0f);
  how.solo = {"rim"};
  EXPECT_EQ(first(how), 1.0f);
  how.solo = {"rim", "key"};
  EXPECT_EQ(first(how), 3.0f);
  how.solo.clear();
  how.layer = "alpha";
  EXPECT_EQ(first(how), 0.75f);
  how.layer = "emission";
  EXPECT_EQ(first(how), 2.0f);
  how.layer = "depth";
  EXPECT_EQ(first(how), 1.0f);
  EXPECT_EQ(visible_layers(frame, how).channels[0].values[1], 0.0f) << "nothing is far away";
}

}  // namespace
}  // namespace plinian::window
