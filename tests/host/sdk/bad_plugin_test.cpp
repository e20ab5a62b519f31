// Plug-ins that are unfit: each is refused with one line, and leaves nothing behind.
#include <fstream>

#include "host/sdk/contribution.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

const std::string folder = PLINIAN_TEST_PLUGINS;

TEST(BadPlugin, WhatCannotBeUsedIsRefusedAsAWhole) {
  const TemporaryFolder own;
  PluginSession s;
  EXPECT_EQ(s.refusal("loadPlugin wabble"), "there is no plug-in 'wabble' (did you mean 'wobble'?)");
  EXPECT_EQ(s.refusal("loadPlugin unheardOf"), "there is no plug-in 'unheardOf' in " + folder);
  EXPECT_EQ(s.refusal("loadPlugin ./nowhere.so"), "./nowhere.so: there is no such file");
  std::ofstream(own / "text.so") << "no library";
  EXPECT_EQ(s.refusal("loadPlugin " + own / "text.so"),
            own / "text.so" + std::string(": is not a shared library"));
  EXPECT_EQ(s.refusal("loadPlugin throws"), folder + "/throws.so: failed to initialise: it is Monday");
  EXPECT_EQ(
      s.refusal("loadPlugin bad_type"),
      folder + "/bad_type.so: node type 'badNode': attribute 'a' affects 'nothing', which is no output");
  // The static initialisers of this one would end the program: it is judged by what it says of itself.
  const auto described = [&](const std::string& plugin, const std::string& description) {
    std::filesystem::copy_file(folder + "/" + plugin + ".so", own / plugin + ".so",
                               std::filesystem::copy_options::overwrite_existing);
    std::ofstream(own / plugin + ".so.plinian") << description;
    return "loadPlugin " + own / plugin + ".so";
  };
  EXPECT_EQ(
      s.refusal(described("plain", "name plain\nversion 1\nabi 2.0\n")),
      own / "plain.so" + std::string(": was built for version 2.0 of the plug-in interface, this program has "
                                     "1.3: it needs a newer Plinian"));
  EXPECT_EQ(s.refusal(described("no_symbols", "name none\nversion 1\nabi 1.0\n")),
            own / "no_symbols.so" + std::string(": lacks the function plinian_initialise"));
  EXPECT_EQ(s.refusal(described("throws_through", "name through\nversion 1\nabi 1.0\n")),
            own / "throws_through.so" + std::string(": failed to initialise: it threw an exception"));
  s.run("loadPlugin wobble");
  EXPECT_EQ(s.run("loadPlugin wobble"), "wobble") << "a script that asks for it runs after one that did";
  std::filesystem::copy_file(folder + "/wobble.so", std::string(own / "wobble.so"));
  EXPECT_EQ(s.refusal("loadPlugin " + (own / "wobble.so")),
            own / "wobble.so" +
                std::string(": the plug-in 'wobble' is loaded already, from " + folder + "/wobble.so"));
  EXPECT_EQ(s.refusal("loadPlugin same_type"),
            folder + "/same_type.so: node type 'wobble' is already registered by the plug-in 'wobble'");
  EXPECT_EQ(s.refusal("loadPlugin same_command"),
            folder + "/same_command.so: the command 'wobbleAll' is already registered");
  EXPECT_EQ(s.refusal("unloadPlugin wible"), "the plug-in 'wible' is not loaded (did you mean 'wobble'?)");
  EXPECT_EQ(s.refusal("loadPlugin bad_draw"),
            folder +
                "/bad_draw.so: failed to initialise: node type 'sky': its draw override is affected by "
                "'heigth', which is no input (did you mean 'height'?)");
  EXPECT_EQ(s.refusal("loadPlugin bad_menu"),
            folder + "/bad_menu.so: failed to initialise: a menu entry is named MENU/ENTRY, not 'Sky'");
  EXPECT_EQ(s.refusal("loadPlugin bad_event"),
            folder +
                "/bad_event.so: failed to initialise: there is no event 'tomeChanged' (did you mean "
                "'timeChanged'?)");
  EXPECT_EQ(s.refusal("loadPlugin data_twice"),
            folder + "/data_twice.so: data type 'pointList' is already registered by the plug-in 'bad'");
  EXPECT_EQ(
      s.refusal("loadPlugin bad_description"),
      folder +
          "/bad_description.so: registers command:unsaidToo, node:unsaid, which its description does not "
          "list; does not register data:undone, which its description lists");
  EXPECT_EQ(s.refusal("loadPlugin bad_symbol").find(folder + "/bad_symbol.so: cannot be loaded: "), 0u);
  s.run("loadPlugin extras");
  EXPECT_EQ(s.refusal("loadPlugin same_data"),
            folder + "/same_data.so: data type 'pointList' is already registered by the plug-in 'extras'");
  EXPECT_EQ(s.refusal("loadPlugin same_file"),
            folder + "/same_file.so: the file type 'others' cannot take .xyz, which 'points' has");
  // Nothing of those that were refused is left behind.
  s.run("currentTime 7\nunloadPlugin extras\nloadPlugin same_data\nunloadPlugin bad\nloadPlugin same_file");
}

