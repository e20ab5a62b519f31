// A sitting before a ball, with a plug-in that draws.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tests/host/window/steps.h"

namespace plinian {

// A white ball of radius 1 around the origin, seen from (0, 0, 6) with 40 degrees from top to bottom.
inline constexpr const char* ball_scene = R"({"volume": "sphere", "density_scale": 40.0, "size": [640, 480],
  "camera": {"eye": [0, 0, 6], "target": [0, 0, 0], "fov_y_degrees": 40},
  "lights": [{"type": "directional", "toward": [0.3, 0.5, 1], "irradiance": [9, 9, 9]}]})";

class DrawingSitting : public testing::Test {
 protected:
  static constexpr ivec2 size{1100, 760};

  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  }
  /// Opens a neutral scene, and a plug-in.
  void sit_down(const std::string& plugin = "marker", const char* neutral = ball_scene) {
    sitting_ = std::make_unique<Sitting>(std::vector<std::string>{files_.write("ball.json", neutral)}, size);
    wait_for_rest(0);
    command("loadPlugin \"" PLINIAN_TEST_PLUGINS "/" + plugin + ".so\"");
  }
  /// Types it, and waits until what it does is seen.
  void command(const std::string& line) {
    sitting_->click(sitting_->middle("command line"));
    sitting_->wait_for_keys("keys to a field");
    const std::size_t before = sitting_->now();
    sitting_->type(line);
    sitting_->stroke("Return");
    sitting_->wait_for(" still", sitting_->wait_for("ran " + line, before));
  }
  /// Waits for the picture of what was asked for to be at rest on the screen.
  void wait_for_rest(std::size_t since) { plinian::wait_for_rest(*sitting_, since); }

  TemporaryFolder files_;
  std::unique_ptr<Sitting> sitting_;
};

}  // namespace plinian
