// What pictures are compared with: from files, matched; on one side of a line; kept as snapshots.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <numbers>
#include <thread>

#include "core/image/image_io.h"
#include "host/window/compare/comparison.h"
#include "host/window/compare/reference_images.h"
#include "host/window/compare/reference_picture.h"
#include "host/window/compare/snapshots.h"
#include "host/window/compare/wipe.h"
#include "host/window/files/recent_files.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::window {
namespace {

namespace fs = std::filesystem;

float area(const std::vector<vec2>& polygon) {
  float sum = 0.0f;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return std::abs(sum) * 0.5f;
}

TEST(Wipe, TheLineCutsThePictureWhereItIsAndAsItIsTurned) {
  const vec2 begin(100.0f, 50.0f), size(400.0f, 200.0f);
  Wipe wipe;
  wipe.at = {0.25f, 0.5f};
  EXPECT_NEAR(area(wipe.other_side(begin, size)), 100.0f * 200.0f, 1.0f);
  EXPECT_GT(wipe.distance({150.0f, 100.0f}, begin, size), 0.0f) << "the other one is on the left";
  wipe.angle = std::numbers::pi_v<float> / 2.0f;  // level
  wipe.at = {0.5f, 0.25f};
  EXPECT_NEAR(area(wipe.other_side(begin, size)), 400.0f * 50.0f, 1.0f);
  wipe.angle = 0.6f;
  wipe.at = {0.5f, 0.5f};
  EXPECT_NEAR(area(wipe.other_side(begin, size)), 200.0f * 200.0f, 1.0f) << "through the middle: a half";
  // The other side and this one make up the picture.
  wipe.at = {0.9f, 0.2f};
  const float one = area(wipe.other_side(begin, size));
  wipe.angle += std::numbers::pi_v<float>;
  EXPECT_NEAR(one + area(wipe.other_side(begin, size)), 400.0f * 200.0f, 1.0f);
}

TEST(Wipe, APolygonIsCutToWhereAPictureLies) {
  const std::vector<vec2> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_NEAR(area(clipped(square, {2, 3}, {5, 20})), 5.0f * 7.0f, 1e-4f);
  EXPECT_NEAR(area(clipped(square, {-5, -5}, {50, 50})), 100.0f, 1e-4f);
  EXPECT_TRUE(clipped(square, {20, 0}, {5, 5}).empty());
  EXPECT_NEAR(area(clipped({{0, 0}, {10, 0}, {0, 10}}, {0, 0}, {5, 5})), 25.0f, 1e-4f)
      << "to a corner of its edge";
}

TEST(Wipe, TurnsToWhereAGripIsDragged) {
  const vec2 begin(0.0f), size(200.0f);
  Wipe wipe;
  for (const bool forwards : {true, false}) {
    wipe.turn_to({150.0f, 130.0f}, begin, size, forwards);
    EXPECT_NEAR(wipe.distance({150.0f, 130.0f}, begin, size), 0.0f, 1e-3f);
    EXPECT_GT(glm::dot(wipe.along(), vec2(50.0f, 30.0f)) * (forwards ? 1.0f : -1.0f), 0.0f);
  }
  wipe.move_to({-50.0f, 100.0f}, begin, size);
  EXPECT_EQ(wipe.at, vec2(0.0f, 0.5f)) << "it stays within the picture";
}

// A picture of something half transparent before a background.
Frame frame_of(int side, float radiance, vec3 background) {
  Frame frame;
  frame.width = frame.height = side;
  const std::size_t pixels = std::size_t(side) * side;
  for (std::size_t i = 0; i < pixels; ++i) {
    const float t = i % 3 == 0 ? 1.0f : i % 3 == 1 ? 0.5f : 0.0f;
    frame.transmittance.push_back(vec3(t));
    frame.background.push_back(background * t);
    frame.beauty.push_back(vec3(radiance, radiance * 0.5f, radiance * float(i % 7)) * (1.0f - t) +
                           background * t);
  }
  frame.depth.assign(pixels, INFINITY);
  frame.ambient = frame.emission = std::vector<vec3>(pixels, vec3(0.0f));
  return frame;
}

double largest_difference(const Frame& a, const Frame& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.beauty.size(); ++i)
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, double(std::abs(a.beauty[i][c] - b.beauty[i][c])));
  return largest;
}

constexpr Matching everything{.exposure = true, .background = true};

