// Scripts that are stopped, and what they say then.
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

TEST_F(Program, CtrlCAndAPoliteKillReachAComputationThatAScriptWaitsFor) {
  folder_.write("s.pln",
                "loadPlugin patient\ncreateNode patient\nls -type patient\nevaluate patient1.out\nls\n");
  for (const int signal : {SIGINT, SIGTERM}) {
    RunOptions options;
    options.environment = {{"PLINIAN_PLUGIN_PATH", PLINIAN_TEST_PLUGINS}};
    options.signal = signal;
    options.signal_after_text = "patient1\npatient1";
    options.signal_after_s = 0.3;
    const Ended ended = run({"run", "s.pln"}, options);
    EXPECT_EQ(ended.code, 130);
    EXPECT_EQ(ended.err, "plinian: error: s.pln:4: cancelled here; what the lines before it did is done\n");
    EXPECT_EQ(ended.out, "patient\npatient1\npatient1\n");
  }
}

TEST_F(Program, APoliteKillLeavesAPluginThatDoesNotListenAndNamesIt) {
  folder_.write("s.pln",
                "loadPlugin patient\ncreateNode patient\nsetAttr patient1.deaf on\nevaluate patient1.out\n");
  RunOptions options;
  options.environment = {{"PLINIAN_PLUGIN_PATH", PLINIAN_TEST_PLUGINS}};
  options.signal = SIGTERM;
  options.signal_after_text = "patient1";
  options.signal_after_s = 0.3;
  const auto start = std::chrono::steady_clock::now();
  const Ended ended = run({"run", "s.pln"}, options);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30)) << "of 60 that it would take";
  EXPECT_EQ(ended.code, 130);
  EXPECT_EQ(
      ended.err,
      "plinian: still at work in the plug-in 'patient' while computing patient1.out, which ends with the "
      "program in a few seconds\n"
      "plinian: error: ended at work in the plug-in 'patient' while computing patient1.out, which does not "
      "ask whether it is cancelled\n");
}

TEST_F(Program, AScriptMakesThePictureThatAProceduralMediumAloneMakes) {
  folder_.write("s.pln",
                "import -setup explosion\nsetAttr medium_noise.resolution 24\n"
                "render a.png -renderer cpu -passes 1 -size 48x32\nsave s.plinian\n");
  const Ended made = run({"run", "s.pln"});
  EXPECT_EQ(made.code, 0) << made.err;
  const Ended ls = run({"info", "s.plinian"});
  for (const char* node : {"key", "rim", "camera", "settings", "medium_noise"})
    EXPECT_NE(ls.out.find(node), std::string::npos) << node;
}

// Whoever writes a line can wait for its answer before the next one, and Ctrl-C ends the waiting.
TEST_F(Program, LinesOfStandardInputAreRunAsTheyCome) {
  const std::string script = "coproc P { exec '" + program_path() +
                             "' run -; }; echo 'createNode transform -name a' >&${P[1]}; "
                             "read -t 60 -u ${P[0]} answer; echo \"got $answer\"; "
                             "echo 'ls -type transform' >&${P[1]}; "
                             "read -t 60 -u ${P[0]} answer; echo \"got $answer\"; "
                             "kill -INT $P_PID; wait $P_PID; echo \"ended $?\"";
  folder_.write("s.sh", script);
  FILE* shell = popen(("cd '" + folder_.path().string() + "' && bash s.sh 2>/dev/null").c_str(), "r");
  ASSERT_TRUE(shell);
  std::string heard;
  for (int c; (c = std::fgetc(shell)) != EOF;) heard += char(c);
  pclose(shell);
  EXPECT_EQ(heard, "got a\ngot a\nended 130\n");
}

