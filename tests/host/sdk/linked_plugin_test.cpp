// Plug-ins that are compiled into the program.
#include "host/graph/files/scene_writer.h"
#include "tests/host/sdk/plugin_session.h"

extern const PlinianLinkedPlugin linked_one, linked_two;

namespace plinian::sdk {
namespace {

TEST(LinkedPlugin, SeveralLiveInOneProgramAndScenesDoNotAskForThem) {
  PluginSession s;
  EXPECT_EQ(s.plugins.add_linked(linked_one), "linked_one");
  EXPECT_EQ(s.plugins.add_linked(linked_two), "linked_two");
  EXPECT_EQ(s.run("createNode wobble_one -name a\ncreateNode wobble_two -name b\nsetAttr b.amount 3\n"
                  "getAttr a.out\ngetAttr b.out"),
            "a\nb\n2\n6");
  EXPECT_EQ(write_scene(s.session.graph()).find("requires"), std::string::npos);
  EXPECT_NE(s.run("pluginInfo linked_one").find("linked_one 1.2, A. Artist, interface 1.3, registers "),
            std::string::npos);
  EXPECT_NE(s.run("pluginInfo").find("nodes 0.1.0, Plinian, "), std::string::npos);
}

TEST(LinkedPlugin, OneThatGoesInOneSceneStaysInAnother) {
  PluginSession s;
  s.plugins.add_linked(linked_one);
  {
    PluginSession other;
    other.plugins.add_linked(linked_one);
    EXPECT_EQ(other.run("createNode wobble_one -name a\ngetAttr a.out"), "a\n2");
  }
  EXPECT_EQ(s.run("createNode wobble_one -name a\ngetAttr a.out"), "a\n2");
}

TEST(LinkedPlugin, StaysForAsLongAsTheProgramAndIsThereOnce) {
  PluginSession s;
  s.plugins.add_linked(linked_one);
  EXPECT_EQ(s.refusal("unloadPlugin -force linked_one"),
            "the plug-in 'linked_one' is a part of the program and stays");
  EXPECT_EQ(graph::message_of([&] { s.plugins.add_linked(linked_one); }),
            "the plug-in 'linked_one' is loaded already");
}

TEST(LinkedPlugin, ATimeSourceTellsTheTimeAndNobodyElseDoes) {
  PluginSession s;
  EXPECT_EQ(s.run("currentTime 7.5\ngetAttr time1.out"), "7.5\n7.5");
  PlinianNodeType type{};
  type.size = sizeof(type);
  type.name = "sly";
  type.version = 1;
  PlinianAttribute out{};
  out.size = sizeof(out);
  out.name = "out";
  out.type = "double";
  out.flags = PLINIAN_ATTRIBUTE_OUTPUT;
  type.attributes = &out;
  type.attribute_count = 1;
  type.compute = [](void*, const PlinianCompute* table, PlinianContext* context, std::int32_t output) {
    double frames = 0.0;
    if (!table->time(context, &frames)) return table->fail(context, table->error(context));
    table->write_number(context, output, frames);
  };
  PluginRegistrar registrar;
  ASSERT_EQ(registrar.host().register_node_type(registrar.host().self, &type), 1);
  s.session.types().add(registrar.node_types.at(0));
  EXPECT_EQ(graph::message_of([&] { s.run("createNode sly\ngetAttr sly1.out"); }),
            "script:2: sly1.out: asks for the time without being a time source");
}

}  // namespace
}  // namespace plinian::sdk
