// Undo is whole: whatever was done, going back to the start gives the first scene and going forth the last
// one.
#include <cstdlib>
#include <random>

#include "tests/host/graph/commands/test_session.h"

namespace plinian::graph {
namespace {

class RandomCommands {
 public:
  explicit RandomCommands(unsigned seed) : random_(seed) {}

  std::string next(const Graph& graph) {
    const std::string node = any_node(graph), other = any_node(graph);
    switch (pick(24)) {
      case 0:
      case 1:
      case 2:
        return "createNode " + one_of({"every", "sum", "group", "shape", "follower"}) +
               (pick(3) == 0 ? " -name " + one_of({"a", "b1", "lib:c", "1bad"}) : "");
      case 3:
        return pick(4) == 0 ? "delete " + node : "delete " + node + " " + other;
      case 4:
        return "rename " + node + " " + one_of({"a", "ash", "lib:x", "x9", "bad name"});
      case 5:
        return "duplicate " + node + (pick(2) ? " -shareKeys" : "");
      case 6:
        return pick(3) ? "parent " + node + " " + other : "parent -world " + node;
      case 7:
      case 8:
      case 9:
      case 10:
        return "setAttr " + node + "." + plug_and_value();
      case 11:
        return "resetAttr " + node + "." +
               one_of({"weight", "axis", "key", "points", "a", "translate", "weights"});
      case 12:
        return "addAttr " + node + " " + one_of({"extra", "more", "glow"}) +
               one_of({"", " -type colour", " -min 0 -max 1"});
      case 13:
        return std::string("lockAttr ") + (pick(2) ? "-off " : "") + node + "." +
               one_of({"weight", "a", "key", "extra"});
      case 14:
      case 15:
      case 16:
        return "connectAttr " + node + "." + one_of({"out", "vector", "vector.x", "weight", "tint.g", "a"}) +
               " " + other + "." +
               one_of({"a", "b", "weights", "weight", "axis", "axis.y", "tint", "translate.x", "size", "in",
                       "points"}) +
               (pick(2) ? " -force" : "");
      case 17:
        return "disconnectAttr " + node + "." + one_of({"a", "b", "weights", "axis", "weight", "points"});
      case 18:
        return "select " + node + one_of({"", " -add", " -remove"});
      case 19:
        return "setKeyframe " + node + "." + one_of({"weight", "a", "translate", "tint", "size"}) +
               " -time " + std::to_string(pick(40)) + one_of({"", " -value 0.5", " -interpolation stepped"});
      case 20:
        return "cutKey " + node + "." + one_of({"weight", "a", "translate", "tint"}) +
               one_of({"", " -time 3 -to 30"});
      case 21:
        return "currentTime " + std::to_string(pick(40));
      case 22:
        return pick(2) ? "undo" : "redo";
      default:
        return "getAttr " + node + "." + one_of({"weight", "out", "key"});
    }
  }

 private:
  unsigned pick(unsigned count) { return random_() % count; }
  std::string one_of(std::initializer_list<const char*> words) {
    return *(words.begin() + pick(unsigned(words.size())));
  }
  std::string any_node(const Graph& graph) {
    const auto nodes = graph.nodes();
    return nodes.empty() ? "none" : nodes[pick(unsigned(nodes.size()))]->name;
  }
  std::string plug_and_value() {
    return one_of({"weight 0.125",
                   "weight 7",
                   "count 12",
                   "flag on",
                   "mode high",
                   "label \"ash \\\"column\\\"\"",
                   "file \"$SHOW/a.vdb\"",
                   "pair 1 2",
                   "axis 0 0 1",
                   "axis.x 4",
                   "four 1 2 3 4",
                   "tint 0.5",
                   "size 35mm",
                   "turn 90deg",
                   "start 12",
                   "target time1",
                   "profile 0:1:linear 1:0,1,0:smooth",
                   "points[3] 0",
                   "points[1] 2.5",
                   "key[2].time 24",
                   "key[2].value -1",
                   "a 3",
                   "b -2",
                   "weights[5] 1",
                   "offset 1 2 3",
                   "translate 1 2 3",
                   "visibility off",
                   "in 2",
                   "extra 0.5",
                   "glow 1 0 0",
                   "weight 0.5",
                   "matrix 1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1",
                   "key[0].interpolation linear",
                   "secret 3"});
  }

  std::mt19937 random_;
};

TEST(RandomCommandsTest, UndoneToTheStartAndRedoneToTheEndTheSceneIsTheSameByteForByte) {
  // The environment asks for longer runs, under a sanitizer for instance.
  const char* wanted = std::getenv("PLINIAN_RANDOM_COMMANDS");
  const int count = wanted ? std::atoi(wanted) : 10000;
  for (const unsigned seed : {1u, 2u}) {
    TestSession s;
    s.run("createNode group -name first");
    s.history().clear();
    const std::string first = write_scene(s.graph());
    RandomCommands commands(seed);
    int refused = 0;
    for (int i = 0; i < count; ++i) {
      const std::string line = commands.next(s.graph());
      // The scene does not grow without bound.
      if (s.graph().size() > 150 && (line.starts_with("createNode") || line.starts_with("duplicate")))
        continue;
      const bool look = i % 50 == 0;
      const std::string before = look ? write_scene(s.graph()) : "";
      const auto selected = s.graph().selection();
      try {
        s.execute(line);
      } catch (const GraphError&) {
        ++refused;
        if (look) {
          ASSERT_EQ(write_scene(s.graph()), before) << line;
        }
        ASSERT_EQ(s.graph().selection(), selected) << line;
      }
    }
    EXPECT_GT(refused, count / 10);
    EXPECT_LT(refused, count * 9 / 10);
    const std::string last = write_scene(s.graph());
    const auto last_selection = s.graph().selection();
    EXPECT_GT(last.size(), 3000u);
    std::size_t undone = 0, redone = 0;
    while (!s.history().undo().empty()) ++undone;
    EXPECT_EQ(write_scene(s.graph()), first);
    while (!s.history().redo().empty()) ++redone;
    EXPECT_EQ(write_scene(s.graph()), last);
    EXPECT_EQ(s.graph().selection(), last_selection);
    EXPECT_EQ(undone, redone);
    EXPECT_GT(undone, std::size_t(count / 10));
    std::printf("seed %u: %d commands, %d refused, %zu steps of undo, %zu bytes\n", seed, count, refused,
                undone, last.size());
  }
}

}  // namespace
}  // namespace plinian::graph
