// The renderer beside the window: what it finishes, and what it gives up.
#include "host/window/view/view_renderer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/scene/frame_layers.h"

namespace plinian::window {
namespace {

// Goes on until it may end, or is told to.
class Patient final : public Renderer {
 public:
  struct Life {
    std::atomic<bool> may_end{false};
    std::atomic<int> begun{0}, cancelled{0};
  };
  explicit Patient(Life& life) : life_(life) {}

  Frame render(const SceneSnapshot& scene, const Passes&, const Progress& progress) override {
    ++life_.begun;
    while (!life_.may_end && !scene.media.empty()) {
      if (progress && !progress(0.5)) {
        ++life_.cancelled;
        throw RenderCancelled();
      }
      std::this_thread::yield();
    }
    return empty_frame(scene);
  }
  const RenderStats& stats() const override { return stats_; }

 private:
  Life& life_;
  RenderStats stats_;
};

SceneSnapshot scene_of(const std::string& medium) {
  SceneSnapshot scene;
  scene.width = scene.height = 8;
  if (medium.empty()) return scene;
  scene.media.emplace_back();
  scene.media.back().name = medium;
  return scene;
}

bool comes(const std::function<bool()>& there) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!there() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return there();
}

TEST(ViewRenderer, FinishesAQuickPictureOfWhatIsTunedAndGivesUpThatOfWhatHasGone) {
  Patient::Life life;
  ViewRenderer renderer([&] { return std::make_unique<Patient>(life); }, [] {});
  renderer.ask({.scene = scene_of("smoke"), .number = 1, .hand_on = true});
  ASSERT_TRUE(comes([&] { return life.begun == 1; }));
  SceneSnapshot tuned = scene_of("smoke");
  tuned.media[0].density_scale = 7.0f;
  renderer.ask({.scene = tuned, .number = 2, .hand_on = true});
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(life.cancelled, 0) << "a hand that never rests would see none";
  EXPECT_EQ(life.begun, 1);
  renderer.ask({.scene = scene_of(""), .number = 3, .hand_on = true});
  ASSERT_TRUE(comes([&] { return renderer.picture() && renderer.picture()->number == 3; }));
  EXPECT_EQ(life.cancelled, 1) << "it is of no use any more";
}

}  // namespace
}  // namespace plinian::window
