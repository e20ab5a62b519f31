// Shapes from plug-ins, and the volumes that they show.
#include "host/sdk/contribution.h"

#include "host/sdk/volume_table.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

struct CloudSession : PluginSession {
  CloudSession() { run("loadPlugin cloud\ncreateNode cloud -name c"); }
  graph::ResultPtr evaluate(const std::string& plug) {
    return session.evaluator().evaluate(session.graph().plug(plug));
  }
  ShapeContributionPtr contribution() { return contribution_in(evaluate("c.contribution")->value); }
  std::string error(const std::string& plug) {
    const graph::ResultPtr result = evaluate(plug);
    return session.evaluator().error_text(session.graph().plug(plug), *result);
  }
  std::uint64_t computes(const std::string& type) {
    return session.evaluator().counters().computes_of_type.at(type);
  }
};

TEST(Contribution, ShapesHaveAHiddenOutputForItAndAPlaceInTheHierarchy) {
  CloudSession s;
  const graph::NodeTypePtr shape = s.session.types().get("cloud"), other = s.session.types().get("blob");
  const graph::AttributeIndex output = contribution_of(*shape);
  ASSERT_NE(output, graph::no_attribute);
  EXPECT_EQ(contribution_of(*other), graph::no_attribute);
  const graph::AttributeSpec& spec = (*shape->schema())[output].spec;
  EXPECT_TRUE(spec.hidden && spec.read_only && spec.output && !spec.storable && !spec.keyable &&
              !spec.connectable);
  EXPECT_TRUE(shape->spec().hierarchical);
}

TEST(Contribution, VoxelsThatNoMediumCanHoldCountAsNothingAndAreToldOfOnce) {
  PluginSession s;
  std::vector<std::string> warnings;
  s.session.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  s.run("loadPlugin cloud\ncreateNode blob -name b\nsetAttr b.radius 2\nsetAttr b.spoiled -9");
  const auto voxels = [&] {
    const graph::ResultPtr result = s.session.evaluator().evaluate(s.session.graph().plug("b.out"));
    return volume_in(result->value)->active_voxels;
  };
  EXPECT_EQ(voxels(), 33);  // of a ball of radius 2
  EXPECT_TRUE(warnings.empty());
  s.run("setAttr b.spoiled -1");  // the one with x = -2
  EXPECT_EQ(voxels(), 32);
  s.run("setAttr b.spoiled 0");  // and those with x = -1
  EXPECT_EQ(voxels(), 33 - 10);
  s.run("setAttr b.hot on");  // computed again, and the same
  EXPECT_EQ(voxels(), 33 - 10);
  EXPECT_EQ(
      warnings,
      (std::vector<std::string>{
          "b.out: 1 voxel of a volume that the plug-in 'cloud' made is negative or not finite, and counts "
          "as 0",
          "b.out: 10 voxels of a volume that the plug-in 'cloud' made are negative or not finite, and "
          "count as 0"}));
  s.run("setAttr b.spoiled -9");
  voxels();
  s.run("setAttr b.spoiled -1");
  voxels();
  EXPECT_EQ(warnings.size(), 3u) << "it is told again when it is so again";
}

TEST(Contribution, ABoxOfVoxelsThatCannotBeSaysWhatIsWrongWithIt) {
  PluginSession s;
  s.run("loadPlugin cloud\ncreateNode blob -name b");
  const auto error = [&](const std::string& line) {
    s.run(line);
    return s.session.evaluator().evaluate(s.session.graph().plug("b.out"))->error->message;
  };
  EXPECT_EQ(
      error("setAttr b.begin -2147483647"),
      "a box of voxels reaches further from 0 than 268435456 voxels: a size of 0, or a number that is not "
      "finite, may be behind it");
  EXPECT_EQ(error("setAttr b.begin 0\nsetAttr b.side -3"),
            "a box of voxels has -3 along a side: give it 0 or more");
}

