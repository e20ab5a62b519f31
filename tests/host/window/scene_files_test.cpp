// What takes the place of a scene is read first, and plug-ins hear of it.
#include "host/window/files/scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/media/vdb_writer.h"
#include "host/graph/files/scene_writer.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian::window {
namespace {

class Replacing : public testing::Test, private graph::SessionListener {
 protected:
  Replacing() {
    ::setenv("XDG_STATE_HOME", folder.path().c_str(), 1);
    files = std::make_unique<SceneFiles>(workspace, commands, viewpoint, console, trace);
    session().execute("createNode pointLight -name mine");
    session().history().mark_saved();
    session().add_listener(this);
  }
  ~Replacing() override {
    session().remove_listener(this);
    ::unsetenv("XDG_STATE_HOME");
  }
  graph::Session& session() { return workspace.session(); }
  std::string scene() { return graph::write_scene(session().graph()); }
  void work_off() {
    while (commands.has_work()) commands.work_off();
  }
  int errors() const {
    int count = 0;
    for (const ConsoleLine& line : console.lines()) count += line.kind == LineKind::error;
    return count;
  }

  TemporaryFolder folder;
  scene::Workspace workspace;
  ConsoleLog console;
  Trace trace{""};
  CommandQueue commands{workspace.session(), console, trace};
  SceneFeed feed{workspace};
  Viewpoint viewpoint{workspace, feed};
  std::unique_ptr<SceneFiles> files;
  std::string told;  // to plug-ins

 private:
  void passed(graph::SceneMoment moment, const std::string&) override {
    const bool there = session().graph().find("mine");
    if (moment == graph::SceneMoment::before_new) told += there ? "before " : "too late ";
    if (moment == graph::SceneMoment::after_new) told += there ? "too early " : "after ";
  }
  void begun() override { told += "["; }
  void ended(bool failed) override { told += failed ? "failed] " : "] "; }
};

TEST_F(Replacing, ByAMediumIsANewSceneOfItsOwn) {
  viewpoint.look.free = FreeCamera();
  files->begin_anew("sphere");
  work_off();
  EXPECT_EQ(errors(), 0);
  EXPECT_FALSE(session().graph().find("mine"));
  EXPECT_NE(scene().find("medium"), std::string::npos);
  EXPECT_EQ(told, "[before after ] ");
  EXPECT_FALSE(viewpoint.look.free);
  EXPECT_FALSE(session().history().is_modified());
  EXPECT_TRUE(session().history().undo_names().empty());
  EXPECT_EQ(session().scene_path(), "");
}

TEST_F(Replacing, ByWhatCannotBeReadLeavesTheSceneAsItIsWithOneLine) {
  folder.write("broken.vdb", "no volume at all");
  viewpoint.look.free = FreeCamera();
  session().execute("setAttr mine.exposure 3");
  session().history().mark_saved();
  const std::string before = scene();
  for (const std::string& bad : {folder / "broken.vdb", folder / "missing.vdb", std::string("nothing")}) {
    const int said = errors();
    told.clear();
    files->begin_anew(bad);
    work_off();
    EXPECT_EQ(scene(), before) << bad;
    EXPECT_EQ(errors(), said + 1) << bad;
    EXPECT_NE(console.lines().back().text.find(bad), std::string::npos) << console.lines().back().text;
    EXPECT_EQ(told, "[before failed] ") << bad;
    EXPECT_TRUE(viewpoint.look.free) << bad;
    EXPECT_EQ(session().history().undo_names().size(), 2u) << "what was done can be undone as before";
    EXPECT_FALSE(session().history().is_modified());
  }
  folder.write("broken.plinian", "no scene");
  files->open(folder / "broken.plinian");
  work_off();
  EXPECT_EQ(scene(), before);
  EXPECT_TRUE(viewpoint.look.free);
}

TEST_F(Replacing, AVolumeThatIsAddedIsCalledAfterItsFileSelectedAndToldOf) {
  BrickVolumeBuilder builder;
  const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, 1.0f);
  builder.add({0, 0, 0}, voxels.data());
  write_vdb(folder / "smoke.vdb", builder.build(dmat4(1.0)));
  session().execute("createNode camera");
  const std::string before = scene();
  const std::size_t steps = session().history().undo_names().size();
  bool framed = false;
  files->frame_all = [&] { framed = true; };
  for (const char* name : {"smoke", "smoke1"}) {
    files->add(folder / "smoke.vdb");
    work_off();
    EXPECT_EQ(errors(), 0) << console.lines().back().text;
    for (const char* part : {"", "_place", "_shape", "_file"})
      EXPECT_TRUE(session().graph().find(std::string(name) + part)) << name << part;
    ASSERT_EQ(session().graph().selection().size(), 1u);
    EXPECT_EQ(session().graph().find(session().graph().selection()[0])->name, std::string(name) + "_place");
    const auto& lines = console.lines();
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const ConsoleLine& line) {
      return line.kind == LineKind::note && line.text.starts_with("smoke.vdb: ") &&
             line.text.find(" m at (") != std::string::npos;
    }));
    EXPECT_TRUE(framed);
  }
  EXPECT_EQ(session().history().undo_names().size(), steps + 2) << "each is one step";
  session().history().undo();
  session().history().undo();
  EXPECT_EQ(scene(), before);
}

TEST_F(Replacing, AVolumeThatIsOpenedIsCalledAfterItsFileToo) {
  BrickVolumeBuilder builder;
  const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, 1.0f);
  builder.add({0, 0, 0}, voxels.data());
  write_vdb(folder / "old smoke.vdb", builder.build(dmat4(1.0)));
  files->begin_anew(folder / "old smoke.vdb");
  work_off();
  EXPECT_EQ(errors(), 0);
  ASSERT_TRUE(session().graph().find("old_smoke"));
  EXPECT_EQ(session().graph().selection(),
            std::vector<graph::NodeId>{session().graph().find("old_smoke")->id});
}

// As a volume that is dropped on the sample that the program began with.
TEST_F(Replacing, OfTheSampleComesBackWithOneUndo) {
  const std::string before = scene();
  files->begin_anew("sphere");
  work_off();
  const std::string sample = scene();
  ASSERT_NE(sample, before);
  session().replace_scene("import nothing", [] { return true; });
  EXPECT_NE(scene(), sample);
  session().history().undo();
  EXPECT_EQ(scene(), sample);
}

}  // namespace
}  // namespace plinian::window