TEST_F(Program, AWarningOfAScriptNamesItsLine) {
  folder_.write("s.pln", "createNode medium -name m\nsetAttr m.g 7\n");
  const Ended ended = run({"run", "s.pln"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_TRUE(ended.err.starts_with("warning: s.pln:2: m.g is out of its range")) << ended.err;
}

TEST_F(Program, AByteOrderMarkIsNoPartOfAScriptOrAScene) {
  folder_.write("s.pln",
                "\xef\xbb\xbf"
                "createNode medium -name m\n");
  folder_.write("s.plinian",
                "\xef\xbb\xbf"
                "plinian scene 1.0\nend\n");
  const Ended ended = run({"run", "s.pln", "s.plinian"});
  EXPECT_EQ(ended.out, "m\n") << ended.err;
  EXPECT_NE(run({"run", "s.plinian"}).err.find("is a scene, not a script"), std::string::npos);
}

TEST_F(Program, ARunThatKeepsGoingTellsWhatFailedAndFails) {
  folder_.write("s.pln", "createNode transform -name a\nnonsense\nls -type transform\n");
  const Ended ended = run({"run", "-k", "s.pln"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.out, "a\na\n");
  EXPECT_TRUE(ended.err.starts_with("plinian: error: s.pln:2: unknown command 'nonsense'")) << ended.err;
  EXPECT_EQ(run({"run", "s.pln"}).out, "a\n");
}

TEST_F(Program, AnEndlessLineIsRefusedAtOnce) {
  const std::string shell = "head -c 40000000 /dev/zero | tr '\\0' x > big.pln; '" + program_path() +
                            "' run big.pln 2>&1; '" + program_path() + "' run - < big.pln 2>&1";
  const auto start = std::chrono::steady_clock::now();
  FILE* pipe = popen(("cd '" + folder_.path().string() + "' && " + shell).c_str(), "r");
  ASSERT_TRUE(pipe);
  std::string heard;
  for (int c; (c = std::fgetc(pipe)) != EOF;) heard += char(c);
  pclose(pipe);
  EXPECT_EQ(heard,
            "plinian: error: big.pln:1: the line is longer than 16 MiB: this is no script\n"
            "plinian: error: standard input:1: the line is longer than 16 MiB: this is no script\n");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  // One that is only long is an unknown command like any other.
  folder_.write("long.pln", std::string(4 << 20, 'x'));
  const Ended ended = run({"run", "long.pln"});
  EXPECT_NE(ended.err.find("long.pln:1: unknown command 'xxx"), std::string::npos)
      << ended.err.substr(0, 200);
}

TEST_F(Program, AScriptsPictureTellsWhatItShowsInPlaceOfAFrame) {
  ASSERT_EQ(run({"make", "ash", "-o", "a.1.vdb", "--resolution", "16"}).code, 0);
  folder_.write("s.pln",
                "import a.#.vdb -setup\ncurrentTime 9\nrender e.png -size 16x16 -renderer cpu -passes 1\n");
  const Ended shown = run({"run", "s.pln"});
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_NE(shown.err.find("warning: s.pln:3: medium_file: behind the last frame of the sequence, 1"),
            std::string::npos)
      << shown.err;
  folder_.write("t.pln",
                "import a.#.vdb -setup\nsetAttr medium_file.missing error\ncurrentTime 9\n"
                "render f.png -size 16x16 -renderer cpu -passes 1\n");
  const Ended refused = run({"run", "t.pln"});
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("a.9.vdb: no such file"), std::string::npos) << refused.err;
}

TEST_F(Program, AScriptAndASceneAreToldApart) {
  folder_.write("s.pln", "ls\n");
  folder_.write("s.plinian", "plinian scene 1.0\nend\n");
  for (const char* command : {"render", "info"})
    EXPECT_EQ(run({command, "s.pln"}).err,
              "plinian: error: s.pln: is a script: 'plinian run s.pln' runs it\n");
  EXPECT_EQ(
      run({"run", "s.plinian"}).err,
      "plinian: error: s.plinian: is a scene, not a script: 'plinian render s.plinian' makes a picture, "
      "'plinian run SCRIPT s.plinian' runs a script on it\n");
}

TEST_F(Program, ABadVariantIsToldBeforeAPictureIsMade) {
  const Ended ended = run({"render", "sphere", "--renderer", "cpu", "--passes", "1", "--size", "48x32",
                           "--vary", "medium.albedo=0.5,abc", "--sheet", "v.png"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.err.find("albedo 0.5"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find(
                "--vary medium.albedo: medium.albedo expects a number or 3 numbers from 0 to 1, not 'abc'"),
            std::string::npos)
      << ended.err;
}

}  // namespace
}  // namespace plinian
