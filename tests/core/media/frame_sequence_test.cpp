#include "core/media/frame_sequence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/scene/temporary_folder.h"

namespace plinian {
namespace {

std::string frame_of(const std::string& pattern, int frame) {
  const auto parsed = FramePattern::parse(pattern);
  return parsed ? parsed->path(frame) : "(no pattern)";
}

TEST(FrameSequence, ReadsTheWaysInWhichProgramsWriteSequences) {
  EXPECT_EQ(frame_of("a/smoke.####.vdb", 7), "a/smoke.0007.vdb");
  EXPECT_EQ(frame_of("a/smoke.%04d.vdb", 7), "a/smoke.0007.vdb");
  EXPECT_EQ(frame_of("a/smoke.%d.vdb", 7), "a/smoke.7.vdb");
  EXPECT_EQ(frame_of("a/smoke.$F4.vdb", 7), "a/smoke.0007.vdb");
  EXPECT_EQ(frame_of("a/smoke.$F.vdb", 7), "a/smoke.7.vdb");
  EXPECT_EQ(frame_of("smoke_00000#.vdb", 3), "smoke_000003.vdb");
  EXPECT_EQ(frame_of("smoke.##.vdb", 123), "smoke.123.vdb") << "more digits than places";
  EXPECT_EQ(frame_of("smoke.####.vdb", -12), "smoke.-0012.vdb");
  EXPECT_EQ(frame_of("smoke.vdb", 1), "(no pattern)");
  EXPECT_EQ(frame_of("take#2/smoke.vdb", 1), "(no pattern)") << "a folder is no frame";
  EXPECT_EQ(frame_of("100%full.vdb", 1), "(no pattern)");
}

TEST(FrameSequence, IsCalledByItsNameWithoutTheNumber) {
  for (const char* path : {"shots/smoke.####.vdb", "shots/smoke.%04d.vdb", "shots/smoke_$F4.vdb",
                           "shots/smoke-#.vdb", "shots/smoke####.vdb"})
    EXPECT_EQ(FramePattern::parse(path)->unnumbered(), "shots/smoke.vdb") << path;
}

TEST(FrameSequence, FindsItsFilesAndNoOthers) {
  TemporaryFolder folder;
  for (const char* name : {"s.0003.vdb", "s.0001.vdb", "s.0010.vdb", "s.-0002.vdb", "s.12.vdb",
                           "s.0004.vdb.bak", "s.x.vdb", "other.0002.vdb", "s.99999999999.vdb"})
    folder.write(name, "");
  const auto pattern = FramePattern::parse(folder / "s.####.vdb");
  ASSERT_TRUE(pattern);
  EXPECT_EQ(pattern->frames_on_disk(), (std::vector<int>{-2, 1, 3, 10}));
  EXPECT_TRUE(FramePattern::parse("/nowhere/s.#.vdb")->frames_on_disk().empty());
}

// The frames that a row of times shows; blank is -1.
std::vector<int> shown(const FrameTiming& timing, double from, double to, double step = 1.0) {
  std::vector<int> frames;
  for (double time = from; time <= to; time += step)
    frames.push_back(frame_in_range(timing, source_frame(timing, time)).value_or(-1));
  return frames;
}

TEST(FrameSequence, ShowsTheFrameOfTheTimeAndWhatIsAskedForBeyond) {
  FrameTiming t{.start = 2, .end = 4};
  EXPECT_EQ(shown(t, 0, 6), (std::vector<int>{2, 2, 2, 3, 4, 4, 4}));
  t.before = Beyond::blank;
  t.after = Beyond::loop;
  EXPECT_EQ(shown(t, 0, 8), (std::vector<int>{-1, -1, 2, 3, 4, 2, 3, 4, 2}));
  t.before = Beyond::ping_pong;
  t.after = Beyond::ping_pong;
  EXPECT_EQ(shown(t, -2, 9), (std::vector<int>{2, 3, 4, 3, 2, 3, 4, 3, 2, 3, 4, 3}));
  t.before = Beyond::loop;
  EXPECT_EQ(shown(t, -1, 2), (std::vector<int>{2, 3, 4, 2}));
}

TEST(FrameSequence, IsRetimed) {
  EXPECT_EQ(shown({.start = 1, .end = 9, .speed = 0.5}, 1, 6), (std::vector<int>{1, 1, 2, 2, 3, 3}));
  EXPECT_EQ(shown({.start = 1, .end = 9, .offset = 2}, 1, 5), (std::vector<int>{1, 1, 1, 2, 3}));
  EXPECT_EQ(shown({.start = 1, .end = 4, .speed = -1}, 1, 5), (std::vector<int>{4, 3, 2, 1, 1}));
  EXPECT_EQ(shown({.start = 1, .end = 9, .frames_per_second = 48}, 1, 4), (std::vector<int>{1, 3, 5, 7}));
  // A tenth has no exact binary form: its tenfold must be a whole frame all the same.
  FrameTiming slow{.start = 0, .end = 100, .speed = 0.1};
  for (int frame = 0; frame < 100; ++frame)
    EXPECT_EQ(frame_in_range(slow, source_frame(slow, frame * 10.0)), frame);
}

TEST(FrameSequence, NonsenseShowsNothing) {
  EXPECT_FALSE(frame_in_range({.start = 3, .end = 2}, 3));
  EXPECT_FALSE(frame_in_range({}, std::nan("")));
  EXPECT_FALSE(frame_in_range({}, 1e300));
  EXPECT_EQ(frame_in_range({.start = 5, .end = 5, .after = Beyond::ping_pong}, 9), 5);
}

}  // namespace
}  // namespace plinian
