#include <random>

#include "tests/host/graph/evaluation/evaluation_scene.h"

namespace plinian::graph {
namespace {

using Outcome = Evaluator::Outcome;

TEST(Requests, AreEvaluatedOnWorkersAndTakenOverByPoll) {
  EvaluationScene s;
  s.create("wait", "w");
  s.create("add", "x");
  s.connect("w.out", "x.a");
  s.set("w.a", 2.0);
  Value got;
  s.evaluator.request({s.plug("x.out")}, [&](const Outcome& outcome) { got = outcome.results.at(0)->value; });
  while (!s.started) std::this_thread::yield();
  EXPECT_EQ(s.evaluator.poll(), 0u);
  EXPECT_EQ(s.evaluator.progress().at(0).what, "waiting");
  EXPECT_TRUE(s.evaluator.is_dirty(s.plug("x.out")));
  s.released = true;
  s.evaluator.finish();
  EXPECT_EQ(got, Value(20.0f));
  EXPECT_FALSE(s.evaluator.is_dirty(s.plug("w.out")));
  EXPECT_EQ(s.get("x.out"), Value(20.0f));
  EXPECT_EQ(s.computes(), 2u);
}

TEST(Requests, AnEditUpstreamCancelsWithoutWaiting) {
  EvaluationScene s;
  for (const char* name : {"u", "x"}) s.create("add", name);
  s.create("wait", "w");
  s.connect("u.out", "w.a");
  s.connect("w.out", "x.a");
  bool cancelled = false;
  s.evaluator.request({s.plug("x.out")}, [&](const Outcome& outcome) { cancelled = outcome.cancelled; });
  while (!s.started) std::this_thread::yield();
  s.set("u.a", 3.0);  // returns at once; the computation hears of it
  s.evaluator.finish();
  EXPECT_TRUE(cancelled);
  EXPECT_TRUE(s.evaluator.is_dirty(s.plug("x.out")));
  s.released = true;
  EXPECT_EQ(s.get("x.out"), Value(30.0f));
}

TEST(Requests, AnEditElsewhereLeavesThemAlone) {
  EvaluationScene s;
  s.create("wait", "w");
  s.create("add", "x");
  bool cancelled = true;
  s.evaluator.request({s.plug("w.out")}, [&](const Outcome& outcome) { cancelled = outcome.cancelled; });
  while (!s.started) std::this_thread::yield();
  s.set("x.a", 3.0);
  s.released = true;
  s.evaluator.finish();
  EXPECT_FALSE(cancelled);
}

// What left the cache is computed again when somebody needs it, and may fail by then.
TEST(Requests, AValueThatDoesNotComeBackIsAFailureOfItsNode) {
  EvaluationScene s;
  std::atomic<bool> gone{false};
  s.registry.add(
      {.name = "file",
       .attributes = {{.name = "frame", .affects = {"out"}},
                      {.name = "out", .type = AttributeType::data, .data_type = "blob", .output = true}},
       .compute = [&](ComputeContext& context, AttributeIndex output) {
         if (gone) throw std::runtime_error("the file is gone");
         context.set_output(output, std::make_shared<const Data>(Data{"blob", nullptr, 1000, 0}));
       }});
  s.create("file", "f");
  s.create("size", "n");
  s.connect("f.out", "n.in");
  for (const double frame : {1.0, 2.0}) {
    s.set("f.frame", frame);
    s.get("n.out");
  }
  s.evaluator.cache().set_budget(0);
  s.set("f.frame", 1.0);
  s.get("n.out");  // is remembered, what it was made of is not
  const ResultPtr known = s.evaluator.known(s.plug("f.out"));
  ASSERT_TRUE(known);
  ASSERT_FALSE(known->has_value);
  ASSERT_FALSE(known->error);
  gone = true;
  s.set("n.scale", 3.0);
  EXPECT_FALSE(s.evaluator.known(s.plug("n.out"))) << "dirty";
  s.evaluator.request({s.plug("n.out")}, [](const Outcome&) {});
  s.evaluator.finish();
  const ResultPtr failed = s.evaluator.known(s.plug("f.out"));
  ASSERT_TRUE(failed && failed->error);
  EXPECT_EQ(s.evaluator.error_text(s.plug("f.out"), *failed), "the file is gone");
  EXPECT_EQ(s.evaluator.take_reports().size(), 1u);
}

TEST(Requests, DeletingWhatTheyComputeCancelsThem) {
  EvaluationScene s;
  const NodeId w = s.create("wait", "w");
  bool cancelled = false;
  s.evaluator.request({s.plug("w.out")}, [&](const Outcome& outcome) { cancelled = outcome.cancelled; });
  while (!s.started) std::this_thread::yield();
  s.editor.delete_nodes({w});
  s.evaluator.finish();
  EXPECT_TRUE(cancelled);
  s.history.undo();
  EXPECT_TRUE(s.evaluator.is_dirty(s.plug("w.out")));
}

TEST(Requests, ATypeThatMayNotRunConcurrentlyDoesNot) {
  EvaluationScene s;
  std::vector<Plug> plugs;
  for (int i = 0; i < 16; ++i) {
    s.create("alone", "n" + std::to_string(i));
    s.set("n" + std::to_string(i) + ".a", double(i));
    s.evaluator.request({s.plug("n" + std::to_string(i) + ".out")}, nullptr);
  }
  s.evaluator.finish();
  EXPECT_EQ(s.most_running, 1);
  EXPECT_EQ(s.computes("alone"), 16u);
}

// Whatever is edited while workers compute, what is asked for in the end is right.
TEST(Requests, RandomEditsNeverLeaveAStaleResult) {
  EvaluationScene s;
  constexpr int count = 40;
  std::mt19937 random(17);
  const auto name = [](int i) { return "n" + std::to_string(i); };
  for (int i = 0; i < count; ++i) {
    s.create("add", name(i));
    if (i > 0) s.connect(name(int(random() % unsigned(i))) + ".out", name(i) + ".a");
    if (i > 1) s.connect(name(int(random() % unsigned(i))) + ".out", name(i) + ".more[0]");
  }
  int ended = 0, asked = 0;
  for (int step = 0; step < 3000; ++step) {
    const int i = int(random() % count);
    switch (random() % 4) {
      case 0:
        s.set(name(i) + ".b", double(random() % 5));
        break;
      case 1:
        s.evaluator.request({s.plug(name(i) + ".out"), s.plug(name(count - 1) + ".out")},
                            [&](const Outcome&) { ++ended; });
        ++asked;
        break;
      case 2:
        s.evaluator.poll();
        break;
      default:
        s.evaluator.evaluate(s.plug(name(i) + ".out"));
    }
    if (step % 100 == 0) {
      EXPECT_TRUE(s.evaluator.check(s.plug(name(count - 1) + ".out")).empty());
    }
  }
  s.evaluator.finish();
  EXPECT_EQ(ended, asked);
  for (int i = 0; i < count; ++i) EXPECT_TRUE(s.evaluator.check(s.plug(name(i) + ".out")).empty());
}

}  // namespace
}  // namespace plinian::graph
