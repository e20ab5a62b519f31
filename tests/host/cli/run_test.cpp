// Scripts that are stopped, and what they say then.
#include "tests/host/cli/program_fixture.h"

namespace plinian {
namespace {

TEST_F(Program, CtrlCAndAPoliteKillReachAComputationThatAScriptWaitsFor) {
  folder_.write("s.pln", "loadPlugin patient\ncreateNode patient\nls -type patient\nevaluate patient1.out\nls\n");
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

}  // namespace
}  // namespace plinian
