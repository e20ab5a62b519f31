// Scenes and measures that the tests of the map renderers share.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/image/metrics.h"
#include "core/scene/frame.h"
#include "core/scene/renderer.h"

namespace plinian::test {

/// The preset of this name as shipped.
Quality shipped_preset(const std::string& name);

/// The default scene, with its camera and lights, at a resolution of the volume and a size of the picture.
SceneSnapshot ash_scene(int resolution, int size);

/// ../shared/peers/scenes/NAME.json, or ../shared/data/NAME under default light; nothing where they are not
/// there.
bool shared_files_here();
SceneSnapshot shared_scene(const std::string& name, int size);

/// densityAndHeat.vdb as a fire by dim light: thin enough to see the hot core, which a skin of a thousandth
/// of its density hides at the usual density scale.
SceneSnapshot fire_scene(int size);

/// A scene of one analytic sphere in a box of haze, without any file.
SceneSnapshot analytic_scene(int size);

PixelMetrics compare(const Frame& picture, const Frame& reference);
double structural_similarity(const Frame& picture, const Frame& reference);

/// The largest difference of any channel of beauty.
double largest_difference(const Frame& a, const Frame& b);

/// Whether every layer holds finite numbers only, depth aside.
bool all_finite(const Frame& frame);

}  // namespace plinian::test

#define SKIP_WITHOUT_SHARED_FILES() \
  if (!plinian::test::shared_files_here()) GTEST_SKIP() << "../shared is not here"
