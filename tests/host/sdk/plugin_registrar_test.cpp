// The tables as a plug-in sees them that was built with another version of the interface.
#include "host/sdk/plugin_registrar.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace plinian::sdk {
namespace {

TEST(PluginRegistrar, TakesWhatAnOlderShorterStructureLacksForNothing) {
  PluginRegistrar registrar;
  const PlinianHost& host = registrar.host();
  // An older attribute ended before its flags; what stands behind it in memory is somebody else's.
  PlinianAttribute attribute{};
  attribute.size = offsetof(PlinianAttribute, flags);
  attribute.name = "a";
  attribute.type = "int";
  attribute.default_value = "7";
  attribute.flags = ~0u;
  attribute.children = reinterpret_cast<const PlinianAttribute*>(1);
  attribute.child_count = 99;
  PlinianNodeType type{};
  type.size = offsetof(PlinianNodeType, aliases);
  type.name = "old";
  type.version = 1;
  type.attributes = &attribute;
  type.attribute_count = 1;
  type.aliases = reinterpret_cast<const char*>(1);
  type.compute = reinterpret_cast<decltype(type.compute)>(1);
  ASSERT_EQ(host.register_node_type(host.self, &type), 1) << registrar.error;
  const graph::NodeTypeSpec& spec = registrar.node_types.at(0);
  EXPECT_FALSE(spec.attributes.at(0).array);
  EXPECT_TRUE(spec.attributes.at(0).children.empty());
  EXPECT_EQ(spec.attributes.at(0).default_value, graph::Value(7));
  EXPECT_TRUE(spec.aliases.empty());
  EXPECT_FALSE(spec.compute);
}

TEST(PluginRegistrar, StepsOverWhatANewerLongerStructureHasMore) {
  struct Longer {
    PlinianAttribute known{};
    double unknown = 1.0;
  } attributes[2];
  for (int i = 0; i < 2; ++i) {
    attributes[i].known.size = sizeof(Longer);
    attributes[i].known.name = i ? "second" : "first";
    attributes[i].known.type = "float";
  }
  PlinianNodeType type{};
  type.size = sizeof(type);
  type.name = "new";
  type.version = 1;
  type.attributes = &attributes[0].known;
  type.attribute_count = 2;
  PluginRegistrar registrar;
  ASSERT_EQ(registrar.host().register_node_type(registrar.host().self, &type), 1) << registrar.error;
  EXPECT_EQ(registrar.node_types.at(0).attributes.at(1).name, "second");
}

TEST(PluginRegistrar, RemembersTheFirstThingThatFails) {
  PluginRegistrar registrar;
  const PlinianHost& host = registrar.host();
  PlinianAttribute attribute{};
  attribute.size = sizeof(attribute);
  attribute.name = "a";
  attribute.type = "flaot";
  PlinianNodeType type{};
  type.size = sizeof(type);
  type.name = "t";
  type.attributes = &attribute;
  type.attribute_count = 1;
  EXPECT_EQ(host.register_node_type(host.self, &type), 0);
  PlinianCommand command{};
  command.size = sizeof(command);
  command.name = "c";
  EXPECT_EQ(host.register_command(host.self, &command), 0);
  EXPECT_EQ(registrar.error, "unknown attribute type 'flaot' (did you mean 'float'?)");
  EXPECT_TRUE(registrar.node_types.empty() && registrar.commands.empty());
}

}  // namespace
}  // namespace plinian::sdk
