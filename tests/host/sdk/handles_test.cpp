// Manipulator handles: where they are, hits, and what dragging does.
#include "host/sdk/handles.h"

#include "host/sdk/plugin.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

NodeType lamp() {
  NodeType type("lampShape");
  type.hierarchical = true;
  type.add({.name = "place", .type = "float3"});
  type.add({.name = "aim", .type = "float3", .default_value = "2 0 0"});
  type.add({.name = "range", .type = "distance", .default_value = "1.5"});
  type.add({.name = "angle", .type = "angle", .default_value = "90"});
  type.handles = {
      {.name = "place", .grip = Grip::point, .attribute = "place"},
      {.name = "aim", .grip = Grip::direction, .attribute = "aim", .origin = "place"},
      {.name = "range", .grip = Grip::distance, .attribute = "range", .origin = "place", .axis = {0, 1, 0}},
      {.name = "angle", .grip = Grip::cone, .attribute = "angle", .origin = "place", .axis = {0, 0, -1}}};
  return type;
}

void initialise(Plugin& plugin) {
  plugin.add(lamp());
}
PLINIAN_LINKED_PLUGIN(lamps, "lamps", "1.0", "A. Artist", "node:lampShape", initialise);

enum { place, aim, range, angle };

struct HandleScene : PluginSession {
  HandleView view;
  dmat4 world_from_object{1.0};

  HandleScene() {
    plugins.add_linked(lamps);
    run("createNode lampShape -name l");
    // 100 pixels for a unit; the middle of the picture, 200, 200, is the origin.
    view.clip_from_world = glm::ortho(-2.0, 2.0, -2.0, 2.0, -10.0, 10.0);
    view.viewport = ivec4(0, 0, 400, 400);
  }
  std::vector<PlacedHandle> handles() {
    const graph::NodeId node = session.graph().get("l").id;
    return place_handles(session, node, plugins.handles("lampShape"), world_from_object);
  }
  std::optional<std::size_t> hit(double x, double y) { return hit_handle(handles(), view, {x, y}); }
  std::string drag(std::size_t index, dvec2 from, dvec2 to) {
    return drag_command(session.graph(), handles()[index], view, from, to);
  }
};

TEST(Handles, AreWhereTheirAttributesSay) {
  HandleScene s;
  s.run("setAttr l.place 0.5 0 0");
  s.world_from_object = glm::translate(dmat4(1.0), dvec3(0.0, -1.0, 0.0));
  const auto handles = s.handles();
  ASSERT_EQ(handles.size(), 4u);
  const auto tip = [&](std::size_t i) {
    return s.view.pixel(dvec3(handles[i].world_from_handle * dvec4(handles[i].tip, 1.0)));
  };
  EXPECT_NEAR(tip(place)->x, 250.0, 1e-9);
  EXPECT_NEAR(tip(place)->y, 100.0, 1e-9);
  EXPECT_NEAR(tip(aim)->x, 350.0, 1e-9);  // shown at length 1, whatever the vector's
  EXPECT_NEAR(tip(range)->y, 250.0, 1e-9);
}

TEST(Handles, AreHitWhereTheyAreDrawnAndNowhereElse) {
  HandleScene s;
  EXPECT_EQ(s.hit(300, 203), std::size_t(aim));
  EXPECT_EQ(s.hit(250, 198), std::size_t(aim));              // its line
  EXPECT_EQ(s.hit(202, 350), std::size_t(range));            // its tip
  EXPECT_EQ(s.hit(200 - 71, 200 - 71), std::size_t(angle));  // the circle of radius tan(45 degrees)
  EXPECT_FALSE(s.hit(150, 150));
  EXPECT_FALSE(s.hit(20, 380));
  EXPECT_FALSE(s.hit(320, 208));
}

