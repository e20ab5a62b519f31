// Values that something slow drives are shown when they are there; nobody waits for them.
#include "host/window/fields/driven_values.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "host/graph/evaluation/compute_context.h"
#include "host/scene/workspace.h"

namespace plinian::window {
namespace {

class DrivenNumbers : public testing::Test {
 protected:
  DrivenNumbers() {
    session().types().add(
        {.name = "slow",
         .attributes = {{.name = "in", .affects = {"out"}}, {.name = "out", .output = true}},
         .compute = [this](graph::ComputeContext& context, graph::AttributeIndex out) {
           while (!may_end && !context.cancelled()) std::this_thread::yield();
           context.set_output(out, 2.0 * context.number(0));
         }});
    for (const char* line : {"createNode slow -name s", "setAttr s.in 3", "createNode transform -name t",
                             "connectAttr s.out t.translate.x"})
      session().execute(line);
  }
  graph::Session& session() { return workspace_.session(); }
  double number(const char* plug) { return values.number(session(), session().graph().plug(plug)); }

  std::atomic<bool> may_end{false};
  DrivenValues values;

 private:
  scene::Workspace workspace_;
};

TEST_F(DrivenNumbers, OfWhatIsSlowAreComputedBesideAndTheLastOneIsShown) {
  EXPECT_EQ(number("t.translate.x"), 0.0) << "at once, although it is not known";
  EXPECT_EQ(number("t.translate.x"), 0.0) << "and asked for once";
  EXPECT_TRUE(values.is_waiting());
  EXPECT_FALSE(values.take_news());
  may_end = true;
  session().evaluator().finish();
  EXPECT_FALSE(values.is_waiting());
  EXPECT_TRUE(values.take_news());
  EXPECT_EQ(number("t.translate.x"), 6.0);
  EXPECT_FALSE(values.is_waiting());
  may_end = false;
  session().execute("setAttr s.in 5");
  EXPECT_EQ(number("t.translate.x"), 6.0) << "the last one stays up";
  may_end = true;
  session().evaluator().finish();
  EXPECT_EQ(number("t.translate.x"), 10.0);
}

TEST_F(DrivenNumbers, OfKeysAreThereAtOnce) {
  session().execute("setKeyframe t.rotate.y -time 1 -value 0 -interpolation linear");
  session().execute("setKeyframe t.rotate.y -time 11 -value 10");
  session().execute("currentTime 4");
  EXPECT_EQ(number("t.rotate.y"), 3.0);
  EXPECT_FALSE(values.is_waiting());
}

}  // namespace
}  // namespace plinian::window
