// Node types that compute, for tests of evaluation.
#pragma once

#include <thread>

#include "host/graph/evaluation/compute_context.h"
#include "host/graph/evaluation/evaluator.h"
#include "host/nodes/built_in.h"
#include "tests/host/graph/test_scene.h"

namespace plinian::graph {

/// "add": out = a + b + sum of more[]. "fail": throws while `broken` is on. "blob": data of `bytes`. "delay":
/// its input two frames ago. "wait": returns when it is cancelled or `released` is set. "liar": reads b,
/// which does not affect its output. "vector": out = (x, 2 x, 3 x).
struct EvaluationScene : TestScene {
  sdk::PluginRegistrar built_in;
  std::atomic<bool> released{false}, started{false};
  std::atomic<int> running{0}, most_running{0};

  EvaluationScene() {
    nodes::built_in_plugin().initialise(&built_in.host());
    for (NodeTypeSpec& spec : built_in.node_types)
      if (spec.name == "time" || spec.name == "animCurve") registry.add(spec);
    const auto number = [](const char* name) { return AttributeSpec{.name = name, .affects = {"out"}}; };
    const AttributeSpec out = {.name = "out", .output = true};
    registry.add(
        {.name = "add",
         .attributes = {number("a"), number("b"), {.name = "more", .array = true, .affects = {"out"}}, out},
         .compute = [](ComputeContext& context, AttributeIndex output) {
           double sum = context.number(0) + context.number(1);
           for (const std::int32_t element : context.elements(2)) sum += context.number(2, element);
           context.set_output(output, sum);
         }});
    registry.add(
        {.name = "fail",
         .attributes =
             {number("a"),
              {.name = "broken", .type = AttributeType::boolean, .default_value = true, .affects = {"out"}},
              out},
         .compute = [](ComputeContext& context, AttributeIndex output) {
           if (context.boolean(1)) throw std::runtime_error("no such\nfile");
           context.set_output(output, context.number(0));
         }});
    registry.add(
        {.name = "blob",
         .attributes = {{.name = "bytes", .type = AttributeType::integer, .affects = {"out"}},
                        {.name = "frame", .type = AttributeType::time, .affects = {"out"}},
                        {.name = "out", .type = AttributeType::data, .data_type = "blob", .output = true}},
         .compute = [](ComputeContext& context, AttributeIndex output) {
           context.set_output(output, std::make_shared<const Data>(
                                          Data{"blob", nullptr, std::size_t(context.integer(0)), 0}));
         }});
    registry.add(
        {.name = "size",
         .attributes = {{.name = "in", .type = AttributeType::data, .data_type = "blob", .affects = {"out"}},
                        number("scale"),
                        out},
         .compute = [](ComputeContext& context, AttributeIndex output) {
           const auto& data = std::get<DataPtr>(context.input(0));
           context.set_output(output, double(data->bytes) * context.number(1));
         }});
    registry.add(
        {.name = "delay",
         .attributes = {number("in"), {.name = "now", .type = AttributeType::time, .affects = {"out"}}, out},
         .compute = [](ComputeContext& context, AttributeIndex output) {
           context.set_output(output, context.input_at(context.number(1) - 2.0, 0));
         }});
    registry.add({.name = "wait",
                  .attributes = {number("a"), out},
                  .compute = [this](ComputeContext& context, AttributeIndex output) {
                    started = true;
                    context.progress(0.5, "waiting");
                    while (!released && !context.cancelled()) std::this_thread::yield();
                    context.set_output(output, context.number(0) * 10.0);
                  }});
    registry.add({.name = "alone",
                  .attributes = {number("a"), out},
                  .compute =
                      [this](ComputeContext& context, AttributeIndex output) {
                        const int now = ++running;
                        for (int most = most_running;
                             now > most && !most_running.compare_exchange_weak(most, now);) {
                        }
                        std::this_thread::sleep_for(std::chrono::milliseconds(2));
                        --running;
                        context.set_output(output, context.number(0));
                      },
                  .concurrent = false});
    registry.add({.name = "liar",
                  .attributes = {number("a"), {.name = "b"}, out},
                  .compute = [](ComputeContext& context, AttributeIndex output) {
                    context.set_output(output, context.number(0) + context.number(1));
                  }});
    registry.add({.name = "vector",
                  .attributes = {{.name = "x", .affects = {"out", "twice"}},
                                 {.name = "out", .type = AttributeType::float3, .output = true},
                                 {.name = "twice", .output = true}},
                  .compute = [](ComputeContext& context, AttributeIndex) {
                    const float x = float(context.number(0));
                    context.set_output(1, vec3(x, 2.0f * x, 3.0f * x));
                    context.set_output(2, 2.0f * x);
                  }});
    registry.add({.name = "box",
                  .attributes = {{.name = "translate", .type = AttributeType::float3, .affects = {"out"}},
                                 {.name = "out", .type = AttributeType::float3, .output = true}},
                  .compute = [](ComputeContext& context, AttributeIndex output) {
                    context.set_output(output, context.vector(0));
                  }});
  }

  Evaluator evaluator{graph, {.cache_bytes = 1 << 20, .workers = 2}};

  Value get(std::string_view name) {
    const ResultPtr result = evaluator.evaluate(plug(name));
    EXPECT_EQ(result->error, nullptr) << result->error->message;
    return result->value;
  }
  std::string error(std::string_view name) {
    return evaluator.error_text(plug(name), *evaluator.evaluate(plug(name)));
  }
  std::uint64_t computes() const { return evaluator.counters().computes; }
  std::uint64_t computes(const std::string& type) const {
    const auto& counts = evaluator.counters().computes_of_type;
    const auto found = counts.find(type);
    return found == counts.end() ? 0 : found->second;
  }
};

}  // namespace plinian::graph
