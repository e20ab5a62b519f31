#include "host/graph/model/cycles.h"

#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

TEST(Cycles, AreRefusedWithThePathSpelledOut) {
  TestScene scene;
  for (const char* name : {"x", "y", "z"}) scene.create("sum", name);
  scene.connect("x.out", "y.a");
  scene.connect("y.out", "z.weights[2]");
  EXPECT_EQ(
      message_of([&] { scene.connect("z.out", "x.b"); }),
      "cannot connect z.out to x.b: it would close the cycle x.b -> x.out -> y.a -> y.out -> z.weights[2] -> "
      "z.out -> x.b");
  EXPECT_EQ(message_of([&] { scene.connect("x.out", "x.a"); }),
            "cannot connect x.out to x.a: it would close the cycle x.a -> x.out -> x.a");
  // An input that affects nothing closes nothing.
  scene.connect("z.out", "x.offset.x");
  // Through an input that is passed on.
  EXPECT_EQ(message_of([&] { scene.connect("x.a", "x.a"); }),
            "cannot connect x.a to x.a: it would close the cycle x.a -> x.a");
  scene.connect("x.a", "x.b");
  EXPECT_NE(message_of([&] { scene.connect("x.b", "x.a"); }).find("x.a -> x.b -> x.a"), std::string::npos);
}

TEST(Cycles, ALongPathIsToldByItsEnds) {
  TestScene scene;
  scene.create("sum", "n0");
  for (int i = 1; i < 20; ++i) {
    scene.create("sum", "n" + std::to_string(i));
    scene.connect("n" + std::to_string(i - 1) + ".out", "n" + std::to_string(i) + ".a");
  }
  const std::string message = message_of([&] { scene.connect("n19.out", "n0.a"); });
  EXPECT_NE(
      message.find("n0.a -> n0.out -> n1.a -> n1.out -> (32 more) -> n18.a -> n18.out -> n19.a -> n19.out"),
      std::string::npos)
      << message;
}

}  // namespace
}  // namespace plinian::graph