TEST(Match, FindsExposureAndBackgroundOfTheSameMediumAndSaysSo) {
  const vec3 grey(0.2f), blue(0.0f, 0.1f, 0.4f);
  const Frame picture = frame_of(16, 0.8f, grey);
  // The same at half the light, before another background that its file holds no layer of.
  Image image = frame_to_image(frame_of(16, 0.4f, blue));
  std::erase_if(image.channels, [](const Channel& c) { return c.name.starts_with("background"); });
  const ReadPicture read = read_picture(image, "", "auto", 0.0f);
  ASSERT_TRUE(read.has_alpha);
  const Match matched = match(picture, grey, read, everything);
  EXPECT_NEAR(matched.stops.value(), 1.0f, 1e-4f);
  EXPECT_TRUE(matched.background);
  EXPECT_EQ(matched.text(), "matched by +1.00 EV, over this background");
  EXPECT_LT(largest_difference(matched.frame, picture), 1e-4);
  // The same picture needs nothing.
  const Match same =
      match(picture, grey, read_picture(frame_to_image(picture), "", "auto", 0.0f), everything);
  EXPECT_EQ(same.text(), "matched by +0.00 EV") << "it would be, were it another";
  EXPECT_LT(largest_difference(same.frame, picture), 1e-5);
}

TEST(Match, DoesNoMoreThanItIsAskedFor) {
  const vec3 grey(0.2f), blue(0.0f, 0.1f, 0.4f);
  const Frame picture = frame_of(16, 0.8f, grey), dim = frame_of(16, 0.4f, blue);
  const ReadPicture read = read_picture(frame_to_image(dim), "", "auto", 0.0f);
  const Match behind = match(picture, grey, read, {.background = true});
  EXPECT_EQ(behind.text(), "over this background");
  EXPECT_LT(largest_difference(behind.frame, frame_of(16, 0.4f, grey)), 1e-5);
  const Match lit = match(picture, grey, read, {.exposure = true});
  EXPECT_EQ(lit.text(), "matched by +1.00 EV");
  EXPECT_LT(largest_difference(lit.frame, frame_of(16, 0.8f, blue)), 1e-4);
  const Match as_it_came = match(picture, grey, read, {});
  EXPECT_EQ(as_it_came.text(), "");
  EXPECT_LT(largest_difference(as_it_came.frame, dim), 1e-5);
}

// Else who looks for a light would be told that it is found.
TEST(Match, LeavesTheExposureOfSceneLinearPicturesAsItIs) {
  const TemporaryFolder folder;
  write_image(folder / "ours.exr", frame_to_image(frame_of(8, 0.4f, vec3(0.1f))));
  write_image(folder / "plain.exr", make_image(8, 8, vec3(0.5f)));
  write_image(folder / "seen.png", make_image(8, 8, vec3(0.5f)));
  const auto usual = [&](const char* name, const char* colour_space = "auto") {
    return usual_matching(read_picture(read_image(folder / name), "", colour_space, 0.0f));
  };
  EXPECT_EQ(usual("ours.exr"), (Matching{.exposure = false, .background = true}));
  EXPECT_EQ(usual("plain.exr"), (Matching{.exposure = false, .background = false}));
  EXPECT_EQ(usual("seen.png"), (Matching{.exposure = true, .background = false}));
  EXPECT_FALSE(usual("seen.png", "linear").exposure) << "it is said to be so";
  EXPECT_TRUE(usual("plain.exr", "srgb").exposure);
}

TEST(ReadPicture, TakesALayerAColourSpaceAndAnExposure) {
  Image image = make_image(4, 2, vec3(0.5f));
  for (const char* name : {"key.R", "key.G", "key.B"}) image.add(name, 0.25f);
  image.add("Z", 3.0f);
  EXPECT_EQ(colour_layers(image), (std::vector<std::string>{"", "key"}));
  EXPECT_EQ(read_picture(image, "", "auto", 0.0f).frame.beauty[3], vec3(0.5f));
  EXPECT_EQ(read_picture(image, "key", "linear", 1.0f).frame.beauty[3], vec3(0.5f));
  const ReadPicture layered = read_picture(image, "", "linear", 1.0f);
  ASSERT_EQ(layered.frame.lights.size(), 1u);
  EXPECT_EQ(layered.frame.lights[0].name, "key");
  EXPECT_EQ(layered.frame.lights[0].radiance[3], vec3(0.5f));
  EXPECT_FALSE(layered.has_ambient);
  EXPECT_NEAR(read_picture(image, "", "srgb", 0.0f).frame.beauty[3].x, 0.21404f, 1e-4f);
  try {
    read_picture(image, "kez", "auto", 0.0f);
    FAIL();
  } catch (const ImageError& error) {
    EXPECT_EQ(std::string(error.what()).find("no layer 'kez'"), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find("key"), std::string::npos);
  }
}