TEST(BadPlugin, AContributionThatFailsIsAnErrorOfItsNodeAlone) {
  PluginSession s;
  s.run("loadPlugin bad_contribute\ncreateNode sky -name x\ncreateNode sky -name fine");
  const auto error = [&](const std::string& how) {
    s.run("setAttr x.how " + how);
    EXPECT_EQ(s.run("evaluate fine.contribution").find("fine.contribution plinian.contribution"), 0u);
    return graph::message_of([&] { s.session.execute("evaluate x.contribution"); });
  };
  EXPECT_EQ(error("throws"), "x.contribution: the sky has fallen");
  EXPECT_EQ(error("other"), "x.contribution: failed without saying why");
  EXPECT_EQ(error("volume"), "x.contribution: a medium of voxels needs a volume");
  EXPECT_EQ(error("light"), "x.contribution: a light 'sun': its toward has no length");
  EXPECT_EQ(error("matrix"),
            "x.contribution: a camera: its object_from_camera is no transform that could be taken back");
  EXPECT_EQ(error("mirrored"),
            "x.contribution: a camera: its object_from_camera mirrors: give it a rotation and a translation");
  EXPECT_EQ(error("empty"),
            "x.contribution: a volume needs a function that fills it: VolumeSource::fill is empty");
  EXPECT_EQ(error("bounds"), "x.contribution: bounds must be finite, the minimum below the maximum");
  s.session.evaluator().take_reports();
  s.run("setAttr x.how throws");
  for (int i = 0; i < 3; ++i)
    EXPECT_NE(graph::message_of([&] { s.session.execute("evaluate x.contribution"); }), "");
  EXPECT_EQ(s.session.evaluator().take_reports(),
            std::vector<std::string>{"x.contribution: the sky has fallen"});
}

// A plug-in counts its attributes itself: one that was never added is an error of the node, no crash.
TEST(BadPlugin, AnAttributeThatWasNeverAddedIsAnErrorOfItsNode) {
  PluginSession s;
  s.run("loadPlugin wobble\ncreateNode wobble -name w");
  const std::pair<const char*, const char*> cases[] = {{"read nothing", "reads attribute number -1"},
                                                       {"read beyond", "reads attribute number 99"},
                                                       {"elements beyond", "reads attribute number 99"},
                                                       {"write beyond", "writes attribute number 99"}};
  for (const auto& [label, told] : cases) {
    s.run(std::string("setAttr w.label \"") + label + "\"");
    const std::string message = s.refusal("getAttr w.out");
    EXPECT_NE(message.find(std::string(told) + ", which wobble does not have: was it added?"),
              std::string::npos)
        << message;
  }
}

