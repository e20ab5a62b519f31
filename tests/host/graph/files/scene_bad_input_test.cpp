// Damaged scenes cost one clear line and leave the graph as it was.
#include <random>

#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

std::string refusal(const std::string& text) {
  TestScene scene;
  const std::string message = message_of([&] { read_scene(text, "a.pln", scene.registry, scene.editor); });
  EXPECT_EQ(scene.graph.size(), 0u);
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_LT(message.size(), 300u);
  return message;
}

std::string small_scene() {
  TestScene scene;
  const NodeId top = scene.create("group", "top");
  scene.create("shape", "leaf", top);
  scene.create("every", "e");
  scene.create("sum", "s");
  scene.set("e.label", std::string("caf\xc3\xa9 \xff"));
  scene.set("e.key[3].value", 2.0);
  scene.connect("e.weight", "s.weights[2]");
  return write_scene(scene.graph);
}

TEST(SceneBadInput, EachMistakeHasItsLine) {
  EXPECT_EQ(refusal(""), "a.pln: is empty, not a scene");
  EXPECT_EQ(refusal("//Maya ASCII 2026\n"),
            "a.pln: is not a Plinian scene: its first line is '//Maya ASCII 2026'");
  EXPECT_EQ(refusal("plinian scene one\n"),
            "a.pln: is not a Plinian scene: its first line is 'plinian scene one'");
  EXPECT_EQ(refusal("plinian scene 1.0\n  .a 1\nend\n"), "a.pln:2: the line belongs to no node: '  .a 1'");
  EXPECT_EQ(refusal("plinian scene 1.0\nnode sum s\nnode sum s\nend\n"),
            "a.pln:3: the node 's' is there twice");
  EXPECT_EQ(refusal("plinian scene 1.0\nnode sum 2s\nend\n"), "a.pln:2: '2s' cannot name a node");
  EXPECT_EQ(refusal("plinian scene 1.0\nnode sum s\n  rm -rf /\nend\n"),
            "a.pln:3: is no line of a node: '  rm -rf /'");
  EXPECT_EQ(refusal("plinian scene 1.0\nsystem\nend\n"), "a.pln:2: is no line of a scene: 'system'");
  EXPECT_EQ(refusal("plinian scene 1.0\nnode shape a under b\nend\n"), "a.pln:2: there is no node 'b'");
  EXPECT_EQ(refusal("plinian scene 1.0\nnode group a under b\nnode group b under a\nend\n"),
            "a.pln:2: a cannot be under itself: a -> b");
  EXPECT_EQ(refusal("plinian scene 1.0\nnode sum s\n"),
            "a.pln: ends too early, after line 2: the file was cut off");
}

TEST(SceneBadInput, OfALineGivenTwiceTheLastOneCountsAndThatIsSaid) {
  TestScene scene;
  const SceneReport report = read_scene(
      "plinian scene 1.0\nnode every e\n  .weight 0.25\n  .count 7\n  .weight 0.75\n  .weight 1\n"
      "node sum s\n  .a <- e.weight\n  .a 3\n  .weights <- e.weight\n  .weights <- e.count\n"
      "  .a <- e.count\nend\n",
      "a.pln", scene.registry, scene.editor);
  EXPECT_EQ(report.warnings,
            (std::vector<std::string>{
                "a.pln:5: e: .weight is given a second time: this line counts, not line 3",
                "a.pln:6: e: .weight is given a second time: this line counts, not line 5",
                "a.pln:12: s: the source of .a is given a second time: this line counts, not line 8"}));
  EXPECT_EQ(scene.value("e.weight"), Value(1.0f));
  EXPECT_EQ(scene.graph.find("s")->inputs.at(0).source, scene.plug("e.count"));
  EXPECT_EQ(scene.graph.find("s")->inputs.size(), 3u) << "an array takes an element for each";
}

TEST(SceneBadInput, AFileCutAtAnyLineIsRefusedAndSaysSo) {
  const std::string text = small_scene();
  int cuts = 0;
  for (std::size_t end = text.find('\n'); end + 1 < text.size(); end = text.find('\n', end + 1), ++cuts)
    EXPECT_NE(refusal(text.substr(0, end + 1)).find("cut off"), std::string::npos);
  EXPECT_GT(cuts, 30);
  for (std::size_t end = 1; end < text.size() - 5; end += 7) EXPECT_NE(refusal(text.substr(0, end)), "");
}

TEST(SceneBadInput, RandomBytesNeverDoMoreThanCostALine) {
  const std::string text = small_scene();
  std::mt19937 random(3);
  int opened = 0;
  for (int run = 0; run < 3000; ++run) {
    std::string damaged = text;
    for (int i = 0; i < 1 + run % 8; ++i) damaged[random() % damaged.size()] = char(random());
    TestScene scene;
    try {
      read_scene(damaged, "a.pln", scene.registry, scene.editor);
      ++opened;
      EXPECT_GT(write_scene(scene.graph).size(), 0u);
    } catch (const GraphError& error) {
      EXPECT_EQ(scene.graph.size(), 0u);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(opened, 0);
  EXPECT_LT(opened, 3000);
  for (int run = 0; run < 300; ++run) {
    std::string noise(1 + random() % 2000, '\0');
    for (char& c : noise) c = char(random());
    refusal(noise);
    refusal("plinian scene 1.0\nnode every e\n" + noise);
  }
}

TEST(SceneBadInput, AMillionLinesOrAnEndlessOneEndAllTheSame) {
  std::string many = "plinian scene 1.0\nnode every e\n";
  for (int i = 0; i < 1'000'000; ++i) many += "  .weight 0.5\n";
  TestScene scene;
  read_scene(many + "end\n", "a.pln", scene.registry, scene.editor);
  EXPECT_EQ(scene.graph.find("e")->values.size(), 0u);

  std::string deep = "plinian scene 1.0\nnode group g0\n";
  for (int i = 1; i < 200'000; ++i)
    deep += "node group g" + std::to_string(i) + " under g" + std::to_string(i - 1) + "\n";
  TestScene family;
  EXPECT_EQ(read_scene(deep + "end\n", "a.pln", family.registry, family.editor).nodes.size(), 200'000u);
  family.editor.delete_nodes({family.graph.find("g0")->id});
  EXPECT_EQ(family.graph.size(), 0u);

  std::string endless = "plinian scene 1.0\nnode every e\n  .weight ";
  for (int i = 0; i < 1'000'000; ++i) endless += "1 ";
  TestScene other;
  const SceneReport report = read_scene(endless + "\nend\n", "a.pln", other.registry, other.editor);
  EXPECT_EQ(report.warnings.size(), 1u);
  EXPECT_LT(report.warnings[0].size(), 300u);
  refusal("plinian scene 1.0\nnode every " + std::string(1'000'000, ':') + "\nend\n");
  refusal("plinian scene 1.0\n" + std::string(1'000'000, '"') + "\nend\n");
}

}  // namespace
}  // namespace plinian::graph