TEST(Contribution, HoldsWhatTheShapeAddsInItsOwnSpace) {
  CloudSession s;
  s.run("setAttr c.lamp on\nsetAttr c.density 4\nsetAttr c.colour 0.5 0.25 0");
  const ShapeContributionPtr found = s.contribution();
  ASSERT_TRUE(found);
  ASSERT_EQ(found->media.size(), 1u);
  const Medium& medium = found->media[0];
  EXPECT_EQ(medium.shape, MediumShape::sphere);
  EXPECT_EQ(medium.density_scale, 4.0f);
  EXPECT_EQ(medium.sigma_s, vec3(0.5f, 0.25f, 0.0f));
  EXPECT_EQ(medium.sigma_a, vec3(0.2f));
  EXPECT_EQ(medium.phase.kind, PhaseKind::henyey_greenstein);
  EXPECT_EQ(medium.phase.g, 0.3f);
  EXPECT_EQ(medium.world_from_medium[0][0], 3.0);
  EXPECT_EQ(medium.world_from_medium[3][3], 1.0);
  ASSERT_EQ(found->lights.size(), 1u);
  EXPECT_EQ(found->lights[0].name, "Lamp");
  EXPECT_EQ(found->lights[0].type, LightType::spot);
  EXPECT_EQ(found->lights[0].toward, vec3(0, 1, 0));  // made unit
  EXPECT_EQ(found->lights[0].position, vec3(0, 5, 0));
  EXPECT_EQ(found->ambient, vec3(0.2f, 0.4f, 0.6f));
  ASSERT_EQ(found->cameras.size(), 1u);
  EXPECT_EQ(found->cameras[0].camera.focal_length, 50.0f);
  EXPECT_EQ(found->cameras[0].camera.world_from_camera[3], dvec4(0, 0, 9, 1));
  ASSERT_TRUE(found->bounds);
  EXPECT_EQ(found->bounds->minimum, dvec3(-1, -2, -3));
  EXPECT_EQ(found->bounds->maximum, dvec3(4, 2, 3));
}

TEST(Contribution, IsMadeAnewOnlyWhereAnInputOfThePictureChanged) {
  CloudSession s;
  const ShapeContributionPtr first = s.contribution();
  const std::uint64_t before = s.computes("cloud");
  s.run("setAttr c.note \"look at this\"");
  EXPECT_FALSE(s.session.evaluator().is_dirty(s.session.graph().plug("c.contribution")));
  EXPECT_EQ(s.contribution(), first);
  EXPECT_EQ(s.computes("cloud"), before);
  s.run("setAttr c.g 0.5");
  EXPECT_NE(s.contribution(), first);
  EXPECT_EQ(s.computes("cloud"), before + 1);
  s.run("undo");
  EXPECT_EQ(s.contribution(), first);  // found again
  EXPECT_EQ(s.computes("cloud"), before + 1);
  EXPECT_EQ(s.run("evaluate -check c.contribution").find("c.contribution plinian.contribution, "), 0u);
}

TEST(Contribution, ShapesComputeTheirOtherOutputsAsBefore) {
  CloudSession s;
  EXPECT_EQ(s.run("setAttr c.density 3\ngetAttr c.opacity"), "6");
}

TEST(Contribution, AFailureStaysOnTheShapeWithItsReason) {
  CloudSession s;
  s.run("setAttr c.g 1.5");
  EXPECT_EQ(s.error("c.contribution"), "a medium: its g cannot be 1.5");
  EXPECT_EQ(s.session.evaluator().take_reports(),
            std::vector<std::string>{"c.contribution: a medium: its g cannot be 1.5"});
  s.run("setAttr c.g 0\nsetAttr c.density -1");
  EXPECT_EQ(s.error("c.contribution"), "a medium: its density_scale cannot be -1");
  s.run("setAttr c.density 1\ncreateNode blob -name b\nsetAttr b.fails on\nconnectAttr b.out c.volume");
  EXPECT_EQ(s.error("c.contribution"), "blocked by b.out: no more voxels");
}

