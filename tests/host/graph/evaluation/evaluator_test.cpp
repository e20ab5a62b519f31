#include "host/graph/evaluation/evaluator.h"

#include "tests/host/graph/evaluation/evaluation_scene.h"

namespace plinian::graph {
namespace {

TEST(Evaluator, ComputesWhatIsAskedForAndNothingElse) {
  EvaluationScene s;
  for (const char* name : {"x", "y", "z"}) s.create("add", name);
  s.set("x.a", 1.0);
  s.connect("x.out", "y.a");
  s.connect("x.out", "y.more[4]");
  s.connect("x.out", "z.a");
  EXPECT_EQ(s.get("y.out"), Value(2.0f));
  EXPECT_EQ(s.computes(), 2u);
  EXPECT_TRUE(s.evaluator.is_dirty(s.plug("z.out")));
  s.get("y.out");
  EXPECT_EQ(s.computes(), 2u);
}

TEST(Evaluator, AnEqualValueRunsNothingAndAnEditOnlyWhatItAffects) {
  EvaluationScene s;
  for (const char* name : {"x", "y", "z"}) s.create("add", name);
  s.connect("x.out", "z.a");
  s.connect("y.out", "z.b");
  s.get("z.out");
  EXPECT_EQ(s.computes(), 2u);  // x and y are alike, and share their result
  s.set("x.a", 0.0);
  EXPECT_FALSE(s.evaluator.is_dirty(s.plug("z.out")));
  s.set("x.a", 5.0);
  EXPECT_TRUE(s.evaluator.is_dirty(s.plug("z.out")));
  EXPECT_FALSE(s.evaluator.is_dirty(s.plug("y.out")));
  EXPECT_EQ(s.get("z.out"), Value(5.0f));
  EXPECT_EQ(s.computes(), 4u);
  s.history.undo();  // back to what is known already
  EXPECT_EQ(s.get("z.out"), Value(0.0f));
  EXPECT_EQ(s.computes(), 4u);
}

TEST(Evaluator, AValueThatComesOutTheSameStopsTheRipple) {
  EvaluationScene s;
  for (const char* name : {"x", "y"}) s.create("add", name);
  s.connect("x.out", "y.a");
  s.set("x.a", 2.0);
  s.get("y.out");
  {
    const History::Scope scope(s.history, "swap");
    s.set("x.a", 0.5);
    s.set("x.b", 1.5);
  }
  s.get("y.out");
  EXPECT_EQ(s.computes(), 3u);  // x again, y not
}

TEST(Evaluator, VectorsAreTakenApartAndPutTogether) {
  EvaluationScene s;
  s.create("vector", "v");
  s.create("box", "b");
  s.set("v.x", 2.0);
  s.set("b.translate", vec3(7.0f, 8.0f, 9.0f));
  s.connect("v.out.z", "b.translate.x");
  s.connect("v.twice", "b.translate.y");
  EXPECT_EQ(s.get("b.out"), Value(vec3(6.0f, 4.0f, 9.0f)));
  EXPECT_EQ(s.get("b.translate"), Value(vec3(6.0f, 4.0f, 9.0f)));
  EXPECT_EQ(s.get("b.out.y"), Value(4.0f));
  EXPECT_EQ(s.computes("vector"), 1u);  // both outputs came of one run
}

TEST(Evaluator, InputsPassOnWhatDrivesThem) {
  EvaluationScene s;
  for (const char* name : {"x", "y", "z"}) s.create("add", name);
  s.set("x.a", 3.0);
  s.connect("x.a", "y.a");
  s.connect("y.a", "z.b");
  EXPECT_EQ(s.get("z.out"), Value(3.0f));
  s.set("x.a", 4.0);
  EXPECT_EQ(s.get("z.out"), Value(4.0f));
}

TEST(Evaluator, AFrameChangeRunsOnlyWhatDependsOnTime) {
  EvaluationScene s;
  s.create("time", "time1");
  for (const char* name : {"moving", "still", "both"}) s.create("add", name);
  s.connect("time1.out", "moving.a");
  s.connect("moving.out", "both.a");
  s.connect("still.out", "both.b");
  s.set("still.a", 100.0);
  s.evaluator.set_time(5.0);
  EXPECT_EQ(s.get("both.out"), Value(105.0f));
  const auto before = s.computes("add");
  s.evaluator.set_time(6.0);
  EXPECT_FALSE(s.evaluator.is_dirty(s.plug("still.out")));
  EXPECT_EQ(s.get("both.out"), Value(106.0f));
  EXPECT_EQ(s.computes("add"), before + 2);
  const auto all = s.computes();
  s.evaluator.set_time(5.0);  // scrubbing back is free
  EXPECT_EQ(s.get("both.out"), Value(105.0f));
  EXPECT_EQ(s.computes(), all);
}

TEST(Evaluator, AnInputCanBeReadAtAnotherTime) {
  EvaluationScene s;
  s.create("time", "time1");
  s.create("animCurve", "curve");
  s.create("delay", "d");
  s.connect("time1.out", "curve.in");
  s.connect("time1.out", "d.now");
  s.connect("curve.out", "d.in");
  const auto key = [&](int element, double time, double value) {
    s.set("curve.key[" + std::to_string(element) + "].time", time);
    s.set("curve.key[" + std::to_string(element) + "].value", value);
    s.set("curve.key[" + std::to_string(element) + "].interpolation", 1);
  };
  key(0, 0.0, 0.0);
  key(1, 10.0, 100.0);
  s.evaluator.set_time(7.0);
  EXPECT_EQ(s.get("d.out"), Value(50.0f));
  EXPECT_EQ(s.get("curve.out"), Value(70.0));
  // The value now stays what it is, the one two frames ago does not: what was remembered no longer holds.
  key(2, 7.0, 70.0);
  key(3, 5.0, 1.0);
  EXPECT_EQ(s.get("curve.out"), Value(70.0));
  EXPECT_EQ(s.get("d.out"), Value(1.0f));
  EXPECT_EQ(s.evaluator.evaluate_at(9.0, s.plug("curve.out"))->value, Value(90.0));
  EXPECT_EQ(s.get("curve.out"), Value(70.0));
}

TEST(Evaluator, AFailureBlocksWhatIsDownstreamAndIsReportedOnce) {
  EvaluationScene s;
  s.create("fail", "f");
  for (const char* name : {"x", "y", "z"}) s.create("add", name);
  s.connect("f.out", "x.a");
  s.connect("f.out", "y.a");
  s.connect("x.out", "z.a");
  s.connect("y.out", "z.b");
  EXPECT_EQ(s.error("z.out"), "blocked by f.out: no such file");
  EXPECT_EQ(s.error("f.out"), "no such file");
  EXPECT_EQ(s.computes(), 1u);
  EXPECT_EQ(s.evaluator.take_reports(), std::vector<std::string>{"f.out: no such file"});
  s.set("f.a", 2.0);  // fails again in the same way: nothing new
  s.error("z.out");
  EXPECT_TRUE(s.evaluator.take_reports().empty());
  s.set("f.broken", false);
  EXPECT_EQ(s.get("z.out"), Value(4.0f));
  s.set("f.broken", true);
  s.error("z.out");
  EXPECT_EQ(s.evaluator.take_reports().size(), 1u);
  EXPECT_EQ(s.evaluator.last_good(s.plug("z.out"))->value, Value(4.0f));  // the last good picture
}

TEST(Evaluator, AValueThatADestinationCannotHoldIsAnErrorThere) {
  EvaluationScene s;
  s.registry.add({.name = "choose",
                  .attributes = {{.name = "mode",
                                  .type = AttributeType::choice,
                                  .choices = {{0, "off", ""}, {10, "on", ""}},
                                  .affects = {"out"}},
                                 {.name = "out", .output = true}},
                  .compute = [](ComputeContext& context, AttributeIndex out) {
                    context.set_output(out, context.integer(0));
                  }});
  s.create("add", "x");
  s.create("choose", "c");
  s.connect("x.out", "c.mode");
  s.set("x.a", 10.0);
  EXPECT_EQ(s.get("c.out"), Value(10.0f));
  s.set("x.a", 4.0);
  EXPECT_NE(s.error("c.out").find("4 is none of off (0), on (10)"), std::string::npos) << s.error("c.out");
}

TEST(Evaluator, WhatLeftTheCacheIsComputedAgainOnlyWhereItsValueIsNeeded) {
  EvaluationScene s;
  s.create("time", "time1");
  s.create("blob", "b");
  s.create("size", "n");
  s.connect("time1.out", "b.frame");
  s.connect("b.out", "n.in");
  s.set("b.bytes", 700'000);  // the cache holds one of them
  s.set("n.scale", 1.0);
  for (const double frame : {1.0, 2.0, 1.0, 2.0}) {
    s.evaluator.set_time(frame);
    EXPECT_EQ(s.get("n.out"), Value(700'000.0f));
  }
  EXPECT_EQ(s.computes("blob"), 2u);
  s.set("n.scale", 2.0);
  s.get("n.out");
  EXPECT_EQ(s.computes("blob"), 2u);  // the current one is still held
  s.evaluator.set_time(1.0);
  EXPECT_EQ(s.get("n.out"), Value(1'400'000.0f));
  EXPECT_EQ(s.computes("blob"), 3u);
}

TEST(Evaluator, DeletedAndRestoredNodesAreEvaluatedAnew) {
  EvaluationScene s;
  const NodeId x = s.create("add", "x");
  s.create("add", "y");
  s.connect("x.out", "y.a");
  s.set("x.a", 3.0);
  EXPECT_EQ(s.get("y.out"), Value(3.0f));
  s.editor.delete_nodes({x});
  EXPECT_EQ(s.get("y.out"), Value(0.0f));
  s.history.undo();
  EXPECT_EQ(s.get("y.out"), Value(3.0f));
}

}  // namespace
}  // namespace plinian::graph
