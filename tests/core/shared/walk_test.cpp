// A walk ends, and passes all the matter on its way, however small its steps are beside the distance.
#include "core/shared/walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/integrate/flat_scene.h"

namespace plinian {
namespace {

struct Passed {
  int segments = 0;
  double column = 0.0;  // [world * density]
};

// Along +z, through the middle of a medium around the origin, from `distance` in front of it.
Passed walk_through(const Medium& medium, double distance, float step) {
  SceneSnapshot snapshot;
  snapshot.media.push_back(medium);
  const FlatScene flat = flatten(snapshot);
  const MarchViews views = view_of(flat, nullptr);
  shared::Walk walk = shared::walk_begin(views.scene, vec3(0.011f, -0.007f, float(-distance)), {0, 0, 1},
                                         0.0f, step, 0.3f * step, -1);
  Passed passed;
  // A walk that stands still is what this looks for: it must not hang the test.
  for (; walk.t_b < walk.t_end && passed.segments < 100000; ++passed.segments) {
    shared::walk_advance(views.scene, walk);
    passed.column += 0.5 * (double(walk.a[0]) + walk.b[0]) * (double(walk.t_b) - walk.t);
  }
  return passed;
}

// Distances at which a step is a good number of roundings, a few of them, or less than one.
std::vector<double> distances() {
  std::vector<double> all;
  for (double d = 3.0; d < 1e7; d *= 1.37) all.push_back(d);
  return all;
}

TEST(Walk, EndsBehindABoxHoweverFarItBegins) {
  Medium box;
  box.shape = MediumShape::box;
  for (const double distance : distances()) {
    const Passed passed = walk_through(box, distance, 1.0f);
    EXPECT_LE(passed.segments, 140) << "64 steps, and a rounding beside each, from " << distance;
    EXPECT_NEAR(passed.column, 2.0, 1e-5 + 3e-7 * distance) << distance;
  }
}

TEST(Walk, EndsBehindVoxelsHoweverFarItBegins) {
  BrickVolumeBuilder builder;
  const std::vector<float> ones(512, 1.0f);
  for (int z = -2; z < 2; ++z)
    for (int y = -1; y < 1; ++y)
      for (int x = -1; x < 1; ++x) builder.add({x, y, z}, ones.data());
  Medium medium;
  medium.volume = std::make_shared<BrickVolume>(builder.build(dmat4(1.0)));
  for (const double distance : distances()) {
    if (distance < 40.0) continue;
    const Passed passed = walk_through(medium, distance, 0.25f);
    // 33 voxels in quarter steps, each cut into four where it is opaque, and a rounding beside some.
    EXPECT_LE(passed.segments, 33 * 4 * 4 + 100) << distance;
    // Further away than this a step is longer than half a voxel, whatever was asked for.
    if (distance < 25000.0) {
      EXPECT_NEAR(passed.column, 32.0, 0.05 + 2e-6 * distance) << distance;
    }
  }
}

}  // namespace
}  // namespace plinian