TEST(Handles, DraggingSetsTheAttributeThroughACommand) {
  HandleScene s;
  EXPECT_EQ(s.drag(place, {200, 200}, {250, 150}), "setAttr l.place 0.5 -0.5 0");
  // From the tip at 300, 200 to straight above: the length of the vector is kept.
  EXPECT_EQ(s.drag(aim, {300, 200}, {200, 300}), "setAttr l.aim 0 2 0");
  EXPECT_EQ(s.drag(range, {210, 320}, {205, 370}), "setAttr l.range 2");  // by as much, wherever it was held
  EXPECT_EQ(s.drag(range, {200, 350}, {200, 100}), "setAttr l.range 0");
  // The rim from a radius of 1 to one of sqrt(3), at distance 1: 2 atan(sqrt(3)).
  const std::string command = s.drag(angle, {300, 200}, {200 + 100 * std::sqrt(3.0), 200});
  EXPECT_NEAR(std::stod(command.substr(std::string("setAttr l.angle ").size())), 120.0, 1e-3);
  s.session.execute(command, "drag 1");
  s.session.execute(s.drag(angle, {300, 200}, {310, 200}), "drag 1");
  EXPECT_EQ(s.run("undo\ngetAttr l.angle").substr(0, 8), "setAttr ");
  EXPECT_EQ(s.run("getAttr l.angle"), "90");  // one step
}

TEST(Handles, FollowTheirTransformsAndPerspective) {
  HandleScene s;
  s.world_from_object = glm::rotate(glm::scale(dmat4(1.0), dvec3(2.0)), glm::radians(90.0), dvec3(0, 0, 1));
  s.view.clip_from_world = glm::perspective(glm::radians(60.0), 1.0, 0.1, 100.0) *
                           glm::lookAt(dvec3(1, 2, 8), dvec3(0.0), dvec3(0, 1, 0));
  // Whatever the view, the handle ends where the cursor does.
  for (const std::size_t index : {std::size_t(place), std::size_t(range)}) {
    const auto handle = s.handles()[index];
    const auto at = [&] {
      const auto now = s.handles()[index];
      return dvec2(*s.view.pixel(dvec3(now.world_from_handle * dvec4(now.tip, 1.0))));
    };
    const dvec2 from = at();
    dvec2 to = from + dvec2(13.0, -21.0);
    if (index == range) {  // along its line
      const auto origin = s.view.pixel(dvec3(handle.world_from_handle * dvec4(handle.origin, 1.0)));
      to = dvec2(*origin) + 1.25 * (from - dvec2(*origin));
    }
    s.session.execute(s.drag(index, from, to));
    EXPECT_NEAR(at().x, to.x, 1e-2);
    EXPECT_NEAR(at().y, to.y, 1e-2);
  }
}

TEST(Handles, WhatIsDrivenOrLockedOrBehindTheCameraIsNotDragged) {
  HandleScene s;
  s.run("lockAttr l.range\ncreateNode animCurve -name k\nconnectAttr k.out l.angle");
  EXPECT_FALSE(s.handles()[range].is_free);
  EXPECT_EQ(s.drag(range, {200, 350}, {200, 370}), "");
  EXPECT_EQ(s.drag(angle, {300, 200}, {310, 200}), "");
  s.view.clip_from_world =
      glm::perspective(1.0, 1.0, 0.1, 100.0) * glm::lookAt(dvec3(0, 0, 8), dvec3(0, 0, 16), dvec3(0, 1, 0));
  EXPECT_EQ(s.drag(place, {200, 200}, {210, 200}), "");
  EXPECT_FALSE(s.hit(200, 200));
}

TEST(Handles, OnAttributesThatAreNotThereOrOfAnotherTypeAreRefused) {
  const auto refusal = [](Handle handle) {
    PluginRegistrar registrar;
    NodeType type("t");
    type.add({.name = "place", .type = "float3"});
    type.add({.name = "size"});
    type.handles = {std::move(handle)};
    EXPECT_EQ(detail::register_type(registrar.host(), type), 0);
    return registrar.error;
  };
  EXPECT_EQ(refusal({.name = "h", .attribute = "size"}),
            "node type 't': the handle 'h' needs a float3, which 'size' is not");
  EXPECT_EQ(refusal({.name = "h", .attribute = "plaice"}),
            "node type 't': the handle 'h' names 'plaice', which is no attribute (did you mean 'place'?)");
  EXPECT_EQ(refusal({.name = "h", .grip = Grip::distance, .attribute = "size", .axis = {0, 0, 0}}),
            "node type 't': the handle 'h' needs an axis");
}

}  // namespace
}  // namespace plinian::sdk
