// Sequences: numbered pictures, and only those that are not there already.
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Frames : public Program {
 protected:
  void SetUp() override {
    if (!fs::exists(data_ / "smoke_000001.vdb")) GTEST_SKIP() << data_ << " is not there";
  }
  std::vector<std::string> arguments(std::vector<std::string> more = {}) const {
    more.insert(more.begin(),
                {"render", (data_ / "smoke_00000#.vdb").string(), "--frames", "1-3", "-o", "s.####.exr",
                 "--renderer", "cpu", "--size", "24x24", "--passes", "4", "--set", "map.resolution=32"});
    return more;
  }
  json frames(std::vector<std::string> more = {}) {
    more.push_back("--json");
    const Ended ended = run(arguments(more));
    EXPECT_EQ(ended.code, 0) << ended.err;
    return json::parse(ended.out);
  }
  const fs::path data_ = fs::path(PLINIAN_SOURCE_DIR) / ".." / "shared" / "data";
};

TEST_F(Frames, SaveTheSceneThatTheyAreOf) {
  std::vector<std::string> words = arguments({"--save-scene", "s.plinian"});
  const Ended ended = run(words);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.err.find("the picture is empty: there is no density"), std::string::npos) << ended.err;
  words = {"render", "s.plinian", "--frames", "2-2",      "-o", "t.####.exr", "--renderer",
           "cpu",    "--size",    "24x24",    "--passes", "4",  "--set",      "map.resolution=32"};
  EXPECT_EQ(run(words).code, 0);
  EXPECT_EQ(mean_of(picture("s.0002.exr"), "A"), mean_of(picture("t.0002.exr"), "A"));
}

TEST_F(Frames, AreMadeOnceAndAgainAfterAnEdit) {
  const json first = frames();
  EXPECT_EQ(first["made"], 3);
  EXPECT_EQ(mean_of(picture("s.0001.exr"), "A"), 0.0) << "the first frame is empty";
  EXPECT_GT(mean_of(picture("s.0002.exr"), "A"), 0.01);
  EXPECT_GT(mean_of(picture("s.0003.exr"), "A"), 0.01);
  // Set up once: the camera of every frame is the same.
  EXPECT_EQ(std::get<mat4>(picture("s.0001.exr").metadata.at(attribute::world_to_camera)),
            std::get<mat4>(picture("s.0003.exr").metadata.at(attribute::world_to_camera)));
  EXPECT_EQ(std::get<int>(picture("s.0003.exr").metadata.at(attribute::frame)), 3);
  const auto written = fs::last_write_time(folder_ / "s.0002.exr");
  EXPECT_EQ(frames()["skipped"], 3);
  EXPECT_EQ(fs::last_write_time(folder_ / "s.0002.exr"), written);
  // One that is lost or damaged is made anew, and no other.
  folder_.write("s.0002.exr", "no picture");
  const json mended = frames();
  EXPECT_EQ(mended["made"], 1);
  EXPECT_EQ(mended["frames"][1]["skipped"], false);
  EXPECT_EQ(frames({"--set", "medium.albedo=0.5"})["made"], 3);
  EXPECT_EQ(frames({"--set", "medium.albedo=0.5", "--preset", "high"})["made"], 3);
}

TEST_F(Frames, GoOnWhereCtrlCStoppedThem) {
  RunOptions options;
  options.signal_after_text = "s.0001.exr: cpu";
  options.signal_after_s = 0.02;
  // So many passes that the second frame is not done by then.
  std::vector<std::string> slow = arguments({"--set", "view.shade_samples=64"});
  slow[std::size_t(std::find(slow.begin(), slow.end(), "4") - slow.begin())] = "3000";
  const Ended ended = run(slow, options);
  EXPECT_EQ(ended.code, 130);
  EXPECT_NE(ended.err.find("interrupted: 1 of 3 frames are done"), std::string::npos) << ended.err;
  EXPECT_TRUE(fs::exists(folder_ / "s.0001.exr"));
  EXPECT_FALSE(fs::exists(folder_ / "s.0002.exr"));
  const auto written = fs::last_write_time(folder_ / "s.0001.exr");
  slow[std::size_t(std::find(slow.begin(), slow.end(), "1-3") - slow.begin())] = "1";
  slow.push_back("--json");
  EXPECT_EQ(json::parse(run(slow).out)["skipped"], 1);
  EXPECT_EQ(fs::last_write_time(folder_ / "s.0001.exr"), written);
}

