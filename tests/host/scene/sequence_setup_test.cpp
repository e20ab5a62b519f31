// Which frames of a sequence speak for it.
#include "host/scene/sequence_setup.h"

#include <gtest/gtest.h>

#include "core/media/brick_volume.h"

namespace plinian::scene {
namespace {

// Frames that show something or nothing, and say how they are oriented or nothing.
struct Sequence {
  std::vector<int> shown, z_up;
  std::vector<int> read;  // in this order
  std::vector<int> broken{};

  SequenceSetup set_up(const std::vector<int>& frames, bool whole) {
    return set_up_sequence(frames, whole, [this](int frame) -> SequenceFrame {
      read.push_back(frame);
      SequenceFrame result;
      BrickVolumeBuilder builder;
      const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, float(frame));
      if (std::count(shown.begin(), shown.end(), frame)) builder.add({0, 0, 0}, voxels.data());
      result.volume = std::make_shared<const BrickVolume>(builder.build(dmat4(1.0)));
      result.readable = !std::count(broken.begin(), broken.end(), frame);
      result.facts.path = "folder/s." + std::to_string(frame) + ".vdb";
      result.facts.orientation.reason = "nothing says";
      if (std::count(z_up.begin(), z_up.end(), frame))
        result.facts.orientation = {1.0, 'z', false, false, "z is up"};
      return result;
    });
  }
};

TEST(SequenceSetup, TheFirstFrameThatShowsAnythingIsTheOneToSetUpBy) {
  Sequence sequence{.shown = {3, 4, 5, 6, 7}, .z_up = {}, .read = {}};
  const SequenceSetup setup = sequence.set_up({1, 2, 3, 4, 5, 6, 7}, false);
  EXPECT_EQ(setup.frame, 3);
  EXPECT_EQ(setup.volume->density_max, 3.0f);
  EXPECT_TRUE(setup.others.empty());
  EXPECT_EQ(setup.facts.orientation.up_axis, 'y');
  EXPECT_EQ(sequence.read, (std::vector<int>{1, 2, 3})) << "no more is read than is needed";
  EXPECT_EQ(setup.note, "7 frames, 1 to 7; set up by frame 3, the first that shows anything");
}

TEST(SequenceSetup, ACameraIsPlacedByTheMiddleAndTheLastFrameAsWell) {
  Sequence sequence{.shown = {3, 4, 5, 6, 7}, .z_up = {}, .read = {}};
  const SequenceSetup setup = sequence.set_up({1, 2, 3, 4, 5, 6, 7}, true);
  ASSERT_EQ(setup.others.size(), 2u);
  EXPECT_EQ(setup.others[0]->density_max, 5.0f);
  EXPECT_EQ(setup.others[1]->density_max, 7.0f);
  EXPECT_EQ(sequence.read.back(), 3) << "time stands where it was set up";
  Sequence single{.shown = {4}, .z_up = {}, .read = {}};
  EXPECT_TRUE(single.set_up({4}, true).others.empty());
}

TEST(SequenceSetup, ABrokenFrameHasNoSay) {
  Sequence sequence{.shown = {1, 2, 3, 4, 5}, .z_up = {}, .read = {}, .broken = {1, 5}};
  const SequenceSetup setup = sequence.set_up({1, 2, 3, 4, 5}, true);
  EXPECT_EQ(setup.frame, 2);
  ASSERT_EQ(setup.others.size(), 2u);
  EXPECT_EQ(setup.others[0]->density_max, 3.0f);
  EXPECT_EQ(setup.others[1]->density_max, 4.0f);
  EXPECT_EQ(
      setup.note,
      "5 frames, 1 to 5; set up by frame 2, the first that shows anything; the camera shows frames 3 and 4 "
      "as well");
  Sequence two{.shown = {1, 2}, .z_up = {}, .read = {}, .broken = {2}};
  EXPECT_EQ(two.set_up({1, 2}, true).note, "2 frames, 1 to 2; set up by frame 1");
}

TEST(SequenceSetup, TheFirstFileThatSaysWhichWayIsUpSpeaksForAll) {
  Sequence sequence{.shown = {2, 3}, .z_up = {1}, .read = {}};
  SequenceSetup setup = sequence.set_up({1, 2, 3}, false);
  EXPECT_EQ(setup.facts.orientation.up_axis, 'z');
  EXPECT_EQ(setup.facts.orientation.reason, "z is up, by what s.1.vdb says");
  EXPECT_EQ(setup.facts.path, "folder/s.2.vdb");
  sequence.z_up = {3};
  EXPECT_EQ(sequence.set_up({1, 2, 3}, true).facts.orientation.up_axis, 'z');
}

TEST(SequenceSetup, WithoutAnythingToShowItSaysSo) {
  Sequence sequence;
  const SequenceSetup setup = sequence.set_up({4, 5}, true);
  EXPECT_EQ(setup.frame, 4);
  EXPECT_TRUE(setup.volume->empty());
  EXPECT_EQ(setup.warning, "none of the sequence's frames shows anything");
  EXPECT_EQ(setup.note, "");
}

}  // namespace
}  // namespace plinian::scene
