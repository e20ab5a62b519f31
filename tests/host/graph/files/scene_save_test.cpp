// Whatever moment the process dies while saving, a whole scene is left.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "core/files/atomic_file.h"
#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

TEST(SceneSave, KilledAtAnyMomentItLeavesASceneThatOpens) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.pln";
  TestScene scene;
  for (int i = 0; i < 300; ++i) scene.create("every", "node" + std::to_string(i));
  save_scene(path, write_scene(scene.graph));
  std::mt19937 random(11);
  int killed_while_saving = 0;
  for (int run = 0; run < 200; ++run) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      // Only saves; the text differs from save to save.
      const std::string text = write_scene(scene.graph);
      for (int i = 0; i < 100000; ++i) {
        std::string changed = text;
        changed.insert(changed.find("node every node1\n") + 17,
                       "  .weight 0." + std::to_string(1 + i) + "\n");
        save_scene(path, changed);
      }
      ::_exit(0);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500 + random() % 15000));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    killed_while_saving += WIFSIGNALED(status);
    for (const std::string& file : {path, path + ".bak"}) {
      if (!std::filesystem::exists(file)) continue;
      TestScene opened;
      ASSERT_NO_THROW(read_scene(read_text_file(file), file, opened.registry, opened.editor));
      ASSERT_EQ(opened.graph.size(), 300u);
    }
  }
  EXPECT_EQ(killed_while_saving, 200);
  EXPECT_TRUE(std::filesystem::exists(path + ".bak"));
}

TEST(SceneSave, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(message_of([&] { read_text_file(folder / "none.pln"); }),
            folder / "none.pln" + std::string(": cannot be read: No such file or directory"));
  EXPECT_EQ(message_of([&] { read_text_file(folder.path().string()); }),
            folder.path().string() + ": is a folder");
  EXPECT_THROW(save_scene(folder / "nowhere/a.pln", "x"), FileError);
}

}  // namespace
}  // namespace plinian::graph
