// A plug-in that crashes takes the program with it, but not its name, nor what was answered before.
#include <csignal>

#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

class Crash : public Program {
 protected:
  void SetUp() override {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer has handlers of its own";
#endif
  }
  // Runs a script; part: of the plug-in's life in which it crashes.
  Ended script(const std::string& text, const std::string& part = "") {
    std::ofstream(folder_ / "a.pln") << text;
    RunOptions options;
    options.environment = {{"PLINIAN_PLUGIN_PATH", PLINIAN_TEST_PLUGINS},
                           {"XDG_STATE_HOME", (folder_ / "state")},
                           {"PLINIAN_TEST_CRASH", part}};
    return run({"run", "a.pln"}, options);
  }
  // Ends by the signal with exactly that line.
  void expect_crash(const Ended& ended, int signal, const std::string& where) {
    EXPECT_EQ(ended.code, 128 + signal) << ended.err;
    EXPECT_EQ(ended.error_lines(), 1) << ended.err;
    EXPECT_EQ(ended.err, "plinian: error: " + where + "\n");
  }
};

TEST_F(Crash, NamesThePluginAndWhatItWasDoing) {
  const std::string nodes = "loadPlugin crash\ncreateNode crash -name c\n";
  const auto computing = [&](const std::string& how) {
    const Ended ended = script(nodes + "setAttr c.how " + how + "\ngetAttr c.out\n");
    EXPECT_EQ(ended.out, "crash\nc\n") << "answers before it are out";
    return ended;
  };
  expect_crash(computing("fault"), SIGSEGV,
               "segmentation fault (SIGSEGV) in the plug-in 'crash' while computing c.out");
  expect_crash(computing("abort"), SIGABRT, "aborted (SIGABRT) in the plug-in 'crash' while computing c.out");
  expect_crash(computing("overrun"), SIGSEGV,
               "segmentation fault (SIGSEGV) in the plug-in 'crash' while computing c.out");
  expect_crash(computing("fill"), SIGSEGV,
               "segmentation fault (SIGSEGV) in the plug-in 'crash' while computing c.out");
  expect_crash(script("loadPlugin crash\ncrashNow\n"), SIGSEGV,
               "segmentation fault (SIGSEGV) in the plug-in 'crash' while running the command crashNow");
  expect_crash(script(nodes + "currentTime 5\n"), SIGSEGV,
               "segmentation fault (SIGSEGV) in the plug-in 'crash' while hearing of the event "
               "timeChanged");
}

// A licence library that is not content ends whatever it is in.
TEST_F(Crash, APluginThatEndsTheProgramIsNoSuccess) {
  const Ended ended = script("createNode transform -name a\nloadPlugin crash\nls\n", "exit");
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.out, "a\n");
  EXPECT_TRUE(ended.err.starts_with(
      "plinian: error: the program was ended by a call of exit in the plug-in 'crash' while "))
      << ended.err;
}

TEST_F(Crash, WhileBeingLoadedIsToldOfNextTimeAndNotTriedAgain) {
  for (const std::string part : {"load", "initialise"}) {
    const std::string doing = part == "load" ? "being loaded" : "being initialised";
    expect_crash(script("loadPlugin crash\n", part), SIGSEGV,
                 "segmentation fault (SIGSEGV) in the plug-in 'crash' while " + doing);
    // A scene that needs it opens without, and says why.
    std::ofstream(folder_ / "a.plinian") << "plinian scene 1.0\nrequires crash 1.0\nnode crash c\nend\n";
    const std::string path = std::string(PLINIAN_TEST_PLUGINS) + "/crash.so";
    Ended next = script("open a.plinian\nls -type crash\n");
    EXPECT_EQ(next.code, 0) << next.err;
    EXPECT_EQ(next.err.find("warning: a.pln:1: " + path +
                            ": did not come back when it was loaded last, and is skipped; 'loadPlugin " +
                            path + "' tries it again\n"),
              0u)
        << next.err;
    EXPECT_EQ(script("loadPlugin crash\n").code, 1) << "by its name it is not tried";
    // By its path it is, and then it is as good as any.
    EXPECT_EQ(script("loadPlugin " + path + "\n").out, "crash\n");
    EXPECT_EQ(script("loadPlugin crash\n").out, "crash\n");
  }
}

TEST_F(Crash, APluginThatWasBuiltAgainIsTriedAgain) {
  const std::string own = folder_ / "crash.so";
  std::filesystem::copy_file(std::string(PLINIAN_TEST_PLUGINS) + "/crash.so", own);
  const auto load = [&](const std::string& part) {
    std::ofstream(folder_ / "a.pln") << "loadPlugin crash\n";
    RunOptions options;
    options.environment = {{"PLINIAN_PLUGIN_PATH", folder_.path()},
                           {"XDG_STATE_HOME", (folder_ / "state")},
                           {"PLINIAN_TEST_CRASH", part}};
    return run({"run", "a.pln"}, options).code;
  };
  EXPECT_EQ(load("load"), 128 + SIGSEGV);
  EXPECT_EQ(load(""), 1);
  RunOptions listing;
  listing.environment = {{"PLINIAN_PLUGIN_PATH", folder_.path()}, {"XDG_STATE_HOME", (folder_ / "state")}};
  const Ended listed = run({"plugins"}, listing);
  EXPECT_NE(listed.out.find("did not come back when it was loaded last, and is skipped; 'loadPlugin " + own),
            std::string::npos)
      << listed.out;
  EXPECT_LT(listed.out.find("atfm "), listed.out.find("crash ")) << "by name";
  std::filesystem::last_write_time(own, std::filesystem::last_write_time(own) + std::chrono::seconds(1));
  EXPECT_EQ(load(""), 0);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / std::filesystem::path("state/plinian/loading")));
}

}  // namespace
}  // namespace plinian
