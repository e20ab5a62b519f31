// What an edit costs, in counters.
#include <cmath>
#include <fstream>
#include <string>

#include "tests/viewport/scenes.h"
#include "viewport/gl/egl_context.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

class Edits : public testing::Test {
 protected:
  Edits() : renderer(make_gl_renderer()), scene(ash_scene(64, 64)) {
    before = renderer->render(scene, 1);
    builds = renderer->stats().map_builds;
    uploads = renderer->stats().volume_uploads;
  }
  std::unique_ptr<Renderer> renderer;
  SceneSnapshot scene;
  Frame before;
  std::int64_t builds = 0, uploads = 0;
};

TEST_F(Edits, TheFirstPictureBuildsOneMapPerLight) {
  EXPECT_EQ(builds, std::int64_t(scene.lights.size()));
  EXPECT_EQ(uploads, 1);
}

TEST_F(Edits, AlbedoPhaseLightColourAndCameraBuildNoMapAndUploadNothing) {
  const vec3 extinction = scene.media[0].sigma_s + scene.media[0].sigma_a;
  scene.media[0].sigma_s = 0.3f * extinction;
  scene.media[0].sigma_a = extinction - scene.media[0].sigma_s;
  const Frame darker = renderer->render(scene, 1);
  EXPECT_GT(largest_difference(before, darker), 0.05);
  scene.lights[0].colour = {1, 0.3f, 0.1f};
  scene.lights[0].exposure += 1.0f;
  scene.media[0].phase = {PhaseKind::henyey_greenstein, 0.5f};
  scene.camera.focal_length *= 1.1f;
  renderer->render(scene, 1);
  EXPECT_EQ(renderer->stats().map_builds, builds);
  EXPECT_EQ(renderer->stats().volume_uploads, uploads);
}

TEST_F(Edits, ExtinctionBuildsAllMapsAndOneLightsDirectionOnlyItsOwn) {
  scene.lights[1].toward = glm::normalize(scene.lights[1].toward + vec3(0.1f, 0, 0));
  renderer->render(scene, 1);
  EXPECT_EQ(renderer->stats().map_builds, builds + 1);
  scene.media[0].density_scale *= 1.1f;
  renderer->render(scene, 1);
  EXPECT_EQ(renderer->stats().map_builds, builds + 1 + std::int64_t(scene.lights.size()));
  EXPECT_EQ(renderer->stats().volume_uploads, uploads);
}

// By the power law, and only where it is asked for; then the picture is near that of a map of its own, and
// not that of the density before.
TEST_F(Edits, AMapServesAnotherExtinctionWhereAQuickPictureAsksForIt) {
  scene.media[0].density_scale *= 1.6f;
  scene.extinction_reuse = 2.0f;
  const Frame reused = renderer->render(scene, 1);
  EXPECT_EQ(renderer->stats().map_builds, builds);
  scene.extinction_reuse = 1.0f;
  const Frame own = renderer->render(scene, 1);
  EXPECT_EQ(renderer->stats().map_builds, builds + std::int64_t(scene.lights.size()));
  EXPECT_EQ(largest_difference(own, make_gl_renderer()->render(scene, 1)), 0.0);
  const auto rms = [](const Frame& a, const Frame& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.beauty.size(); ++i) {
      const vec3 d = a.beauty[i] - b.beauty[i];
      sum += double(dot(d, d));
    }
    return std::sqrt(sum / (3.0 * double(a.beauty.size())));
  };
  // Less than half the size costs a quick picture, 36 dB; the change itself is more.
  constexpr double half_size = 0.0158;
  EXPECT_LT(rms(reused, own), half_size);
  EXPECT_GT(rms(before, own), 2.0 * half_size);
}

TEST_F(Edits, TheSamePictureComesBackToTheBitAfterAnEditIsTakenBack) {
  SceneSnapshot edited = scene;
  edited.quality = shipped_preset("high");
  renderer->render(edited, 1);
  const Frame again = renderer->render(scene, 1);
  EXPECT_EQ(largest_difference(before, again), 0.0);
}

// [bytes] of memory of this process that is no file's.
double resident_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("RssAnon:")) return 1024.0 * std::stod(line.substr(8));
  return 0.0;
}

TEST_F(Edits, AnEmptySceneGivesBackWhatTheSceneBeforeTook) {
  if (gl::describe_current_context().find("llvmpipe") == std::string::npos)
    GTEST_SKIP() << "maps are not in this process";
  scene.quality.map.resolution = 1024;
  const Frame large = renderer->render(scene, 1);
  const auto map_bytes = double(renderer->stats().map_bytes);
  ASSERT_GT(map_bytes, 3e7);
  const double with = resident_bytes();
  SceneSnapshot empty = scene;
  empty.media.clear();
  renderer->render(empty, 1);
  EXPECT_LT(resident_bytes(), with - 0.9 * map_bytes);
  EXPECT_EQ(largest_difference(large, renderer->render(scene, 1)), 0.0);
}

TEST_F(Edits, ACancelledPictureLeavesTheRendererAbleToMakeTheNext) {
  scene.lights[0].toward = glm::normalize(scene.lights[0].toward + vec3(0.2f, 0, 0));
  int asked = 0;
  EXPECT_THROW(renderer->render(scene, 4, [&](double) { return ++asked < 3; }), RenderCancelled);
  const Frame whole = renderer->render(scene, 1);
  const Frame fresh = make_gl_renderer()->render(scene, 1);
  EXPECT_EQ(largest_difference(whole, fresh), 0.0);
}

}  // namespace
}  // namespace plinian::test
