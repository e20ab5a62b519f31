#include "tests/host/graph/evaluation/evaluation_scene.h"

namespace plinian::graph {
namespace {

TEST(Checking, ExposesAnInputThatIsReadWithoutBeingDeclared) {
  EvaluationScene s;
  s.create("liar", "l");
  s.create("add", "x");
  s.connect("l.out", "x.a");
  s.set("l.a", 1.0);
  s.get("x.out");
  EXPECT_EQ(s.evaluator.check(s.plug("x.out")),
            std::vector<std::string>{"l.out: its computation reads 'b', which is not declared to affect it"});
  s.set("l.b", 5.0);
  EXPECT_EQ(s.get("x.out"), Value(1.0f));  // wrong, and nobody would know
  EXPECT_EQ(
      s.evaluator.check(s.plug("x.out")),
      std::vector<std::string>{
          "l.out: computed anew it differs; its computation reads 'b', which is not declared to affect it"});
}

TEST(Checking, EveryEvaluationTellsOfAnUndeclaredReadOnceForTheType) {
  EvaluationScene s;
  std::vector<std::string> warnings;
  s.evaluator.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  s.create("liar", "l");
  s.create("liar", "m");
  s.create("add", "x");
  s.connect("l.out", "x.a");
  s.connect("m.out", "x.b");
  for (int i = 0; i < 3; ++i) {
    s.set("l.a", double(i));
    s.get("x.out");
  }
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(
      warnings[0].substr(1),
      ".out: its computation reads 'b', which is not declared to affect it: a change of it goes unseen");
  warnings.clear();
  s.evaluator.forget();  // the type may have come back as another
  s.set("l.a", 9.0);
  s.evaluator.request({s.plug("x.out")}, nullptr);
  s.evaluator.finish();
  EXPECT_EQ(warnings.size(), 1u) << "on workers as well";
}

TEST(Checking, ExposesAComputationThatDependsOnSomethingElse) {
  EvaluationScene s;
  int secret = 1;
  s.registry.add(
      {.name = "moody",
       .attributes = {{.name = "a", .affects = {"out"}}, {.name = "out", .output = true}},
       .compute = [&](ComputeContext& context, AttributeIndex out) { context.set_output(out, secret); }});
  s.create("moody", "m");
  s.get("m.out");
  EXPECT_TRUE(s.evaluator.check(s.plug("m.out")).empty());
  secret = 2;
  EXPECT_EQ(s.evaluator.check(s.plug("m.out")),
            std::vector<std::string>{"m.out: computed anew it differs although no input did: its computation "
                                     "depends on something else"});
}

TEST(Checking, FindsNothingWhereAllIsWell) {
  EvaluationScene s;
  s.create("time", "time1");
  s.create("animCurve", "c");
  s.create("delay", "d");
  s.connect("time1.out", "c.in");
  s.connect("time1.out", "d.now");
  s.connect("c.out", "d.in");
  s.set("c.key[0].value", 3.0);
  EXPECT_TRUE(s.evaluator.check(s.plug("d.out")).empty());
}

TEST(Checking, WritingWhatIsNoOutputIsAnError) {
  EvaluationScene s;
  s.registry.add({.name = "writer",
                  .attributes = {{.name = "a", .affects = {"out"}}, {.name = "out", .output = true}},
                  .compute = [](ComputeContext& context, AttributeIndex) { context.set_output(0, 1.0); }});
  s.registry.add({.name = "idle",
                  .attributes = {{.name = "a", .affects = {"out"}}, {.name = "out", .output = true}},
                  .compute = [](ComputeContext&, AttributeIndex) {}});
  s.create("writer", "w");
  s.create("idle", "i");
  EXPECT_EQ(s.error("w.out"), "writes 'a', which is no output");
  EXPECT_EQ(s.error("i.out"), "computed nothing for 'out'");
}

}  // namespace
}  // namespace plinian::graph