TEST(Contribution, CarriesVolumesThatLiveAsLongAsItDoes) {
  ShapeContributionPtr found;
  {
    CloudSession s;
    s.run("createNode blob -name b\nsetAttr b.hot on\nconnectAttr b.out c.volume");
    found = s.contribution();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->media.at(0).volume, volume_in(s.evaluate("b.out")->value));
    s.run("unloadPlugin -force cloud");
  }
  const BrickVolume& volume = *found->media.at(0).volume;
  int inside = 0;
  for (int z = -6; z <= 6; ++z)
    for (int y = -6; y <= 6; ++y)
      for (int x = -6; x <= 6; ++x) inside += x * x + y * y + z * z <= 36;
  EXPECT_EQ(volume.active_voxels, inside);
  EXPECT_EQ(volume.voxel_density({0, 0, 6}), 2.0f);
  EXPECT_EQ(volume.voxel_density({0, 0, 7}), 0.0f);
  EXPECT_NEAR(volume.sample_temperature(vec3(1.0f)), 1500.0f, 0.1f);
  EXPECT_EQ(volume.medium_from_index[0][0], 0.5);
  EXPECT_EQ(volume.medium_from_index[3], dvec4(1, 0, 0, 1));
}

TEST(Contribution, VolumesAreReadAndMadeAnewByNodes) {
  CloudSession s;
  s.run("createNode blob -name b\ncreateNode thin -name t\nconnectAttr b.out t.in");
  const auto whole = volume_in(s.evaluate("b.out")->value), half = volume_in(s.evaluate("t.out")->value);
  ASSERT_TRUE(whole && half);
  EXPECT_EQ(half->active_voxels, whole->active_voxels);
  EXPECT_EQ(half->bounds_min, whole->bounds_min);
  EXPECT_EQ(half->bounds_max, whole->bounds_max);
  EXPECT_EQ(half->voxel_density({3, -2, 1}), 1.0f);
  EXPECT_EQ(half->temperature_max, 0.0f);
  s.run("disconnectAttr t.in");
  EXPECT_EQ(s.error("t.out"), "there is no volume");
}

TEST(Contribution, VoxelsOutsideTheBoxThatWasAskedForAreNone) {
  CloudSession s;
  s.run("createNode blob -name b\nsetAttr b.radius 30");  // larger than its box
  const auto volume = volume_in(s.evaluate("b.out")->value);
  EXPECT_EQ(volume->bounds_min, ivec3(-21));
  EXPECT_EQ(volume->bounds_max, ivec3(21));
}

// What only a hand that writes plain C could do wrong.
TEST(Contribution, RefusesVolumesOfNobodyAndDataThatAreTheProgramsOwn) {
  PluginSession s;
  PlinianAttribute out{};
  out.size = sizeof(out);
  out.name = "out";
  out.type = "data";
  out.data_type = PLINIAN_VOLUME_TYPE;
  out.flags = PLINIAN_ATTRIBUTE_OUTPUT;
  PlinianNodeType type{};
  type.size = sizeof(type);
  type.name = "sly";
  type.version = 1;
  type.attributes = &out;
  type.attribute_count = 1;
  type.compute = [](void*, const PlinianCompute* table, PlinianContext* context, std::int32_t output) {
    PlinianData data{};
    data.size = sizeof(data);
    data.type = PLINIAN_VOLUME_TYPE;
    data.object = table;
    if (!table->write_data(context, output, &data)) table->fail(context, table->error(context));
  };
  type.contribute = [](void*, const PlinianCompute* table, PlinianContext* context,
                       const PlinianContribute* contribute, PlinianContribution* contribution) {
    PlinianMedium medium{};
    medium.size = sizeof(medium);
    medium.name = "m";
    medium.volume = reinterpret_cast<const PlinianVolume*>(table);
    if (!contribute->add_medium(contribution, &medium)) table->fail(context, table->error(context));
  };
  PluginRegistrar registrar;
  ASSERT_EQ(registrar.host().register_node_type(registrar.host().self, &type), 1) << registrar.error;
  s.session.types().add(registrar.node_types.at(0));
  s.run("createNode sly -name x");
  const auto error = [&](const char* plug) {
    return graph::message_of([&] { s.run(std::string("evaluate ") + plug); });
  };
  EXPECT_EQ(error("x.out"), "script:1: x.out: data of the type plinian.volume are the program's own");
  EXPECT_EQ(error("x.contribution"),
            "script:1: x.contribution: a volume that was neither read nor made here");
}

}  // namespace
}  // namespace plinian::sdk
