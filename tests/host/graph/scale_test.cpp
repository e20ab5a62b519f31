// What large graphs cost. The times are printed; what is asserted is what was done, and that cost grows with
// it.
#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>

#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/graph/evaluation/evaluation_scene.h"

namespace plinian::graph {
namespace {

// Processor time of this thread, so that whatever else the machine is busy with does not count.
double seconds(const std::function<void()>& action) {
  const auto now = [] {
    timespec time;
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
  };
  const double begin = now();
  action();
  return now() - begin;
}

// Between two edits of an artist a picture is drawn: nothing of the graph is left in the processor's caches
// then, and the program has no memory to spare. Graphs of all sizes begin so; else what is measured of the
// smaller one is that it fits where the larger one does not.
double seconds_cold(const std::function<void()>& action) {
  static std::vector<char> picture(std::size_t(96) << 20);
  for (std::size_t i = 0; i < picture.size(); i += 64) ++picture[i];
  ::malloc_trim(0);
  return seconds(action);
}

struct Times {
  double create = 1e9, connect = 1e9, edit = 1e9, evaluate = 1e9, save = 1e9, open = 1e9;  // [s]
};

// n0 drives n1 drives n2 ..., or n0 drives all others, which drive one sum.
Times measure(int count, bool fan) {
  Times times;
  EvaluationScene s;
  const NodeTypePtr type = s.registry.get("add");
  std::vector<NodeId> nodes;
  times.create = seconds_cold([&] {
    for (int i = 0; i < count; ++i) nodes.push_back(s.editor.create_node(type));
  });
  const AttributeIndex a = type->schema()->find("a"), b_index = type->schema()->find("b"),
                       more = type->schema()->find("more"), out = type->schema()->find("out");
  const NodeId last = nodes.back();
  times.connect = seconds_cold([&] {
    for (int i = 1; i < count; ++i) {
      if (!fan) s.editor.connect({nodes[std::size_t(i - 1)], out}, {nodes[std::size_t(i)], a});
      if (fan && i + 1 < count) {
        s.editor.connect({nodes[0], out}, {nodes[std::size_t(i)], a});
        s.editor.connect({nodes[std::size_t(i)], out}, {last, more, i});
      }
    }
  });
  // No two nodes are alike: those would share their results.
  double sum = 0.0;
  for (int i = 0; i + 1 < count; ++i) {
    const double b = fan ? i / 1024.0 : 1.0;
    s.editor.set({nodes[std::size_t(i)], b_index}, b);
    sum += fan && i == 0 ? 0.0 : b;
  }
  s.evaluator.evaluate({last, out});
  for (int run = 1; run <= 5; ++run) {
    const auto computes = s.computes(), dirtied = s.evaluator.dirtied();
    times.edit = std::min(times.edit, seconds_cold([&] { s.editor.set({nodes[0], a}, run / 16.0); }));
    EXPECT_EQ(s.evaluator.dirtied() - dirtied, std::uint64_t(count));
    ResultPtr result;
    times.evaluate = std::min(times.evaluate, seconds([&] { result = s.evaluator.evaluate({last, out}); }));
    EXPECT_EQ(result->value, Value(float(fan ? run / 16.0 * (count - 2) + sum : run / 16.0 + sum)));
    EXPECT_EQ(s.computes() - computes, std::uint64_t(count));
  }
  const TemporaryFolder folder;
  const std::string path = folder / "scene.pln";
  for (int run = 0; run < 2; ++run) {
    times.save = std::min(times.save, seconds_cold([&] { save_scene(path, write_scene(s.graph)); }));
    EvaluationScene other;
    times.open =
        std::min(times.open,
                 seconds_cold([&] { read_scene(read_text_file(path), path, other.registry, other.editor); }));
    EXPECT_EQ(other.graph.size(), std::size_t(count));
  }
  return times;
}

// The least of each: what the machine does beside is never less than nothing.
void take_least(Times& times, const Times& other) {
  for (double Times::*time :
       {&Times::create, &Times::connect, &Times::edit, &Times::evaluate, &Times::save, &Times::open})
    times.*time = std::min(times.*time, other.*time);
}

void print(const char* shape, int count, const Times& times) {
  std::printf(
      "%-5s %6d nodes: create %.1f ms, connect %.1f ms, edit %.2f ms, evaluate %.2f ms, save %.1f ms, open "
      "%.1f ms\n",
      shape, count, times.create * 1e3, times.connect * 1e3, times.edit * 1e3, times.evaluate * 1e3,
      times.save * 1e3, times.open * 1e3);
}

class Scale : public ::testing::TestWithParam<bool> {};

TEST_P(Scale, TenTimesTheNodesCostAboutTenTimesTheTime) {
  const char* shape = GetParam() ? "fan" : "chain";
  Times small, large;
  const auto ratios = [&] {
    return std::map<std::string, double>{
        {"create", large.create / small.create},
        {"connect", large.connect / small.connect},
        {"edit and evaluate", (large.edit + large.evaluate) / (small.edit + small.evaluate)},
        {"save", large.save / small.save},
        {"open", large.open / small.open}};
  };
  const auto is_linear = [](const auto& ratio) { return ratio.second <= 12.0; };
  // At least three times, and again while it seems to cost too much: the machine may have been busy.
  for (int round = 0; round < 10; ++round) {
    take_least(small, measure(1000, GetParam()));
    take_least(large, measure(10'000, GetParam()));
    const auto found = ratios();
    if (round >= 2 && std::all_of(found.begin(), found.end(), is_linear)) break;
  }
  print(shape, 1000, small);
  print(shape, 10'000, large);
  for (const auto& [what, ratio] : ratios()) {
    std::printf("  %s: %.1f times\n", what.c_str(), ratio);
#ifndef __SANITIZE_ADDRESS__  // whose own tables cost what they like
    EXPECT_LE(ratio, 12.0) << what;
#endif
  }
  EXPECT_LT(large.edit + large.evaluate, 0.2);  // ten times what it should be, where the machine is slow
}

INSTANTIATE_TEST_SUITE_P(Shapes, Scale, ::testing::Bool(),
                         [](const auto& parameter) { return parameter.param ? "Fan" : "Chain"; });

}  // namespace
}  // namespace plinian::graph
