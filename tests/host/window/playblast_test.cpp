// A playblast, with the program that renders and the one that films: each way that it can end.
#include "host/window/files/playblast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <thread>

#include "core/image/image_io.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/cli/program.h"

namespace plinian::window {
namespace {

namespace fs = std::filesystem;

TEST(PlayblastFormat, AFilmIsOneFileAndWhatIsNumberedHasAPlaceForIt) {
  EXPECT_EQ(as_format("takes/shot.####.png", ".mp4"), "takes/shot.mp4");
  EXPECT_EQ(as_format("takes/shot.####.png", ".exr"), "takes/shot.####.exr");
  EXPECT_EQ(as_format("takes/shot_%04d.exr", ".mp4"), "takes/shot.mp4");
  EXPECT_EQ(as_format("takes/shot.mp4", ".png"), "takes/shot.####.png");
  EXPECT_EQ(as_format("takes/shot.####.mp4", ".mp4"), "takes/shot.mp4");
  EXPECT_EQ(as_format("takes/shot.####", ".mp4"), "takes/shot.mp4");
  EXPECT_EQ(as_format("takes/shot.####", ".png"), "takes/shot.####.png");
  EXPECT_EQ(as_format("still.png", ".exr"), "still.exr") << "who wants one picture has one";
}

class PlayblastTest : public testing::Test {
 protected:
  // A tiny ball whose light turns, and which is not there at frame 1. passes: of each picture.
  void make_scene(const std::string& passes) {
    folder_.write("shot.pln",
                  "setAttr settings.background 0.2 0.02 0.01\n"
                  "setKeyframe key.rotate.y -time 1 -value 0\n"
                  "setKeyframe key.rotate.y -time 4 -value 120\n"
                  "setKeyframe medium_shape.visibility -time 1 -value 0\n"
                  "setKeyframe medium_shape.visibility -time 2 -value 1\n"
                  "save shot.plinian\n");
    expect_run({"render", "sphere", "-o", "begin.png", "--size", "65x49", "--set", "map.resolution=32",
                "--set", "view.passes=" + passes, "--set", "view.rest_change=0", "--save-scene",
                "shot.plinian", "--passes", "1"});
    expect_run({"run", "shot.pln", "shot.plinian"});
    for (const char* name : {"begin.png", "shot.pln", "shot.plinian.bak"}) fs::remove(folder_ / name);
    std::ifstream file(folder_ / "shot.plinian");
    scene_ = {std::istreambuf_iterator<char>(file), {}};
  }
  void expect_run(const std::vector<std::string>& arguments) {
    const Ended ended = plinian_program(arguments, {.folder = folder_.path().string()});
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  PlayblastSettings settings(const std::string& output) const {
    PlayblastSettings settings;
    settings.first = 1;
    settings.last = 3;
    settings.output = folder_ / output;
    settings.view.view = View::srgb;
    settings.view.exposure = 1.5f;
    return settings;
  }
  void start(const PlayblastSettings& settings) { playblast_.start(settings, scene_, folder_.path()); }
  Playblast::End end() {
    while (true) {
      const std::vector<Playblast::End> ends = playblast_.poll();
      if (!ends.empty()) return ends.front();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  std::string refusal(const PlayblastSettings& settings) {
    try {
      start(settings);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) names.insert(entry.path().filename());
    return names;
  }
  // What `render --frames` makes of the scene beside it is the same picture of the same job.
  void expect_what_render_makes(const std::string& extension) {
    expect_run({"render", "shot.plinian", "--frames", "1-3", "-o", "truth.####" + extension, "--view", "srgb",
                "--exposure", "1.5"});
    for (const char* number : {".0001", ".0002", ".0003"}) {
      SCOPED_TRACE(number);
      const Image made = read_image(folder_ / ("shot" + (number + extension)));
      const Image truth = read_image(folder_ / ("truth" + (number + extension)));
      EXPECT_EQ(made.width, 65) << "the gate's";
      EXPECT_EQ(made.height, 49);
      EXPECT_EQ(made.metadata.at(attribute::job_hash), truth.metadata.at(attribute::job_hash));
      ASSERT_EQ(made.channels.size(), truth.channels.size());
      for (std::size_t c = 0; c < made.channels.size(); ++c) {
        EXPECT_EQ(made.channels[c].name, truth.channels[c].name);
        EXPECT_EQ(made.channels[c].values, truth.channels[c].values) << made.channels[c].name;
      }
    }
    EXPECT_NE(read_image(folder_ / ("shot.0001" + extension)).find("G")->values,
              read_image(folder_ / ("shot.0002" + extension)).find("G")->values)
        << "the ball comes";
    EXPECT_NE(read_image(folder_ / ("shot.0002" + extension)).find("G")->values,
              read_image(folder_ / ("shot.0003" + extension)).find("G")->values)
        << "the light turns";
  }

  TemporaryFolder folder_;
  std::string scene_;
  Playblast playblast_{PLINIAN_PROGRAM};
};

TEST_F(PlayblastTest, NumberedPngsAreWhatRenderMakesAndAreLeftTheSecondTime) {
  make_scene("2");
  start(settings("shot.####.png"));
  EXPECT_TRUE(playblast_.is_running());
  EXPECT_NE(refusal(settings("other.####.png")).find("a playblast is running"), std::string::npos);
  const Playblast::End first = end();
  EXPECT_TRUE(first.succeeded) << first.line;
  EXPECT_EQ(first.line, "playblast: 3 frames, " + (folder_ / "shot.####.png"));
  EXPECT_EQ(playblast_.frames_done(), 3);
  EXPECT_EQ(names(),
            (std::set<std::string>{"shot.plinian", "shot.0001.png", "shot.0002.png", "shot.0003.png"}));
  expect_what_render_makes(".png");

  const auto written = fs::last_write_time(folder_ / "shot.0003.png");
  fs::remove(folder_ / "shot.0002.png");
  start(settings("shot.####.png"));
  const Playblast::End again = end();
  EXPECT_EQ(again.line, "playblast: 3 frames, " + (folder_ / "shot.####.png") + "; 2 were there already");
  EXPECT_TRUE(fs::exists(folder_ / "shot.0002.png"));
  EXPECT_EQ(fs::last_write_time(folder_ / "shot.0003.png"), written);
}

TEST_F(PlayblastTest, ExrsAreWhatRenderMakes) {
  make_scene("2");
  start(settings("shot.exr"));  // without a place for the number
  const Playblast::End ended = end();
  EXPECT_TRUE(ended.succeeded) << ended.line;
  expect_what_render_makes(".exr");
}

TEST_F(PlayblastTest, StoppedInTheMiddleItKeepsWhatIsWholeAndSaysSo) {
  make_scene("65536");  // frame 1 is empty and costs nothing, frame 2 takes minutes
  start(settings("shot.####.png"));
  while (playblast_.frames_done() < 1) {
    ASSERT_TRUE(playblast_.poll().empty());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  playblast_.cancel();
  const Playblast::End ended = end();
  EXPECT_FALSE(ended.succeeded);
  EXPECT_EQ(ended.line, "playblast stopped after 1 of 3 frames");
  EXPECT_FALSE(playblast_.is_running());
  EXPECT_EQ(names(), (std::set<std::string>{"shot.plinian", "shot.0001.png"}));
  EXPECT_NO_THROW(read_image(folder_ / "shot.0001.png"));
}

TEST_F(PlayblastTest, WhatCannotBeIsToldInOneLineBeforeAnythingIsRendered) {
  make_scene("2");
  std::vector<std::string> outputs = {"nowhere/shot.####.png", "nowhere/shot.exr", "shot.jpg"};
  if (Playblast::has_ffmpeg()) outputs.push_back("nowhere/shot.mp4");
  for (const std::string& output : outputs) {
    const std::string line = refusal(settings(output));
    EXPECT_NE(line.find(fs::path(output).stem().string()), std::string::npos) << output << ": " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_FALSE(playblast_.is_running());
  }
  PlayblastSettings backwards = settings("shot.png");
  backwards.first = 4;
  EXPECT_EQ(refusal(backwards), "playblast: frames 4 to 3: the last one comes before the first");
  EXPECT_EQ(names(), std::set<std::string>{"shot.plinian"}) << "nothing is left lying about";
}

TEST_F(PlayblastTest, WhatTheRendererSaysOfASceneIsTold) {
  make_scene("2");
  scene_ = "no scene\n";
  start(settings("shot.####.png"));
  const Playblast::End ended = end();
  EXPECT_FALSE(ended.succeeded);
  EXPECT_NE(ended.line.find("playblast: "), std::string::npos);
  EXPECT_NE(ended.line.find("is not a Plinian scene"), std::string::npos) << ended.line;
  EXPECT_EQ(names(), std::set<std::string>{"shot.plinian"});
}

TEST_F(PlayblastTest, AFilmHasTheColoursOfItsFrames) {
  if (!Playblast::has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  make_scene("2");
  start(settings("shot.mp4"));
  const Playblast::End ended = end();
  ASSERT_TRUE(ended.succeeded) << ended.line;
  EXPECT_EQ(names(), (std::set<std::string>{"shot.plinian", "shot.mp4"}));
  expect_run({"render", "shot.plinian", "--frames", "1-3", "-o", "truth.####.png", "--view", "srgb",
              "--exposure", "1.5"});
  // Taken apart as a player does that takes it for Rec.709, and as one that does not.
  const auto largest_error = [&](const std::string& matrix) {
    const std::string command = "ffmpeg -y -loglevel error -i '" + (folder_ / "shot.mp4") +
                                "' -vf scale=in_color_matrix=" + matrix + ",format=rgb24 '" +
                                (folder_ / "film.%04d.png") + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_FALSE(fs::exists(folder_ / "film.0004.png"));
    double largest = 0.0;
    {  // frame 1 has one colour all over
      const Image film = read_image(folder_ / "film.0001.png");
      const Image truth = read_image(folder_ / "truth.0001.png");
      EXPECT_EQ(film.width, 64) << "even";
      EXPECT_EQ(film.height, 48);
      for (const char* channel : {"R", "G", "B"}) {
        double sum = 0.0;
        for (int y = 0; y < film.height; ++y)
          for (int x = 0; x < film.width; ++x)
            sum += double(film.find(channel)->values[std::size_t(y * film.width + x)]) -
                   double(truth.find(channel)->values[std::size_t(y * truth.width + x)]);
        largest = std::max(largest, std::abs(sum) / double(film.width * film.height));
      }
    }
    return largest;
  };
  const double right = largest_error("bt709"), wrong = largest_error("bt601");
  EXPECT_LT(right, 0.019) << "two steps of 8 bits";
  EXPECT_GT(wrong, 2.0 * right) << "the scene would show it";
}

}  // namespace
}  // namespace plinian::window