TEST_F(Frames, WithoutARangeTheFirstFrameThatShowsAnythingIsThePicture) {
  const Ended ended = run({"render", (data_ / "smoke_00000#.vdb").string(), "--renderer", "cpu", "--size",
                           "16x16", "--passes", "1", "--set", "map.resolution=32"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(fs::exists(folder_ / "smoke_000002.png")) << ended.err;
  EXPECT_NE(ended.err.find("smoke_00000#.vdb: the picture is of frame 2 (--frames 1-3 makes one of each)"),
            std::string::npos)
      << ended.err;
}

TEST_F(Program, FramesBeyondASequenceAreHeldAndToldOnce) {
  ASSERT_EQ(run({"make", "ash", "-o", "a.1.vdb", "--resolution", "16"}).code, 0);
  const Ended ended = run({"render", "a.#.vdb", "--frames", "1-3", "-o", "a.#.png", "--renderer", "cpu",
                           "--size", "8x8", "--passes", "1", "--set", "map.resolution=16"});
  EXPECT_EQ(ended.code, 1) << "they may only be late: " << ended.err;
  EXPECT_NE(ended.err.find("drawn without a file that is missing or cannot be read: frames 2-3;"),
            std::string::npos)
      << ended.err;
  const std::string line =
      "warning: medium_file: behind the last frame of the sequence, 1, which is held (before, after)\n";
  const std::size_t told = ended.err.find(line);
  ASSERT_NE(told, std::string::npos) << ended.err;
  EXPECT_GT(told, ended.err.find("a.1.png: cpu")) << "not before it is so";
  EXPECT_EQ(ended.err.find("which is held", told + line.size()), std::string::npos) << ended.err;
}

TEST_F(Program, AMissingFrameIsToldOrRefused) {
  ASSERT_EQ(run({"make", "ash", "-o", "a.1.vdb", "--resolution", "16"}).code, 0);
  fs::copy_file(folder_ / "a.1.vdb", folder_ / "a.3.vdb");
  const std::vector<std::string> arguments = {
      "render", "a.#.vdb", "--frames", "2",        "-o", "a.#.png", "--renderer",
      "cpu",    "--size",  "8x8",      "--passes", "1",  "--set",   "map.resolution=16"};
  const std::string drawn_without =
      "error: drawn without a file that is missing or cannot be read: frames 2; --set "
      "medium_file.missing=hold fills such places with the frame before\n";
  // Again where the picture is there already: it is as empty as before.
  for (int i = 0; i < 2; ++i) {
    const Ended blank = run(arguments);
    EXPECT_EQ(blank.code, 1) << blank.err;
    EXPECT_NE(blank.err.find("warning: medium_file: frame 2 is missing"), std::string::npos) << blank.err;
    EXPECT_NE(blank.err.find(drawn_without), std::string::npos) << blank.err;
  }
  const auto with = [&](const char* what) {
    std::vector<std::string> more = arguments;
    more.insert(more.end(), {"--set", what});
    return run(more);
  };
  const Ended refused = with("medium_file.missing=error");
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("a.2.vdb: no such file"), std::string::npos) << refused.err;
  const Ended held = with("medium_file.missing=hold");
  EXPECT_EQ(held.code, 0) << held.err;
  EXPECT_NE(held.err.find("warning: medium_file: frame 2 is missing"), std::string::npos) << held.err;
  EXPECT_EQ(run({"render", "a.#.vdb", "--frames", "3-1"}).err,
            "plinian: error: --frames 3-1: the last frame comes before the first; --frames 1-3\n");
}

// A farm wants the frames that there can be, and to hear of the others.
TEST_F(Program, FramesThatFailAreListedAndTheOthersMade) {
  ASSERT_EQ(run({"make", "ash", "-o", "a.1.vdb", "--resolution", "16"}).code, 0);
  for (const char* copy : {"a.3.vdb", "a.7.vdb"}) fs::copy_file(folder_ / "a.1.vdb", folder_ / copy);
  folder_.write("a.6.vdb", "broken");
  const auto frames = [&](const std::string& missing) {
    return run({"render", "a.#.vdb", "--frames", "1-7", "-o", missing + ".#.png", "--renderer", "cpu",
                "--size", "8x8", "--passes", "2", "--set", "map.resolution=16", "--set",
                "medium_file.missing=" + missing, "--json"});
  };
  const Ended strict = frames("error");
  EXPECT_EQ(strict.code, 1) << strict.err;
  const json failed = json::parse(strict.out);
  EXPECT_EQ(failed["failed"], json({2, 4, 5, 6}));
  EXPECT_EQ(failed["incomplete"], json::array());
  EXPECT_EQ(failed["made"], 3);
  EXPECT_NE(failed["frames"][1]["error"].get<std::string>().find("a.2.vdb: no such file"), std::string::npos);
  EXPECT_NE(strict.err.find("plinian: error: frame 2: "), std::string::npos) << strict.err;
  EXPECT_NE(strict.err.find("plinian: error: no picture of frames 2, 4-6\n"), std::string::npos)
      << strict.err;
  EXPECT_FALSE(fs::exists(folder_ / "error.2.png"));
  EXPECT_TRUE(fs::exists(folder_ / "error.7.png"));

  const Ended blank = frames("blank");
  EXPECT_EQ(blank.code, 1) << blank.err;
  const json holes = json::parse(blank.out);
  EXPECT_EQ(holes["incomplete"], json({2, 4, 5, 6}));
  EXPECT_EQ(holes["failed"], json::array());
  EXPECT_EQ(holes["made"], 7);
  EXPECT_EQ(holes["frames"][1]["missing"], json({"medium_file: frame 2 is missing"}));
  EXPECT_FALSE(holes["frames"][2].contains("missing"));
  EXPECT_EQ(holes["frames"][0]["passes"], 2);
  EXPECT_EQ(holes["frames"][1]["passes"], 0) << "nothing was marched";
}

TEST_F(Program, FramesAreGivenInRangesWithStepsAndCommas) {
  const auto frames = [&](const std::string& which) {
    const Ended ended = run({"render", "sphere", "--frames", which, "-o", "b.#.png", "--renderer", "cpu",
                             "--size", "8x8", "--passes", "1", "--json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    std::vector<int> made;
    const json report = json::parse(ended.out);
    for (const json& frame : report["frames"]) made.push_back(frame["frame"]);
    return made;
  };
  EXPECT_EQ(frames("7-9, 1,3"), (std::vector{1, 3, 7, 8, 9}));
  EXPECT_EQ(frames("1-8x3"), (std::vector{1, 4, 7}));
  EXPECT_EQ(frames("-2--1"), (std::vector{-2, -1}));
  for (const char* wrong : {"1,", "1-8x0", "1-8x", "a", "1 to 3", "1-3-5"})
    EXPECT_NE(run({"render", "sphere", "--frames", wrong, "-o", "b.#.png"}).code, 0) << wrong;
}

TEST_F(Program, FramesOfOneFileOfASequenceAreQuestioned) {
  ASSERT_EQ(run({"make", "ash", "-o", "a_001.vdb", "--resolution", "16"}).code, 0);
  const auto frames = [&] {
    return run({"render", "a_001.vdb", "--frames", "1-2", "-o", "b.#.png", "--renderer", "cpu", "--size",
                "8x8", "--passes", "1", "--set", "map.resolution=16"})
        .err;
  };
  EXPECT_EQ(frames().find("is one file"), std::string::npos) << "there is no sequence";
  fs::copy_file(folder_ / "a_001.vdb", folder_ / "a_002.vdb");
  const std::string told = frames();
  EXPECT_NE(told.find("warning: a_001.vdb is one file, which every frame shows; the sequence is a_###.vdb\n"),
            std::string::npos)
      << told;
}

// What arrives late or breaks would else move the camera, and have all of them made again.
TEST_F(Program, FramesThatAreDoneStayAsTheyAreWhenOthersArriveOrBreak) {
  const auto make = [&](const char* kind, const char* file) {
    ASSERT_EQ(run({"make", kind, "-o", file, "--resolution", "16"}).code, 0);
  };
  make("ash", "a.1.vdb");
  make("ash", "a.2.vdb");
  std::string told;
  const auto frames = [&](const std::string& output, int code = 0) {
    const Ended ended =
        run({"render", "a.#.vdb", "--frames", "1-3", "-o", output, "--renderer", "cpu", "--size", "8x8",
             "--passes", "1", "--set", "map.resolution=16", "--set", "medium_file.after=blank", "--json"});
    EXPECT_EQ(ended.code, code) << ended.err;
    told = ended.err;
    return json::parse(ended.out);
  };
  const auto camera = [&](const std::string& file) {
    return std::get<mat4>(picture(file).metadata.at(attribute::world_to_camera));
  };
  EXPECT_EQ(frames("k.#.exr")["made"], 3);
  const mat4 before = camera("k.1.exr");
  make("sandstorm", "a.3.vdb");
  const json late = frames("k.#.exr");
  EXPECT_EQ(late["made"], 1);
  EXPECT_EQ(late["skipped"], 2);
  EXPECT_EQ(camera("k.3.exr"), before);
  EXPECT_NE(told.find("camera, density scale (medium "), std::string::npos) << told;
  frames("new.#.exr");
  EXPECT_NE(camera("new.1.exr"), before) << "without pictures it is placed by what there is";
  // One that breaks says nothing, and no other is made again.
  folder_.write("a.2.vdb", "broken");
  const json broken = frames("k.#.exr", 1);
  EXPECT_EQ(broken["incomplete"], json({2}));
  EXPECT_EQ(broken["made"], 1);
  EXPECT_EQ(broken["skipped"], 2);
  EXPECT_EQ(camera("k.2.exr"), before);
}

}  // namespace
}  // namespace plinian
