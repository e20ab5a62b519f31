// Which grids a file is said to have, and when it is read again.
#include "host/window/files/grid_lists.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/media/vdb_writer.h"
#include "host/window/panels/grid_field.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian::window {
namespace {

BrickVolume ball(bool hot) {
  BrickVolumeBuilder builder;
  std::vector<float> density(512, 0.5f), temperature(512, 900.0f);
  builder.add(ivec3(0), density.data(), hot ? temperature.data() : nullptr);
  return builder.build(dmat4(1.0));
}

std::shared_ptr<const GridList> wait_for(GridLists& lists, const std::string& path) {
  for (int i = 0; i < 5000; ++i) {
    if (const auto list = lists.of(path)) return list;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return nullptr;
}

std::string names(const GridList& list) {
  std::string text;
  for (const VdbGridInfo& grid : list.grids) text += (text.empty() ? "" : " ") + grid.name;
  return text;
}

TEST(GridLists, ListAFileOnceAndASequenceByFilesThatMayDiffer) {
  const TemporaryFolder folder;
  for (int i = 1; i <= 5; ++i)
    write_vdb(folder / ("fire." + std::to_string(i) + ".vdb"), ball(i == 3),
              {.density_grid = i == 5 ? "late" : "density"});
  GridLists lists([] {});
  EXPECT_EQ(lists.of(""), nullptr);
  EXPECT_EQ(lists.of(folder / "fire.3.vdb"), nullptr) << "the interface does not wait";
  const auto one = wait_for(lists, folder / "fire.3.vdb");
  ASSERT_TRUE(one);
  EXPECT_EQ(names(*one), "density temperature");
  EXPECT_EQ(kind_text(one->grids[0]), "half fog volume");
  EXPECT_EQ(extent_text(one->grids[0]), "8 x 8 x 8");
  EXPECT_GT(one->grids[0].stored_bytes, 0u);
  EXPECT_EQ(lists.reads(), 1);
  const auto all = wait_for(lists, folder / "fire.#.vdb");
  ASSERT_TRUE(all);
  EXPECT_EQ(names(*all), "density temperature late") << "of the first, the middle and the last";
  EXPECT_EQ(lists.reads(), 3) << "the middle one was known";
  ASSERT_TRUE(wait_for(lists, folder / "fire.3.vdb"));
  EXPECT_EQ(lists.reads(), 3);

  // Another file under the same name.
  write_vdb(folder / "fire.3.vdb", ball(false), {.density_grid = "fresh"});
  std::string now;
  for (int i = 0; i < 5000 && now != "fresh"; ++i) {
    if (const auto list = lists.of(folder / "fire.3.vdb")) now = names(*list);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(now, "fresh");
}

TEST(GridLists, SayWhyThereIsNone) {
  const TemporaryFolder folder;
  folder.write("text.vdb", "no volume at all");
  GridLists lists([] {});
  for (const char* name : {"text.vdb", "missing.vdb", "no.####.vdb"}) {
    const auto list = wait_for(lists, folder / name);
    ASSERT_TRUE(list) << name;
    EXPECT_TRUE(list->grids.empty());
    EXPECT_NE(list->problem.find(name), std::string::npos) << list->problem;
  }
}

TEST(GridField, IsAskedForByTheWidgetOfAnAttribute) {
  const auto plain = grid_widget("grid of file");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->file, "file");
  EXPECT_FALSE(plain->or_none);
  EXPECT_TRUE(grid_widget("grid of cache or none")->or_none);
  for (const char* other : {"", "grid", "grid of", "look", "factor"})
    EXPECT_FALSE(grid_widget(other)) << other;
}

TEST(GridField, SaysWhatIsChosenByName) {
  const TemporaryFolder folder;
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  session.execute("createNode volumeRead -name file");
  const auto said = [&](const char* attribute) {
    const graph::Plug plug = session.graph().plug(std::string("file.").append(attribute));
    return grid_by_name(
        session, plug,
        *grid_widget((*session.graph().get("file").schema)[plug.attribute].spec.layout.widget));
  };
  const auto read = [&](const std::string& name) {
    session.execute("setAttr file.file " + graph::quote(folder / name));
    EXPECT_EQ(said("grid"), "") << "nothing is read to find out";
    session.evaluator().evaluate(session.graph().plug("file.volume"));
  };
  write_vdb(folder / "cold.vdb", ball(false), {.density_grid = "smoke"});
  write_vdb(folder / "hot.vdb", ball(true), {});
  read("cold.vdb");
  EXPECT_EQ(said("grid"), "smoke");
  EXPECT_EQ(said("temperature_grid"), "none");
  read("hot.vdb");
  EXPECT_EQ(said("grid"), "density");
  EXPECT_EQ(said("temperature_grid"), "temperature");
  session.execute("setAttr file.grid temperature");
  session.evaluator().evaluate(session.graph().plug("file.volume"));
  EXPECT_EQ(said("grid"), "") << "it is named";
}

}  // namespace
}  // namespace plinian::window
