// Scenes and scripts on the command line.
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<float> pixels_of(const Image& image) {
  std::vector<float> all;
  for (const Channel& channel : image.channels)
    all.insert(all.end(), channel.values.begin(), channel.values.end());
  return all;
}

TEST_F(Program, ASavedSceneGivesThePictureThatItsInputGave) {
  ASSERT_EQ(run({"make", "ash", "-o", "ash.vdb", "--resolution", "24"}).code, 0);
  for (const std::string input : {"ash.vdb", "explosion"}) {
    std::vector<std::string> arguments = {input,      "-o",    "a.exr", "--save-scene",  "a.plinian",
                                          "--pixels", "float", "--set", "key.exposure=2"};
    if (input == "explosion") arguments.insert(arguments.end(), {"--resolution", "24"});
    render(arguments);
    const Ended again = run(
        {"render", "a.plinian", "-o", "b.exr", "--pixels", "float", "--renderer", "cpu", "--samples", "1"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(pixels_of(picture("a.exr")), pixels_of(picture("b.exr"))) << input;
    EXPECT_EQ(text_fact(picture("a.exr"), attribute::scene_hash),
              text_fact(picture("b.exr"), attribute::scene_hash));
  }
}

TEST_F(Program, ASceneMovesWithTheVolumesThatLieBesideIt) {
  fs::create_directories(folder_ / "shot/vdb");
  fs::create_directories(folder_ / "elsewhere");
  ASSERT_EQ(run({"make", "ash", "-o", "shot/vdb/ash.vdb", "--resolution", "16"}).code, 0);
  render({"shot/vdb/ash.vdb", "-o", "a.exr", "--save-scene", "shot/a.plinian"});
  render({"shot/vdb/ash.vdb", "-o", "b.exr", "--save-scene", "elsewhere/b.plinian"});
  const auto holds = [&](const std::string& name, const std::string& text) {
    std::ifstream file(folder_ / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {}).find(text) != std::string::npos;
  };
  EXPECT_TRUE(holds("shot/a.plinian", "  .file \"vdb/ash.vdb\"\n"));
  EXPECT_TRUE(holds("elsewhere/b.plinian", "  .file \"" + folder_ / "shot/vdb/ash.vdb" + "\"\n"));
  fs::rename(folder_ / "shot", folder_ / "moved");
  const Ended ended =
      run({"render", "moved/a.plinian", "-o", "c.exr", "--renderer", "cpu", "--samples", "1"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(pixels_of(picture("a.exr")), pixels_of(picture("c.exr")));
}

TEST_F(Program, ADamagedSceneNamesTheOneBeforeItWhereItIsThere) {
  folder_.write("a.plinian", "plinian scene 1.0\nnode time time1\n");
  const std::string cut = "plinian: error: a.plinian: ends too early, after line 2: the file was cut off";
  EXPECT_EQ(run({"render", "a.plinian", "-o", "x.png"}).err, cut + "\n");
  folder_.write("a.plinian.bak", "plinian scene 1.0\nend\n");
  EXPECT_EQ(run({"render", "a.plinian", "-o", "x.png"}).err,
            cut + " (a.plinian.bak may hold the last whole scene)\n");
}

TEST_F(Program, AnAzimuthMovesTheCameraOfASceneAndOfVariants) {
  render({"ash", "--resolution", "24", "-o", "a.exr", "--save-scene", "a.plinian"});
  const auto eye = [&](const std::string& name) {
    return vec3(glm::inverse(std::get<mat4>(picture(name).metadata.at(attribute::world_to_camera)))[3]);
  };
  const auto azimuth = [](vec3 eye) { return glm::degrees(std::atan2(eye.x, eye.z)); };
  EXPECT_NEAR(azimuth(eye("a.exr")), 30.0, 2.0);
  EXPECT_EQ(run({"render", "a.plinian", "-o", "b.exr", "--renderer", "cpu", "--samples", "1", "--set",
                 "camera.azimuth=120", "--set", "camera.elevation=40"})
                .code,
            0);
  EXPECT_NEAR(azimuth(eye("b.exr")), 120.0, 2.0);
  EXPECT_GT(eye("b.exr").y, eye("a.exr").y + 1.0f);
  const Ended sheet = run({"render", "a.plinian", "--renderer", "cpu", "--samples", "1", "--size", "24x24",
                           "--vary", "camera.azimuth=0,90", "--sheet", "s.png", "--json"});
  ASSERT_EQ(sheet.code, 0) << sheet.err;
  const json variants = json::parse(sheet.out)["variants"];
  EXPECT_NE(variants[0]["scene_hash"], variants[1]["scene_hash"]);
  const Ended wrong = run({"render", "a.plinian", "-o", "b.exr", "-q", "--set", "camera.azimuth=left"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_TRUE(wrong.err.starts_with("plinian: error: --set camera.azimuth: ")) << wrong.err;
}

TEST_F(Program, ALookIsPutOnAsAWholeOrRefused) {
  render({"sphere", "-o", "plain.exr"});
  render({"sphere", "-o", "ash.exr", "--set", "medium.look=ash"});
  EXPECT_NE(text_fact(picture("plain.exr"), attribute::scene_hash),
            text_fact(picture("ash.exr"), attribute::scene_hash));
  const Ended refused = run({"render", "sphere", "-o", "x.exr", "--set", "medium.look=ahs"});
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("no such look"), std::string::npos) << refused.err;
}

TEST_F(Program, SetReachesAnyAttributeOfASceneAndItsQualitySets) {
  render({"sphere", "-o", "a.exr", "--save-scene", "a.plinian"});
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "a.plinian", "-o", "b.exr", "--renderer", "cpu", "--samples", "1"});
    const Ended ended = run(more);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return picture("b.exr");
  };
  EXPECT_NEAR(mean_of(with({"--set", "key.exposure=1.75"}), "key.G") / mean_of(picture("a.exr"), "key.G"),
              2.0, 0.01);
  EXPECT_EQ(mean_of(with({"--set", "medium_shape.visibility=false"}), "A"), 0.0);
  EXPECT_EQ(with({"--set", "settings.width=20"}).width, 20);
  EXPECT_EQ(with({"--size", "24x16"}).width, 24);
  EXPECT_EQ(text_fact(with({"--preset", "high"}), attribute::preset), "high");
  EXPECT_NE(mean_of(with({"--set", "map.coefficients=2"}), "key.G"), mean_of(picture("a.exr"), "key.G"));
  // The same on what is no scene yet.
  render({"sphere", "-o", "c.exr", "--set", "medium_place.translate=0,100,0"});
  EXPECT_EQ(mean_of(picture("c.exr"), "A"), 0.0) << "moved out of the picture";
  for (const auto& [set, says] :
       {std::pair("nobody.x=1", "--set nobody.x: nothing is called 'nobody'"),
        std::pair("key.exposre=1", "(did you mean 'exposure'?)"),
        std::pair("key.exposure=bright", "--set key.exposure: key.exposure expects a number"),
        std::pair("map.treshold=1", "(did you mean 'map.threshold'?)")}) {
    const Ended ended = run({"render", "a.plinian", "-o", "b.exr", "--quiet", "--set", set});
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.error_lines(), 1) << ended.err;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
  }
}

TEST_F(Program, RunsAScriptAndTellsTheLineThatFails) {
  folder_.write(
      "ball.pln",
      "# a ball under a sun\ncreateNode atfmVolume -name ball\nsetAttr ball.draw sphere\n"
      "createNode directionalLight -name sun\nsetAttr sun.rotate -40 30 0\nsetAttr sun.intensity 12\n"
      "getAttr sun.intensity\nsave ball.plinian\n");
  const Ended ended = run({"run", "ball.pln", "--quiet"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(ended.out.starts_with("ball\nsun\n12\n")) << ended.out;
  render({"ball.plinian", "-o", "ball.exr"});
  EXPECT_GT(mean_of(picture("ball.exr"), "sun.G"), 0.01);

  folder_.write("wrong.pln", "ls\n\nsetAttr ball.draw cube\n");
  const Ended wrong = run({"run", "wrong.pln", "ball.plinian"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_EQ(wrong.error_lines(), 1);
  EXPECT_EQ(wrong.err,
            "plinian: error: wrong.pln:3: ball.draw 'cube' is none of volume (0), box (1), sphere (2)\n");
  EXPECT_EQ(wrong.out, "time1\nball\nsun\n");
  EXPECT_NE(run({"run", "nowhere.pln"}).err.find("nowhere.pln"), std::string::npos);
}

TEST_F(Program, AScriptThatBringsAVolumeAndRendersShowsIt) {
  ASSERT_EQ(run({"make", "ash", "-o", "ash.vdb", "--resolution", "24"}).code, 0);
  folder_.write(
      "first.pln",
      "import ash.vdb\nrender a.exr -renderer cpu -passes 1 -size 40x30\nsetAttr settings.width 20\n"
      "render b.exr -renderer cpu -passes 1\n");
  const Ended ended = run({"run", "first.pln"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err.find("warning"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("the scene has no lights: a key, a rim and a sky stand in"), std::string::npos);
  EXPECT_EQ(picture("a.exr").width, 40);
  EXPECT_EQ(picture("a.exr").height, 30);
  EXPECT_EQ(picture("b.exr").width, 20);
  EXPECT_GT(mean_of(picture("a.exr"), "key.G"), 0.01);
  // What stands in is told once.
  folder_.write("again.pln",
                "createNode atfmVolume -name ball\nsetAttr ball.draw sphere\nrender c.exr -renderer cpu "
                "-passes 1 -size 8x8\n"
                "render d.exr -renderer cpu -passes 1 -size 8x8\n");
  const Ended again = run({"run", "again.pln"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_GT(mean_of(picture("d.exr"), "A"), 0.1);
  const std::size_t told = again.err.find("the scene has no lights");
  ASSERT_NE(told, std::string::npos);
  EXPECT_EQ(again.err.find("the scene has no lights", told + 1), std::string::npos) << again.err;
  folder_.write("wrong.pln", "import ash.vdb\nrender a.exr -size 40\n");
  const Ended wrong = run({"run", "wrong.pln", "--quiet"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_NE(wrong.err.find("wrong.pln:2: render: -size 40: expected WIDTHxHEIGHT"), std::string::npos)
      << wrong.err;
}

TEST_F(Program, WithoutThePluginASceneOpensSaysSoAndIsKeptByteForByte) {
  render({"sphere", "-o", "a.exr", "--save-scene", "a.plinian"});
  folder_.write("copy.pln", "save b.plinian\n");
  const RunOptions without{.environment = {{"PLINIAN_PLUGINS", "/nowhere"}}};
  const Ended ended = run({"run", "copy.pln", "a.plinian"}, without);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.err.find("atfm"), std::string::npos) << ended.err;
  const auto bytes = [&](const std::string& name) {
    std::ifstream file(folder_ / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_NE(bytes("a.plinian"), "");
  EXPECT_EQ(bytes("a.plinian"), bytes("b.plinian"));
  // A picture is of the whole scene, or of what there is where that is asked for.
  const std::string says =
      "1 node of the type 'atfmVolume' needs the plug-in 'atfm'; there is no plug-in 'atfm' in ";
  const Ended refused = run({"render", "a.plinian", "-o", "n.png"}, without);
  EXPECT_EQ(refused.code, 1);
  EXPECT_EQ(refused.error_lines(), 1) << refused.err;
  EXPECT_TRUE(refused.err.starts_with("plinian: error: a.plinian: " + says)) << refused.err;
  EXPECT_NE(refused.err.find("--skip-unknown"), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists(folder_ / "n.png"));
  const Ended skipped =
      run({"render", "a.plinian", "-o", "n.png", "--skip-unknown", "--renderer", "cpu"}, without);
  EXPECT_EQ(skipped.code, 0) << skipped.err;
  EXPECT_NE(skipped.err.find("it needs the plug-in atfm"), std::string::npos) << skipped.err;
  EXPECT_TRUE(fs::exists(folder_ / "n.png"));
  folder_.write("n.pln", "render n.png -renderer cpu\n");
  const Ended script = run({"run", "n.pln", "a.plinian", "--quiet"}, without);
  EXPECT_EQ(script.code, 1);
  EXPECT_NE(script.err.find("n.pln:1: render: 1 node of the type 'atfmVolume'"), std::string::npos)
      << script.err;
  folder_.write("n.pln", "render n.png -renderer cpu -skipUnknown\n");
  EXPECT_EQ(run({"run", "n.pln", "a.plinian", "--quiet"}, without).code, 0);
  // What needs the plug-in to be made fails in one line.
  const Ended bare = run({"render", "sphere", "-o", "b.png"}, without);
  EXPECT_EQ(bare.code, 1);
  EXPECT_EQ(bare.error_lines(), 1) << bare.err;
  EXPECT_NE(bare.err.find("there is no plug-in 'atfm'"), std::string::npos) << bare.err;
}

TEST_F(Program, SwitchingTheQualitySetsBackAndForthGivesTheSamePictureToTheBit) {
  render({"ash", "--resolution", "24", "-o", "start.png", "--save-scene", "a.plinian"});
  folder_.write("switch.pln",
                "render a.exr -renderer cpu -passes 2 -pixels float\nquality high\n"
                "render b.exr -renderer cpu -passes 2 -pixels float\nquality fast\n"
                "render c.exr -renderer cpu -passes 2 -pixels float\n");
  const Ended ended = run({"run", "switch.pln", "a.plinian", "--quiet"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "a.exr\nhigh\nb.exr\nfast\nc.exr\n");
  EXPECT_EQ(pixels_of(picture("a.exr")), pixels_of(picture("c.exr")));
  EXPECT_NE(pixels_of(picture("a.exr")), pixels_of(picture("b.exr")));
  folder_.write("bad.pln", "render a.jpeg2000");
  EXPECT_NE(run({"run", "bad.pln"}).err.find("bad.pln:1: render: "), std::string::npos);
  folder_.write("none.pln", "render a.exr -passes 0");
  EXPECT_NE(run({"run", "none.pln"}).err.find("-passes expects an integer from 1 to 65536"),
            std::string::npos);
}

TEST_F(Program, ListsPluginsTypesAndCommands) {
  const json report = json::parse(run({"plugins", "--json"}).out);
  bool found = false;
  for (const json& plugin : report["plugins"])
    found = found || (plugin["name"] == "atfm" && plugin["state"] == "loaded" &&
                      plugin["registers"] == json({"node:atfmVolume"}));
  EXPECT_TRUE(found) << report.dump(1);
  const std::string types = run({"plugins", "--types"}).out;
  for (const char* type : {"atfmVolume", "transform", "volumeRead", "medium", "camera", "renderSettings"})
    EXPECT_NE(types.find(type), std::string::npos) << type;
  const std::string medium = run({"plugins", "--type", "medium"}).out;
  EXPECT_NE(medium.find("albedo"), std::string::npos);
  EXPECT_NE(run({"plugins", "--commands"}).out.find("setAttr"), std::string::npos);
  EXPECT_NE(run({"plugins", "--command", "render"}).out.find("renderer"), std::string::npos);
  EXPECT_NE(run({"plugins", "--type", "mediun"}).err.find("(did you mean 'medium'?)"), std::string::npos);
}

TEST_F(Program, TellsAllOfAnAttributeForPeopleAndForScripts) {
  const std::string text = run({"plugins", "--type", "medium"}).out;
  EXPECT_NE(text.find("colour (0.8 0.8 0.8), from 0 to 1, group Scattering, shown when "
                      "coefficients=albedo_extinction\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("slider from -8 to 8, group Emission"), std::string::npos) << text;
  const json type = json::parse(run({"plugins", "--type", "medium", "--json"}).out);
  EXPECT_EQ(type["name"], "medium");
  bool found = false;
  for (const json& attribute : type["attributes"]) {
    EXPECT_NE(attribute["path"], "look_hash") << "it is hidden";
    if (attribute["path"] != "extinction") continue;
    found = true;
    EXPECT_EQ(attribute["type"], "colour");
    EXPECT_EQ(attribute["default"], "1 1 1");
    EXPECT_EQ(attribute["minimum"], 0.0);
    EXPECT_EQ(attribute["soft_maximum"], 10.0);
    EXPECT_EQ(attribute["group"], "Scattering");
    EXPECT_FALSE(attribute["unit"].get<std::string>().empty());
    EXPECT_FALSE(attribute.contains("maximum"));
  }
  EXPECT_TRUE(found);
  const json types = json::parse(run({"plugins", "--types", "--json"}).out);
  EXPECT_GT(types["types"].size(), 10u);
  const json command = json::parse(run({"plugins", "--command", "setKeyframe", "--json"}).out);
  EXPECT_EQ(command["parameters"][0]["name"], "plugs");
  EXPECT_TRUE(command["parameters"][0]["many"]);
  EXPECT_GT(json::parse(run({"plugins", "--commands", "--json"}).out)["commands"].size(), 20u);
}

TEST_F(Program, WhatNeedsAMissingNodeIsLeftOutOfThePictureAndToldOf) {
  folder_.write("a.plinian",
                "plinian scene 1.0\nnode cloudMaker maker\nnode atfmVolume ball\n  .draw sphere\n"
                "node atfmVolume fed\n  .volume <- maker.out\nend\n");
  const std::vector<std::string> arguments = {"render", "a.plinian", "-o",    "a.exr",    "--renderer",
                                              "cpu",    "--size",    "24x24", "--passes", "1"};
  EXPECT_EQ(run(arguments).code, 1);
  std::vector<std::string> skipping = arguments;
  skipping.push_back("--skip-unknown");
  const Ended ended = run(skipping);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.err.find("fed is left out: it needs maker, whose type 'cloudMaker' is not known here"),
            std::string::npos)
      << ended.err;
}

TEST_F(Program, WhatCannotBeSetForOnePictureSaysWhyAndWhatToDo) {
  folder_.write(
      "make.pln",
      "createNode atfmVolume -name a\nsetAttr a.draw sphere\ncreateNode medium -name m\n"
      "connectAttr m.out a.medium\ncreateNode directionalLight -name sun\n"
      "setKeyframe sun.rotate.y -value 3 -time 1\ncreateNode time -name other\n"
      "connectAttr other.rate sun.intensity\ncreateNode renderSettings -name r\n"
      "addAttr sun limit -default 0.1\nconnectAttr sun.limit r.fast.map.threshold\nsave a.plinian\n");
  ASSERT_EQ(run({"run", "make.pln"}).code, 0);
  const auto refusal = [&](const std::string& set) {
    const Ended ended = run({"render", "a.plinian", "-o", "a.exr", "--renderer", "cpu", "--set", set});
    EXPECT_EQ(ended.code, 1);
    return ended.err;
  };
  EXPECT_NE(refusal("sun.rotate.y=40")
                .find("--set sun.rotate.y: sun.rotate.y is keyed by sun_rotate_y, which would win: a script "
                      "with 'cutKey sun.rotate.y' and save"),
            std::string::npos);
  EXPECT_NE(
      refusal("sun.intensity=2")
          .find("is driven by other.rate, which would win: a script with 'disconnectAttr sun.intensity'"),
      std::string::npos);
  EXPECT_NE(refusal("map.threshold=0.5").find("is driven by sun.limit"), std::string::npos);
  EXPECT_NE(refusal("camera.azimuth=40").find("--set camera.azimuth: the scene has no camera: "),
            std::string::npos);
  EXPECT_NE(refusal("camera.focal_length=40").find("the scene has no camera"), std::string::npos);
}

TEST_F(Program, TellsOfTypesAndCommandsOfPluginsThatAreFoundButNotLoaded) {
  RunOptions options;
  options.environment = {{"PLINIAN_PLUGIN_PATH", PLINIAN_TEST_PLUGINS},
                         {"XDG_STATE_HOME", folder_ / "state"}};
  const Ended type = run({"plugins", "--type", "crash"}, options);
  EXPECT_EQ(type.code, 0) << type.err;
  EXPECT_EQ(type.out.find("crash, version 1, of the plug-in crash: \n  how "), 0u) << type.out;
  const Ended command = run({"plugins", "--command", "crashNow"}, options);
  EXPECT_EQ(command.code, 0) << command.err;
  EXPECT_EQ(command.out.find("crashNow\n"), 0u) << command.out;
  const Ended choices = run({"plugins", "--type", "atfmVolume"});
  EXPECT_NE(choices.out.find("enum: volume (0), box (1), sphere (2)"), std::string::npos) << choices.out;
}

TEST_F(Program, TellsWhatIsInAScene) {
  render({"sphere", "-o", "a.exr", "--save-scene", "a.plinian"});
  const Ended text = run({"info", "a.plinian"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("medium_shape  atfmVolume        under medium_place\n"), std::string::npos)
      << text.out;
  const json report = json::parse(run({"info", "a.plinian", "--json"}).out);
  EXPECT_EQ(report["kind"], "scene");
  EXPECT_EQ(report["nodes"][0]["type"], "time");
  const Ended without = run({"info", "a.plinian"}, {.environment = {{"PLINIAN_PLUGINS", "/nowhere"}}});
  EXPECT_EQ(without.code, 0);
  EXPECT_NE(without.err.find("it needs the plug-in atfm"), std::string::npos) << without.err;
}

TEST_F(Program, VariantsStandOnASheet) {
  render({"sphere", "--vary", "medium.albedo=0.1,0.5,0.9", "--vary", "key.exposure=0,1", "--sheet", "v.png"});
  const Image sheet = picture("v.png");
  EXPECT_EQ(sheet.width, 3 * 12 + 2 * 48);
  // Down the sheet albedo rises, and the picture with it.
  const auto brightness = [&](int row) {
    const int top = 12 + row * ((sheet.height - 12) / 3);
    double sum = 0.0;
    for (int y = top; y < top + 32; ++y)
      for (int x = 12; x < 12 + 48; ++x) sum += sheet.find("G")->values[std::size_t(y) * sheet.width + x];
    return sum;
  };
  EXPECT_LT(brightness(0), brightness(1));
  EXPECT_LT(brightness(1), brightness(2));
  EXPECT_EQ(run({"render", "sphere", "--vary", "medium.albedo=1"}).code, 1);
  EXPECT_NE(run({"render", "sphere", "--vary", "medium.albdo=1,2", "--sheet", "v.png"}).err.find("albedo"),
            std::string::npos);
}

TEST_F(Program, AVariantThatFailsIsNamedAndTheOthersAreDrawn) {
  ASSERT_EQ(run({"make", "ash", "-o", "a.vdb", "--resolution", "16"}).code, 0);
  const Ended ended =
      run({"render", "a.vdb", "--vary", "medium_file.grid=density,gone", "--vary", "key.exposure=0,1",
           "--sheet", "v.png", "--json", "--renderer", "cpu", "--passes", "1", "--size", "48x32"});
  EXPECT_EQ(ended.code, 1);
  for (const char* exposure : {"0", "1"})
    EXPECT_NE(
        ended.err.find("error: --vary medium_file.grid=gone, key.exposure=" + std::string(exposure) + ": "),
        std::string::npos)
        << ended.err;
  const Image sheet = picture("v.png");
  EXPECT_EQ(sheet.width, 3 * 12 + 2 * 48);
  const auto brightness = [&](int row) {
    const int top = 12 + row * ((sheet.height - 12) / 2);
    double sum = 0.0;
    for (int y = top; y < top + 32; ++y)
      for (int x = 12; x < 12 + 48; ++x) sum += sheet.find("G")->values[std::size_t(y) * sheet.width + x];
    return sum;
  };
  EXPECT_GT(brightness(0), 0.0);
  EXPECT_EQ(brightness(1), 0.0) << "an empty cell";
  const nlohmann::json report = nlohmann::json::parse(ended.out);
  EXPECT_FALSE(report["variants"][0].contains("error"));
  EXPECT_TRUE(report["variants"][2].contains("error"));
}

TEST_F(Program, VariationsAreReadWordByWord) {
  const auto refusal = [&](const std::string& vary) {
    const Ended ended = run({"render", "sphere", "--vary", vary, "--sheet", "v.png"});
    EXPECT_EQ(ended.code, 1);
    return ended.err;
  };
  EXPECT_EQ(refusal("medium.albedo=0.3,,"),
            "plinian: error: --vary medium.albedo=0.3,,: there is no value before a comma\n");
  EXPECT_EQ(refusal("medium.albedo=0.3,"),
            "plinian: error: --vary medium.albedo=0.3,: there is no value behind a comma\n");
  const Ended labels = render({"sphere", "--vary", "medium_place.rotate.y=0,9", "--vary", "key.exposure=1",
                               "--vary", "rim.exposure=2", "--sheet", "v.png"});
  EXPECT_NE(labels.err.find("rotate.y 9, key.exposure 1, rim.exposure 2: cpu"), std::string::npos)
      << labels.err;
  EXPECT_NE(labels.err.find(", 1 pass in "), std::string::npos) << labels.err;
  EXPECT_EQ(run({"render", "sphere", "--vary", "medium.albedo=0.3", "--vary", "medium.albedo=0.6", "--sheet",
                 "v.png"})
                .err,
            "plinian: error: --vary medium.albedo: is varied twice; give all its values at once\n");
  EXPECT_EQ(run({"render", "sphere", "--vary", "medium.albedo=0.3", "--sheet", "v.png", "-o", "o.png"}).err,
            "plinian: error: --output: variants go on the sheet, v.png: leave it out\n");
  // A picture is labelled by what it shows.
  const Ended limited = render({"sphere", "--vary", "medium.g=0.5,2", "--sheet", "v.png"});
  EXPECT_NE(limited.err.find("medium.g 0.5: cpu"), std::string::npos) << limited.err;
  EXPECT_NE(limited.err.find("medium.g 1 (asked: 2): cpu"), std::string::npos) << limited.err;
}

TEST_F(Program, ASceneSaysWhatAnOptionForAVolumeMeantAndWhatHasNoSettings) {
  render({"ash", "--resolution", "16", "--save-scene", "s", "-o", "a.png"});
  const auto refusal = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "s.plinian", "-o", "b.png"});
    return run(more).err;
  };
  EXPECT_EQ(refusal({"--seed", "3"}),
            "plinian: error: --seed: is for a volume; the scene says it by an attribute: --set "
            "medium_noise.seed=3\n");
  folder_.write("n.pln", "delete settings\nsave n.plinian\nsetAttr settings.width 3\n");
  EXPECT_NE(run({"run", "n.pln", "s.plinian"})
                .err.find("there is no node 'settings': createNode renderSettings -name settings makes it"),
            std::string::npos);
  EXPECT_NE(
      run({"render", "n.plinian", "--set", "settings.width=3"}).err.find("the scene has no settings: --size"),
      std::string::npos);
}

TEST_F(Program, ANamespaceIsNamedOnceForAllThatIsInIt) {
  folder_.write("s.pln", "import ash -resolution 16 -setup -namespace seq\nsave s\n");
  ASSERT_EQ(run({"run", "s.pln"}).code, 0);
  EXPECT_EQ(
      run({"render", "s.plinian", "--set", "medium.g=0"}).err,
      "plinian: error: --set medium.g: nothing is called 'medium' (did you mean 'seq:medium'?); there are: "
      "map, view, time1, settings, seq:*\n");
}

TEST_F(Program, AScaleOfNothingIsWhyNothingIsSeen) {
  const Ended ended = render({"sphere", "--set", "medium_place.scale=0 0 0", "-o", "a.png"});
  EXPECT_NE(ended.err.find("is scaled by 0: set the scale of what it is under"), std::string::npos)
      << ended.err;
}

TEST_F(Program, AFocalLengthOfNothingIsHeldWhereItCanBeDrawn) {
  render({"sphere", "--save-scene", "s.plinian", "-o", "a.png"});
  const Ended held = run({"render", "s.plinian", "--set", "camera.focal_length=0", "-o", "b.png",
                          "--renderer", "cpu", "--size", "8x8", "--passes", "1"});
  EXPECT_EQ(held.code, 0) << held.err;
  EXPECT_NE(held.err.find("camera.focal_length is out of its range (a number >= 0.1) and was set to 0.1"),
            std::string::npos)
      << held.err;
}

TEST_F(Program, AdviceOfAnImportNamesItsOwnFlags) {
  ASSERT_EQ(run({"make", "ash", "-o", "a.vdb", "--resolution", "16"}).code, 0);
  folder_.write("s.pln", "import a.vdb\n");
  const Ended script = run({"run", "s.pln"});
  EXPECT_EQ(script.code, 0);
  EXPECT_NE(script.err.find("-upAxis"), std::string::npos) << script.err;
  EXPECT_EQ(script.err.find("--"), std::string::npos) << script.err;
  folder_.write("f.pln", "import a.vdb -up-axis z\n");
  EXPECT_NE(run({"run", "f.pln"}).err.find("unknown flag '-up-axis' (did you mean '-upAxis'?)"),
            std::string::npos);
}

TEST_F(Program, AnEditCostsNoMoreThanItsOwnWork) {
  expect_edits_cost_their_own_work("cpu", "16", "8x8", 0);
}

}  // namespace
}  // namespace plinian
