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

// What a picture costs that has so many milliseconds a pixel and a texel, when so many maps are built for it.
struct Machine {
  double ms_per_pixel, ms_per_texel;
  int builds;
  InteractiveCost cost;
  InteractiveCost::Choice next(ivec2 pane, double mood = 1.0) {
    const InteractiveCost::Choice choice = cost.choose(pane, 512, builds);
    const ivec2 size = InteractiveCost::size(pane, choice.scale);
    view_ms = mood * ms_per_pixel * size.x * size.y;
    map_ms = mood * ms_per_texel * builds * choice.resolution * choice.resolution;
    cost.took_view(size, view_ms);
    cost.took_maps(choice.resolution, builds, map_ms);
    return choice;
  }
  double view_ms = 0.0, map_ms = 0.0;
};

TEST(InteractiveCost, ASlowPixelMakesASmallPictureAndAFastOneAWholeOne) {
  const ivec2 pane(800, 600);
  Machine slow{.ms_per_pixel = 0.1, .ms_per_texel = 0.1, .builds = 1};
  Machine fast{.ms_per_pixel = 1e-6, .ms_per_texel = 1e-6, .builds = 1};
  for (int i = 0; i < 20; ++i) {
    slow.next(pane);
    fast.next(pane);
  }
  EXPECT_EQ(slow.next(pane).scale, 0.25) << "never under a quarter of the sides";
  EXPECT_EQ(slow.next(pane).resolution, 64) << "nor under 64 texels";
  EXPECT_EQ(fast.next(pane).scale, 1.0);
  EXPECT_EQ(fast.next(pane).resolution, 512);
  EXPECT_EQ(InteractiveCost::size({100, 60}, 0.25), ivec2(64, 60))
      << "nor under 64 pixels where there are so many";
}

// On this machine a picture of 256^2 takes 50 ms, and a map of 256^2 as long.
TEST(InteractiveCost, SpendsTheTimeOnMapsAndViewTogether) {
  const ivec2 pane(512, 512);
  Machine camera{.ms_per_pixel = 7.6e-4, .ms_per_texel = 7.6e-4, .builds = 0};
  Machine key = camera, both = camera;
  key.builds = 1;
  both.builds = 2;
  for (Machine* machine : {&camera, &key, &both})
    for (int i = 0; i < 20; ++i) machine->next(pane);
  for (const Machine* machine : {&camera, &key, &both}) EXPECT_LE(machine->view_ms + machine->map_ms, 85.0);
  EXPECT_GT(camera.view_ms, key.view_ms) << "what maps do not take is the picture's";
  EXPECT_GT(key.next(pane).resolution, both.next(pane).resolution) << "two have to share";
  EXPECT_GE(both.next(pane).resolution, 128);
}

// A cost at the edge between two sizes does not make the picture flutter between them.
TEST(InteractiveCost, DoesNotFlutter) {
  const ivec2 pane(800, 600);
  for (const double ms_per_pixel : {1e-4, 2e-4, 4e-4, 5e-4, 7e-4, 1e-3, 1.5e-3, 2e-3})
    for (const int builds : {0, 1}) {
      Machine machine{.ms_per_pixel = ms_per_pixel, .ms_per_texel = ms_per_pixel, .builds = builds};
      for (int i = 0; i < 6; ++i) machine.next(pane);
      InteractiveCost::Choice last = machine.next(pane);
      int changes = 0;
      for (int i = 0; i < 40; ++i) {
        const InteractiveCost::Choice choice = machine.next(pane, i % 2 ? 1.02 : 0.98);
        changes += choice.scale != last.scale || choice.resolution != last.resolution;
        last = choice;
      }
      EXPECT_LE(changes, 1) << ms_per_pixel << " ms, " << builds << " maps";
    }
}

