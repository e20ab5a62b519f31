// A graph with a few node types to try things on.
#pragma once

#include "host/graph/edits/editor.h"
#include "host/graph/types/type_registry.h"
#include "tests/host/graph/message_of.h"

namespace plinian::graph {

/// "sum": a, b and weights[] to out and double. "group": the hierarchy. "every": an attribute of each type.
/// "follower": deleted with what it drives.
inline void add_test_types(TypeRegistry& registry) {
  const auto nothing = [](ComputeContext&, AttributeIndex) {};
  registry.add({.name = "sum",
                .attributes = {{.name = "a", .affects = {"out"}},
                               {.name = "b", .affects = {"out"}},
                               {.name = "offset", .type = AttributeType::float3},
                               {.name = "weights", .array = true, .affects = {"out"}},
                               {.name = "out", .output = true},
                               {.name = "vector", .type = AttributeType::float3, .output = true}},
                .compute = nothing});
  registry.add({.name = "group",
                .attributes = {{.name = "translate", .type = AttributeType::float3},
                               {.name = "visibility", .type = AttributeType::boolean, .default_value = true}},
                .hierarchical = true,
                .holds_children = true});
  registry.add({.name = "shape", .attributes = {{.name = "size"}}, .hierarchical = true});
  registry.add({.name = "follower",
                .attributes = {{.name = "in", .affects = {"out"}}, {.name = "out", .output = true}},
                .compute = nothing,
                .follows = true});
  registry.add({.name = "every",
                .attributes = {
                    {.name = "flag", .type = AttributeType::boolean},
                    {.name = "count", .type = AttributeType::integer, .minimum = 0, .maximum = 100},
                    {.name = "weight", .default_value = 0.5, .minimum = 0.0, .maximum = 1.0},
                    {.name = "precise", .type = AttributeType::double1},
                    {.name = "mode",
                     .type = AttributeType::choice,
                     .choices = {{0, "off", ""}, {10, "low", ""}, {30, "high", ""}}},
                    {.name = "label", .type = AttributeType::string},
                    {.name = "file", .type = AttributeType::path},
                    {.name = "pair", .type = AttributeType::float2},
                    {.name = "axis", .type = AttributeType::float3, .default_value = vec3(0.0f, 1.0f, 0.0f)},
                    {.name = "four", .type = AttributeType::float4},
                    {.name = "tint", .type = AttributeType::colour, .default_value = vec3(0.8f)},
                    {.name = "matrix", .type = AttributeType::matrix},
                    {.name = "size", .type = AttributeType::distance},
                    {.name = "turn", .type = AttributeType::angle},
                    {.name = "start", .type = AttributeType::time},
                    {.name = "target", .type = AttributeType::node},
                    {.name = "profile", .type = AttributeType::ramp},
                    {.name = "volume", .type = AttributeType::data, .data_type = "volume"},
                    {.name = "secret", .type = AttributeType::integer, .read_only = true},
                    {.name = "points", .array = true},
                    {.name = "key",
                     .type = AttributeType::compound,
                     .array = true,
                     .children = {{.name = "time", .type = AttributeType::time}, {.name = "value"}}}}});
}

struct TestScene {
  TypeRegistry registry;
  Graph graph;
  History history{graph};
  Editor editor{graph, history};

  TestScene() { add_test_types(registry); }
  NodeId create(const std::string& type, const std::string& name, NodeId parent = {}) {
    return editor.create_node(registry.get(type), name, parent);
  }
  Plug plug(std::string_view name) const { return graph.plug(name); }
  Value value(std::string_view name) const {
    const Plug plug = graph.plug(name);
    return graph.find(plug.node)->value(plug.attribute, plug.element);
  }
  void set(std::string_view name, const Value& value) { editor.set(plug(name), value); }
  void connect(std::string_view source, std::string_view destination) {
    editor.connect(plug(source), plug(destination));
  }
};

}  // namespace plinian::graph