// What it sees stays where it was; what is not a camera's is left out.
TEST(BadPlugin, ACameraThatScalesOrShearsIsMadeRigidAndToldOf) {
  PluginSession s;
  std::vector<std::string> warnings;
  s.session.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  s.run("loadPlugin bad_contribute\ncreateNode sky -name x\nsetAttr x.how sheared");
  const graph::ResultPtr result = s.session.evaluator().evaluate(s.session.graph().plug("x.contribution"));
  const dmat4 camera = contribution_in(result->value)->cameras.at(0).camera.world_from_camera;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(glm::dot(dvec3(camera[i]), dvec3(camera[k])), i == k ? 1.0 : 0.0, 1e-12) << i << k;
  EXPECT_EQ(dvec3(camera[3]), dvec3(5, 6, 7));
  EXPECT_EQ(dvec3(camera[2]), dvec3(0, 0, 1)) << "it looks where it looked";
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "x.contribution: a camera: its object_from_camera scales or shears, which is left out: give it a "
            "rotation and a translation");
}

TEST(BadPlugin, WhatACommandThrowsIsToldWithItsName) {
  PluginSession s;
  s.run("loadPlugin bad_command");
  EXPECT_EQ(s.refusal("stumble number"), "stumble: stoi");
  EXPECT_EQ(s.refusal("stumble other"), "stumble: failed without saying why");
  EXPECT_EQ(s.refusal("stumble inner"), "stumble: there is no node 'nobody'");
  EXPECT_EQ(s.refusal("stumble named"), "stumble: not today");
}

TEST(BadPlugin, FunctionsThatAreEmptyAreRefusedWhenTheyAreRegistered) {
  PluginSession s;
  const std::string file = PLINIAN_TEST_PLUGINS "/";
  EXPECT_EQ(s.refusal("loadPlugin empty_command"),
            file + "empty_command.so: failed to initialise: the command 'nothing' does nothing");
  EXPECT_EQ(s.refusal("loadPlugin empty_data"), file +
                                                    "empty_data.so: failed to initialise: the data type "
                                                    "'nothing' needs functions to write and to read it");
  EXPECT_EQ(
      s.refusal("loadPlugin empty_event"),
      file + "empty_event.so: failed to initialise: the event 'timeChanged' is given no function to call");
  EXPECT_EQ(s.refusal("loadPlugin empty_flag"),
            file +
                "empty_flag.so: failed to initialise: the command 'nothing': the flag -often takes no word, "
                "so that it cannot be given several times");
}

TEST(BadPlugin, AWidgetThatThereIsNotIsToldWhenItIsRegistered) {
  PluginSession s;
  EXPECT_EQ(
      s.refusal("loadPlugin bad_widget"), PLINIAN_TEST_PLUGINS
      "/bad_widget.so: failed to initialise: attribute 'size': there is no widget 'sliderr' (did you mean "
      "'slider'?); there are: slider, factor, look, file, file .EXTENSION ..., grid of NAME, grid of NAME or "
      "none");
}

// It used to end the program with the stack.
TEST(BadPlugin, ACommandThatRunsItselfIsEndedAndSaysByWhichWay) {
  PluginSession s;
  s.run("loadPlugin bad_command");
  EXPECT_EQ(s.refusal("stumble itself"),
            "stumble: commands run one another without an end: stumble > stumble");
  EXPECT_EQ(s.refusal("stumble fall"),
            "stumble: fall: commands run one another without an end: stumble > fall > stumble");
  EXPECT_EQ(s.run("createNode transform -name still\nls still"), "still\nstill");
}

TEST(BadPlugin, AFlagOfManyMayBeGivenSeveralTimes) {
  PluginSession s;
  s.run("loadPlugin bad_command");
  std::string echo;
  s.session.on_echo = [&](const std::string& line) { echo = line; };
  EXPECT_EQ(s.run("collect -item one -once x -item \"two words\""), "one\ntwo words");
  EXPECT_EQ(echo, "collect -item one -item \"two words\" -once x");
  EXPECT_EQ(s.refusal("collect -once x -once y"), "collect: -once is given twice");
}

}  // namespace
}  // namespace plinian::sdk