// A shader that is made while a picture waits for it takes a second, once.
TEST(InteractiveCost, APictureThatWasHeldUpSaysNothingOfTheNext) {
  const ivec2 pane(512, 512);
  Machine machine{.ms_per_pixel = 7.6e-4, .ms_per_texel = 7.6e-4, .builds = 1};
  for (int i = 0; i < 6; ++i) machine.next(pane);
  const InteractiveCost::Choice before = machine.next(pane);
  machine.next(pane, 20.0);
  const InteractiveCost::Choice after = machine.next(pane);
  EXPECT_EQ(after.scale, before.scale);
  EXPECT_EQ(after.resolution, before.resolution);
}

TEST(QuickMaps, ServeWhatDependsOnNothingElseAndMustBeBuiltForTheRest) {
  QuickMaps maps;
  SceneSnapshot scene = ball();
  scene.lights.push_back(scene.lights[0]);
  scene.lights[1].toward = vec3(0.0f, 1.0f, 0.0f);
  EXPECT_FALSE(maps.serving(scene)) << "nothing is there yet";
  EXPECT_EQ(maps.builds(scene), 2);
  maps.rendered(scene);
  EXPECT_EQ(maps.serving(scene), 512);
  EXPECT_EQ(maps.builds(scene), 0);
  SceneSnapshot moved = scene;
  moved.camera = look_at({3.0, 1.0, 4.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 40.0);
  moved.media[0].phase = {PhaseKind::henyey_greenstein, 0.5f};
  EXPECT_EQ(maps.serving(moved), 512) << "neither the camera nor the phase function touches a map";
  SceneSnapshot lit = scene;
  lit.lights[0].toward = vec3(1.0f, 0.0f, 0.0f);
  EXPECT_FALSE(maps.serving(lit));
  EXPECT_EQ(maps.builds(lit), 1) << "that of the other light stays";
  lit.quality.map.resolution = 256;
  maps.rendered(lit);
  lit.quality.map.resolution = 512;
  lit.camera = moved.camera;
  EXPECT_EQ(maps.serving(lit), 256) << "small ones that are there serve as well as none";
  EXPECT_EQ(maps.builds(scene), 1) << "whatever their resolution";
  maps.forget();
  EXPECT_FALSE(maps.serving(scene));
}

// While a hand is on, a map serves up to twice and down to half its extinction; how far that is from its own
// does not add up from picture to picture.
TEST(QuickMaps, ServeOtherExtinctionsByThePowerLawWhereThatIsAskedFor) {
  QuickMaps maps;
  const SceneSnapshot scene = ball();
  maps.rendered(scene);
  SceneSnapshot dense = scene;
  dense.media[0].density_scale *= 1.5f;
  EXPECT_FALSE(maps.serving(dense));
  dense.extinction_reuse = 2.0f;
  EXPECT_EQ(maps.serving(dense), 512);
  maps.rendered(dense);
  dense.media[0].density_scale *= 1.3f;
  EXPECT_EQ(maps.serving(dense), 512);
  maps.rendered(dense);
  dense.media[0].density_scale *= 1.1f;
  EXPECT_FALSE(maps.serving(dense)) << "2.1 times what the map was built for";
  EXPECT_EQ(maps.serving(scene), 512) << "which is what is held";
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

// A medium on the left half, the sky on the right.
std::shared_ptr<ViewPicture> half_seen(vec3 medium) {
  auto picture = std::make_shared<ViewPicture>();
  Frame& frame = picture->frame;
  frame.width = frame.height = 16;
  for (int i = 0; i < 256; ++i) {
    const bool sky = i % 16 >= 8;
    frame.beauty.push_back(sky ? vec3(5.0f) : medium * (1.0f + 0.01f * float(i)));
    frame.transmittance.push_back(vec3(sky ? 1.0f : 0.0f));
    frame.depth.push_back(sky ? INFINITY : 1.0f);
  }
  frame.ambient = frame.emission = frame.background = std::vector<vec3>(256, vec3(0.0f));
  return picture;
}

TEST(Development, TellsHowBrightEachChannelOfTheMediumIsAgainstAnotherPicture) {
  Development how;
  how.against = half_seen(vec3(0.2f, 0.2f, 0.1f));
  const DevelopedPtr seen = develop(half_seen(vec3(0.4f, 0.1f, 0.1f)), how);
  ASSERT_TRUE(seen->figures && seen->figures->balance);
  EXPECT_NEAR(seen->figures->balance->x, 2.0f, 1e-4f);
  EXPECT_NEAR(seen->figures->balance->y, 0.5f, 1e-4f);
  EXPECT_NEAR(seen->figures->balance->z, 1.0f, 1e-4f);
  how.against = half_seen(vec3(0.2f, 0.0f, 0.1f));
  EXPECT_FALSE(develop(half_seen(vec3(0.4f)), how)->figures->balance) << "there is no green to be a share of";
}

TEST(Development, ABalanceIsThatOfAFileAsItCame) {
  const auto file = std::make_shared<FilePicture>();
  file->picture.frame = half_seen(vec3(0.2f))->frame;
  file->picture.has_alpha = true;
  Development how;
  how.against = half_seen(vec3(0.2f));
  how.against_file = file;
  how.matching.exposure = true;
  const DevelopedPtr seen = develop(half_seen(vec3(0.4f)), how);
  ASSERT_TRUE(seen->figures && seen->figures->balance);
  EXPECT_FALSE(seen->figures->matched.empty());
  EXPECT_NEAR(seen->figures->balance->x, 2.0f, 1e-4f) << "what is matched would hide it";
}

TEST(Development, WhatAFileDoesNotHaveIsNotMeasured) {
  const auto file = std::make_shared<FilePicture>();
  file->picture.frame = half_seen(vec3(0.2f))->frame;
  file->picture.frame.lights = {{"key", std::vector<vec3>(256, vec3(0.1f))}};
  Development how;
  how.against_file = file;
  auto against = half_seen(vec3(0.2f));
  against->frame.lights = file->picture.frame.lights;
  how.against = against;
  const auto picture = half_seen(vec3(0.4f));
  picture->frame.lights = {{"key", std::vector<vec3>(256, vec3(0.1f))},
                           {"rim", std::vector<vec3>(256, vec3(0.2f))}};
  how.solo = {"rim"};
  DevelopedPtr seen = develop(picture, how);
  EXPECT_EQ(seen->lacks, "rim");
  EXPECT_FALSE(seen->figures);
  how.solo = {"key"};
  seen = develop(picture, how);
  EXPECT_EQ(seen->lacks, "");
  ASSERT_TRUE(seen->figures);
  EXPECT_TRUE(std::isinf(seen->figures->psnr)) << "the layers are the same";
  how.solo.clear();
  how.layer = "depth";
  EXPECT_EQ(develop(picture, how)->lacks, "depth");
}

// Half the sides, of what was seen at that size.
std::shared_ptr<ViewPicture> quick_of(const ViewPicture& whole) {
  auto quick = std::make_shared<ViewPicture>(whole);
  quick->quick = true;
  quick->scene.width = whole.frame.width;
  quick->scene.height = whole.frame.height;
  const Frame& from = whole.frame;
  Frame& small = quick->frame;
  small.width /= 2;
  small.height /= 2;
  const auto halved = [&](const auto& layer) {
    auto half = layer;
    half.clear();
    for (int y = 0; y < small.height; ++y)
      for (int x = 0; x < small.width; ++x) {
        const auto at = [&](int k) {
          return layer[std::size_t((2 * y + k / 2) * from.width + 2 * x + k % 2)];
        };
        half.push_back((at(0) + at(1) + at(2) + at(3)) / 4.0f);
      }
    return half;
  };
  for (auto* layer :
       {&small.beauty, &small.transmittance, &small.ambient, &small.emission, &small.background})
    *layer = halved(*layer);
  small.depth = halved(small.depth);
  return quick;
}

TEST(Development, AQuickPicturesDifferenceIsRoughButThere) {
  Development how;
  how.against = half_seen(vec3(0.2f));
  how.seen = Seen::difference;
  const auto whole = half_seen(vec3(0.2f));
  whole->scene.width = whole->scene.height = 16;
  const DevelopedPtr seen = develop(quick_of(*whole), how);
  ASSERT_TRUE(seen->figures && seen->is_rough);
  EXPECT_GT(seen->figures->psnr, 100.0);
  for (const std::uint8_t byte : seen->bytes) EXPECT_NEAR(byte, 128, 1) << "grey: it agrees";
}

// While a hand turns a light, what is to be watched stays in sight.
TEST(Development, AQuickPictureIsMeasuredRoughlySoThatFiguresFollowTheHand) {
  Development how;
  how.against = half_seen(vec3(0.2f));
  const auto whole = half_seen(vec3(0.4f));
  const DevelopedPtr measured = develop(whole, how);
  EXPECT_FALSE(measured->is_rough);
  const DevelopedPtr rough = develop(quick_of(*whole), how);
  ASSERT_TRUE(rough->figures);
  EXPECT_TRUE(rough->is_rough);
  EXPECT_EQ(rough->against, how.against);
  EXPECT_NEAR(rough->figures->psnr, measured->figures->psnr, 0.5);
  EXPECT_NEAR(rough->figures->balance->x, 2.0f, 0.02f);
  // The hand comes nearer.
  const DevelopedPtr nearer = develop(quick_of(*half_seen(vec3(0.22f))), how);
  EXPECT_GT(nearer->figures->psnr, rough->figures->psnr + 6.0);
  EXPECT_NEAR(nearer->figures->balance->x, 1.1f, 0.02f);
  how.seen = Seen::flip;
  const DevelopedPtr far = develop(quick_of(*whole), how);
  EXPECT_TRUE(far->figures->flip);
  EXPECT_NE(far->bytes, rough->bytes) << "the error, not the picture";
  // One of another size cannot be held against it.
  const auto other_size = quick_of(*whole);
  other_size->scene.width = 20;
  EXPECT_FALSE(develop(other_size, how)->figures);
  how.against = nullptr;
  EXPECT_FALSE(develop(quick_of(*whole), how)->figures);
}

TEST(Development, AQuickPictureIsMeasuredAgainstAFileAsThatWasMatchedLast) {
  const auto file = std::make_shared<FilePicture>();
  file->picture.frame = half_seen(vec3(0.2f))->frame;
  file->picture.has_alpha = true;
  std::atomic<int> woken{0};
  Developer developer([&] { ++woken; });
  const auto developed = [&](const ViewPicturePtr& picture, const Development& how) {
    const int before = woken;
    developer.ask(picture, how);
    while (woken == before) std::this_thread::yield();
    return developer.developed();
  };
  Development how;
  how.against = half_seen(vec3(0.2f));
  how.against_file = file;
  how.matching.exposure = true;
  const auto whole = half_seen(vec3(0.4f));
  const auto quick = quick_of(*whole);
  EXPECT_FALSE(developed(quick, how)->figures) << "how it is matched is not known yet";
  const DevelopedPtr measured = developed(whole, how);
  for (int i = 0; i < 3; ++i) {
    const DevelopedPtr seen = developed(quick, how);
    ASSERT_TRUE(seen->figures && seen->is_rough);
    EXPECT_EQ(seen->other, measured->other);
    EXPECT_EQ(seen->figures->matched, measured->figures->matched);
    EXPECT_NEAR(seen->figures->balance->x, 2.0f, 0.02f);
  }
  how.against = half_seen(vec3(0.3f));
  EXPECT_FALSE(developed(quick, how)->figures) << "another picture is matched otherwise";
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
