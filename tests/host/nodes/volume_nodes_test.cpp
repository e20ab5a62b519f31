// volumeNoise and volumeRead: what they hand on, what they share, and what they compute again.
#include <fstream>

#include "core/image/image_io.h"
#include "core/media/procedural.h"
#include "tests/host/nodes/node_session.h"

namespace plinian {
namespace {

TEST(VolumeNoiseNode, MakesTheProceduralMediumOfItsAttributes) {
  NodeSession s;
  s.run(
      "createNode volumeNoise -name n\nsetAttr n.kind sandstorm\nsetAttr n.resolution 16\nsetAttr n.seed 4");
  const auto expected = make_procedural({.kind = "sandstorm", .resolution = 16, .seed = 4});
  ASSERT_TRUE(s.volume("n.volume"));
  EXPECT_EQ(s.volume("n.volume")->density, expected->density);
  EXPECT_EQ(s.computes("volumeNoise"), 1u);
  s.run("setAttr n.kind ash\nsetAttr n.ash.veils 2");
  const auto veiled =
      make_procedural({.kind = "ash", .resolution = 16, .seed = 4, .shape = {{"veils", 2.0f}}});
  EXPECT_EQ(s.volume("n.volume")->density, veiled->density);
}

struct Sequence : testing::Test {
  void SetUp() override {
    for (const int frame : {1, 2, 4})
      write_block(folder / ("s.000" + std::to_string(frame) + ".vdb"), float(frame));
    s.run("createNode volumeRead -name r\nconnectAttr time1.out r.time\nsetAttr r.file " +
          folder / "s.####.vdb");
  }
  // The density that a time shows; 0 where nothing is shown, -1 where the node failed.
  float at(double time) {
    s.run("currentTime " + std::to_string(time));
    const auto volume = s.volume("r.volume");
    return volume ? volume->density_max : -1.0f;
  }
  TemporaryFolder folder;
  NodeSession s;
};

TEST_F(Sequence, ShowsTheFrameOfTheTimeAndHoldsItsEnds) {
  EXPECT_EQ(at(1), 1.0f);
  EXPECT_EQ(at(2), 2.0f);
  EXPECT_EQ(at(4), 4.0f);
  EXPECT_EQ(s.run("getAttr r.badge"), "\"\"");
  EXPECT_EQ(at(-7), 1.0f);
  EXPECT_EQ(s.run("getAttr r.badge"),
            "\"before the first frame of the sequence, 1, which is held (before, after)\"");
  EXPECT_EQ(at(99), 4.0f);
  EXPECT_EQ(s.run("getAttr r.frame"), "4");
  EXPECT_EQ(s.run("getAttr r.badge"),
            "\"behind the last frame of the sequence, 4, which is held (before, after)\"");
  s.run("setAttr r.after blank");
  EXPECT_EQ(s.run("getAttr r.badge"), "\"\"");
}

TEST_F(Sequence, AMissingFrameIsBlankWithABadgeOrHeldOrAnError) {
  EXPECT_EQ(at(3), 0.0f);
  EXPECT_EQ(s.run("getAttr r.badge"), "\"frame 3 is missing\"");
  EXPECT_EQ(s.run("getAttr r.frame_missing"), "true");
  EXPECT_EQ(s.run("currentTime 2\ngetAttr r.badge\ngetAttr r.frame_missing"), "2\n\"\"\nfalse");
  EXPECT_EQ(s.run("currentTime 99\ngetAttr r.frame_missing"), "99\ntrue") << "it may only be late";
  s.run("setAttr r.automatic_range off\nsetAttr r.end 4");
  EXPECT_EQ(s.run("getAttr r.frame_missing"), "false") << "so long it is, and is held then";
  s.run("undo 2");
  s.run("setAttr r.missing hold");
  EXPECT_EQ(at(3), 2.0f);
  EXPECT_EQ(s.run("getAttr r.badge"), "\"frame 3 is missing\"");
  s.run("setAttr r.missing error");
  EXPECT_EQ(at(3), -1.0f);
  EXPECT_EQ(s.refusal("evaluate r.volume"), "r.volume: " + folder / "s.0003.vdb" + ": no such file");
}

TEST_F(Sequence, AHalfWrittenFrameIsAMissingOneUntilItIsWhole) {
  std::ifstream whole(folder / "s.0002.vdb", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  folder.write("s.0003.vdb", bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(at(3), 0.0f);
  EXPECT_TRUE(s.run("getAttr r.badge").starts_with("\"frame 3 cannot be read: ")) << s.run("getAttr r.badge");
  s.run("setAttr r.missing hold");
  EXPECT_EQ(at(3), 2.0f);
  s.run("setAttr r.missing error");
  EXPECT_EQ(at(3), -1.0f);
  folder.write("s.0003.vdb", bytes);
  s.run("reload");
  EXPECT_EQ(at(3), 2.0f);
  EXPECT_EQ(s.run("getAttr r.badge"), "\"\"");
}

TEST_F(Sequence, IsRetimedLoopedAndDrivenByAKeyedFrame) {
  s.run("setAttr r.after loop\nsetAttr r.automatic_range false\nsetAttr r.end 2");
  EXPECT_EQ(at(3), 1.0f);
  EXPECT_EQ(at(4), 2.0f);
  s.run("setAttr r.speed -1\nsetAttr r.after hold");
  EXPECT_EQ(at(1), 2.0f);
  EXPECT_EQ(at(2), 1.0f);
  s.run(
      "setKeyframe r.source_frame -time 1 -value 2 -interpolation stepped\n"
      "setKeyframe r.source_frame -time 2 -value 1\nsetAttr r.use_source_frame true");
  EXPECT_EQ(at(1), 2.0f);
  EXPECT_EQ(at(2), 1.0f);
}

TEST_F(Sequence, AFrameThatIsKeyedInVainIsTold) {
  const std::string why =
      "r.source_frame does nothing while r.use_source_frame is false: setAttr r.use_source_frame true";
  s.run("setKeyframe r.source_frame -time 1 -value 2");
  EXPECT_EQ(s.warnings, std::vector<std::string>{why});
  s.warnings.clear();
  s.run("cutKey r.source_frame\nconnectAttr time1.out r.source_frame");
  EXPECT_EQ(s.warnings, std::vector<std::string>{why});
  s.warnings.clear();
  s.run(
      "disconnectAttr r.source_frame\nsetAttr r.use_source_frame true\nsetKeyframe r.source_frame -value 2");
  EXPECT_EQ(s.warnings, std::vector<std::string>());
}

TEST_F(Sequence, GoingBackReadsNothingAgain) {
  for (const double time : {1.0, 2.0, 4.0}) at(time);
  EXPECT_EQ(s.computes("volumeRead"), 3u);
  for (const double time : {2.0, 1.0, 4.0}) at(time);
  EXPECT_EQ(s.computes("volumeRead"), 3u);
  s.run("setAttr r.after hold\nsetAttr r.grid \"\"");
  at(4);
  EXPECT_EQ(s.computes("volumeRead"), 3u) << "equal values run nothing";
}

TEST_F(Sequence, WhatIsAdvisedIsAnAttributeOfTheNode) {
  s.run("setAttr r.file " + folder / "s.0001.vdb" + "\nsetAttr r.time_limit 0.000001");
  const std::string why = s.refusal("evaluate r.volume");
  EXPECT_NE(why.find("attribute time_limit"), std::string::npos) << why;
  EXPECT_EQ(why.find("--"), std::string::npos) << why;
}

TEST_F(Sequence, WithoutAnyFileItSaysSo) {
  s.run("setAttr r.file " + folder / "other.#.vdb");
  EXPECT_EQ(s.refusal("evaluate r.volume"),
            "r.volume: " + folder / "other.#.vdb" + ": no file of that sequence is there");
  s.run("setAttr r.file \"\"");
  EXPECT_EQ(s.refusal("evaluate r.volume"), "r.volume: no file is set");
}

TEST(VolumeReadNode, NodesThatReadTheSameVoxelsShareThem) {
  TemporaryFolder folder;
  write_block(folder / "a.vdb", 2.0f);
  std::filesystem::copy_file(folder / "a.vdb", folder / "b.vdb");
  NodeSession s;
  for (const char* node : {"a", "b", "c"})
    s.run(std::string("createNode volumeRead -name ") + node + "\nsetAttr " + node + ".file " +
          folder / (node == std::string("b") ? "b.vdb" : "a.vdb"));
  s.run("setAttr c.before loop");  // another node in every way but its voxels
  const auto a = s.volume("a.volume");
  ASSERT_TRUE(a);
  EXPECT_EQ(a.get(), s.volume("b.volume").get());
  EXPECT_EQ(a.get(), s.volume("c.volume").get());
}

TEST(VolumeReadNode, AChangedFileIsNoticedAndReadAgainWhenAskedTo) {
  TemporaryFolder folder;
  write_block(folder / "a.vdb", 2.0f);
  NodeSession s;
  s.run("createNode volumeRead -name r\nsetAttr r.file " + folder / "a.vdb");
  EXPECT_EQ(s.volume("r.volume")->density_max, 2.0f);
  EXPECT_EQ(s.run("reload -check"), "");
  write_block(folder / "a.vdb", 3.0f);
  EXPECT_EQ(s.volume("r.volume")->density_max, 2.0f);
  EXPECT_EQ(s.run("reload -check"), folder / "a.vdb");
  EXPECT_EQ(s.run("reload"), folder / "a.vdb");
  EXPECT_EQ(s.volume("r.volume")->density_max, 3.0f);
  EXPECT_EQ(s.run("reload -check"), "");
}

TEST(VolumeReadNode, PathsAreRelativeToTheSceneAndMayHoldVariables) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "shots");
  write_block(folder / "a.vdb", 2.0f);
  NodeSession s;
  s.run("createNode volumeRead -name r\nsetAttr r.file ../a.vdb");
  EXPECT_EQ(s.volume("r.volume"), nullptr);
  s.run("save " + folder / "shots/one.plinian");
  ASSERT_TRUE(s.volume("r.volume"));
  EXPECT_EQ(s.volume("r.volume")->density_max, 2.0f);
  EXPECT_EQ(s.run("getAttr r.file"), "\"../a.vdb\"") << "kept as typed";
  ::setenv("PLINIAN_TEST_FOLDER", folder.path().c_str(), 1);
  s.run("setAttr r.file \"${PLINIAN_TEST_FOLDER}/a.vdb\"");
  EXPECT_TRUE(s.volume("r.volume"));
}

TEST(VolumeReadNode, TurnsTheFilesSpaceAsItSaysUnlessTold) {
  TemporaryFolder folder;
  write_block(folder / "a.vdb", 2.0f, {.up_axis = 'z', .file_unit = 0.01});
  NodeSession s;
  s.run("createNode volumeRead -name r\nsetAttr r.file " + folder / "a.vdb");
  EXPECT_EQ(s.run("getAttr r.space"), "0.01 0 0 0 0 0 -0.01 0 0 0.01 0 0 0 0 0 1");
  s.run("setAttr r.up_axis y\nsetAttr r.file_unit 2");
  EXPECT_EQ(s.run("getAttr r.space"), "2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1");
}

TEST(ReferenceImageNode, ReadsThePictureOfTheFrame) {
  TemporaryFolder folder;
  for (const int frame : {1, 2})
    write_image(folder / ("plate.0" + std::to_string(frame) + ".exr"), make_image(8 * frame, 4, vec3(0.5f)));
  NodeSession s;
  s.run("createNode referenceImage -name p\nconnectAttr time1.out p.time\nsetAttr p.file " +
        folder / "plate.##.exr");
  const auto width = [&](int frame) {
    s.run("currentTime " + std::to_string(frame));
    const graph::ResultPtr result = s.evaluator().evaluate(s.graph().plug("p.image"));
    return result->error
               ? 0
               : static_cast<const Image*>(std::get<graph::DataPtr>(result->value)->object.get())->width;
  };
  EXPECT_EQ(width(1), 8);
  EXPECT_EQ(width(2), 16);
  EXPECT_EQ(width(3), 0);
  EXPECT_NE(s.refusal("evaluate p.image").find("plate.03.exr"), std::string::npos);
}

}  // namespace
}  // namespace plinian