// What was chosen for one file says nothing of the next; the frames of a sequence are one.
TEST(Comparison, HowAFileIsMatchedIsChosenForIt) {
  const TemporaryFolder folder;
  for (const int frame : {1, 2})
    write_image(folder / ("ref.000" + std::to_string(frame) + ".exr"), make_image(8, 4, vec3(0.5f)));
  write_image(folder / "seen.png", make_image(8, 4, vec3(0.5f)));
  scene::TestWorkspace w;
  Development development;
  Comparison comparison(w, development, [] {});
  const auto compares_with = [&](const std::string& name) {
    for (int i = 0; i < 2000 && comparison.name != name; ++i) {
      comparison.update();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return comparison.name == name;
  };
  w.run("loadReference " + folder / "ref.####.exr");
  ASSERT_TRUE(compares_with("ref.0001.exr"));
  EXPECT_FALSE(development.matching.exposure);
  development.matching.exposure = true;
  w.run("currentTime 2");
  ASSERT_TRUE(compares_with("ref.0002.exr"));
  EXPECT_TRUE(development.matching.exposure);
  comparison.keep(nullptr, "", OtherKind::none);
  comparison.want_file();
  ASSERT_TRUE(compares_with("ref.0002.exr"));
  EXPECT_TRUE(development.matching.exposure);
  w.run("setAttr reference.file " + folder / "ref.0001.exr");
  ASSERT_TRUE(compares_with("ref.0001.exr"));
  EXPECT_FALSE(development.matching.exposure);
  w.run("setAttr reference.file " + folder / "seen.png");
  ASSERT_TRUE(compares_with("seen.png"));
  EXPECT_TRUE(development.matching.exposure);
}

struct WatchedImages {
  scene::TestWorkspace w;
  ReferenceImages images{w, [] {}};
  bool wait_for(const std::function<bool()>& there) {
    for (int i = 0; i < 2000; ++i) {
      images.update();
      if (there()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
};

TEST(ReferenceImages, FollowTheSceneItsTimeAndTheFile) {
  const TemporaryFolder folder;
  for (const int frame : {1, 2})
    write_image(folder / ("ref.000" + std::to_string(frame) + ".exr"), make_image(8 * frame, 4, vec3(0.5f)));
  WatchedImages t;
  const auto& reference = t.images.reference;
  const auto width = [&] { return reference.picture() ? reference.picture()->picture.frame.width : 0; };
  EXPECT_EQ(t.w.run("loadReference " + folder / "ref.####.exr"), "reference");
  EXPECT_TRUE(t.wait_for([&] { return width() == 8; }));
  t.w.run("currentTime 2");
  EXPECT_TRUE(t.wait_for([&] { return width() == 16; }));
  EXPECT_EQ(reference.picture()->name, "ref.0002.exr");
  write_image(folder / "ref.0002.exr", make_image(24, 4, vec3(0.5f)));
  EXPECT_TRUE(t.wait_for([&] { return width() == 24; })) << "it changed on the disk";
  t.w.run("currentTime 3");
  EXPECT_TRUE(t.wait_for([&] { return reference.problem().find("ref.0003.exr") != std::string::npos; }));
  EXPECT_EQ(width(), 24) << "the last good one stays";
  t.w.run("undo");
  EXPECT_TRUE(t.wait_for([&] { return !reference.picture(); }));
  EXPECT_EQ(t.w.run("loadReference -plate " + folder / "ref.0001.exr"), "plate");
  EXPECT_TRUE(t.wait_for([&] { return t.images.plate.picture() && !reference.picture(); }));
}

ViewPicturePtr picture_of(int side) {
  auto picture = std::make_shared<ViewPicture>();
  picture->frame = frame_of(side, 1.0f, vec3(0.0f));
  return picture;
}

// As where a difference is looked at, which is no picture to be found again by.
TEST(Snapshots, HaveTheirThumbnailMadeBesideTheInterface) {
  scene::TestWorkspace w;
  Snapshots snapshots(w);
  snapshots.keep(picture_of(4), nullptr);
  EXPECT_FALSE(snapshots.all().back().thumbnail);
  std::atomic<bool> woken{false};
  std::thread::id maker;
  snapshots.make_thumbnail({}, [&] {
    maker = std::this_thread::get_id();
    woken = true;
  });
  snapshots.keep(picture_of(4), nullptr);  // another one is the newest meanwhile
  for (int i = 0; i < 5000 && !snapshots.all().front().thumbnail; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    snapshots.update();
  }
  EXPECT_TRUE(woken);
  EXPECT_NE(maker, std::this_thread::get_id());
  ASSERT_TRUE(snapshots.all().front().thumbnail);
  EXPECT_EQ(snapshots.all().front().thumbnail->bytes, develop(snapshots.all().front().picture, {})->bytes);
  EXPECT_FALSE(snapshots.all().back().thumbnail);
}

TEST(Snapshots, RestoreTheSceneInOneStepOfUndo) {
  scene::TestWorkspace w;
  Snapshots snapshots(w);
  w.run("createNode directionalLight -name sun");
  w.run("setAttr sun.intensity 3");
  snapshots.keep(picture_of(4), nullptr);
  w.run("setAttr sun.intensity 5");
  w.run("createNode camera -name second");
  const std::string now = w.run("ls");
  w.run("restoreSnapshot \"snapshot 1\"");
  EXPECT_EQ(w.run("getAttr sun.intensity"), "3");
  EXPECT_EQ(w.run("ls").find("second"), std::string::npos);
  w.run("undo");
  EXPECT_EQ(w.run("getAttr sun.intensity"), "5");
  EXPECT_EQ(w.run("ls"), now);
  EXPECT_THROW(w.run("restoreSnapshot other"), std::runtime_error);
}

TEST(Snapshots, GoByName) {
  scene::TestWorkspace w;
  Snapshots snapshots(w);
  for (int i = 0; i < 3; ++i) snapshots.keep(picture_of(4), nullptr);
  w.run("deleteSnapshot \"snapshot 2\"");
  EXPECT_EQ(snapshots.find("snapshot 2"), nullptr);
  EXPECT_EQ(snapshots.all().size(), 2u);
  EXPECT_THROW(w.run("deleteSnapshot \"snapshot 2\""), std::runtime_error);
  w.run("deleteSnapshot");
  EXPECT_TRUE(snapshots.all().empty());
  EXPECT_EQ(snapshots.bytes(), 0u);
}

TEST(Snapshots, HoldNoMoreMemoryThanTheyMay) {
  scene::TestWorkspace w;
  const std::size_t one = bytes_of(picture_of(32)->frame);
  Snapshots snapshots(w, 3 * one + one / 2);
  for (int i = 1; i <= 3; ++i) EXPECT_TRUE(snapshots.keep(picture_of(32), nullptr).empty());
  EXPECT_EQ(snapshots.keep(picture_of(32), nullptr), std::vector<std::string>{"snapshot 1"});
  EXPECT_LE(snapshots.bytes(), 3 * one + one / 2);
  EXPECT_EQ(snapshots.all().size(), 3u);
  EXPECT_EQ(snapshots.keep(picture_of(256), nullptr).size(), 3u);
  EXPECT_EQ(snapshots.all().back().name, "snapshot 5") << "the new one never goes";
}

TEST(Snapshots, AThumbnailIsTheMeanOfWhatItStandsFor) {
  Developed shown;
  shown.width = 8;
  shown.height = 4;
  for (int i = 0; i < 32; ++i)
    for (int c = 0; c < 3; ++c) shown.bytes.push_back(i % 2 ? 200 : 100);
  const DevelopedPtr small = thumbnail_of(shown, 2);
  EXPECT_EQ(small->width, 4);
  EXPECT_EQ(small->height, 2);
  EXPECT_EQ(small->bytes, std::vector<std::uint8_t>(24, 150));
}

TEST(RecentFiles, AreNewestFirstADozenAndThere) {
  const TemporaryFolder folder;
  RecentFiles recent(fs::path(folder / "state") / "recent");
  EXPECT_TRUE(recent.all().empty());
  for (int i = 0; i < 14; ++i) {
    std::ofstream(folder / (std::to_string(i) + ".vdb")) << i;
    recent.add(folder / (std::to_string(i) + ".vdb"));
  }
  recent.add(folder / "5.vdb");
  std::vector<std::string> all = RecentFiles(fs::path(folder / "state") / "recent").all();
  ASSERT_EQ(all.size(), 12u);
  EXPECT_EQ(all[0], folder / "5.vdb");
  EXPECT_EQ(all[1], folder / "13.vdb");
  fs::remove(folder / "13.vdb");
  EXPECT_EQ(recent.all().size(), 11u);
}

}  // namespace
}  // namespace plinian::window
