// Handles without a window: ways, turns and factors against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "host/graph/graph_error.h"
#include "host/scene/placed.h"
#include "host/scene/workspace.h"
#include "host/window/handles/handle_drag.h"
#include "host/window/handles/handle_math.h"
#include "host/window/handles/plugin_handles.h"

namespace plinian::window {
namespace {

// 90 degrees high, looking along -z from (0, 0, 10): 10 points a metre at the origin, which is at 100, 100.
Projection ten_away() {
  return {look_at({0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 90.0), 200, 200, vec2(0), vec2(200)};
}

void expect_near(const dvec3& a, const dvec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << "of "
                                       << "xyz"[i];
}

TEST(HandleMath, AlongAnAxisTheHandleStaysUnderTheMouse) {
  const Projection projection = ten_away();
  for (const dvec3& along :
       {dvec3(1, 0, 0), dvec3(0, -1, 0), glm::normalize(dvec3(1, 2, 2)), glm::normalize(dvec3(-1, 0.3, -3))})
    for (const double t : {-2.0, 0.5, 3.0}) {
      const dvec3 through(0.4, -0.7, 0.2);
      const auto seen = projection.point(through + along * t);
      ASSERT_TRUE(seen);
      // Beside the line's picture its foot counts.
      const auto more = projection.point(through + along * (t + 0.1));
      const dvec2 line = glm::normalize(dvec2(more->at) - dvec2(seen->at)), beside(-line.y, line.x);
      EXPECT_NEAR(along_line(projection, through, along, 0.8, dvec2(seen->at) + beside * 7.0), t, 2e-3);
    }
}

TEST(HandleMath, AnAxisThatPointsAtTheViewerIsHeldBack) {
  const Projection projection = ten_away();
  EXPECT_EQ(along_line(projection, {0, 0, 0}, {0, 0, 1}, 1.0, {170, 30}), 0.0);
  EXPECT_NEAR(openness_of_line(projection, {0, 0, 0}, {0, 0, 1}), 0.0, 1e-12);
  EXPECT_NEAR(openness_of_line(projection, {0, 0, 0}, {0, 1, 0}), 1.0, 1e-12);
  // Nearly so: the mouse passes the vanishing point, and the way stays within 20 times the depth.
  const dvec3 along = glm::normalize(dvec3(0.3, 0, -1));
  for (double x = -1000.0; x <= 1000.0; x += 7.0) {
    const double t = along_line(projection, {0, 0, 0}, along, 1.0, {x, 40});
    ASSERT_TRUE(std::isfinite(t));
    EXPECT_LE(t, 20.0 * 10.0 / -along.z);
    EXPECT_GE(t, 10.0 / along.z);
  }
}

TEST(HandleMath, InAPlaneThePointUnderTheMouseIsMet) {
  const Projection projection = ten_away();
  const dvec3 normal = glm::normalize(dvec3(0.2, 1, 0.1)), through(0, -3, 0);
  const dvec3 in_plane = glm::normalize(glm::cross(normal, dvec3(1, 0, 0)));
  for (const double t : {-1.5, 0.0, 2.0}) {
    const auto seen = projection.point(through + in_plane * t);
    expect_near(on_plane(projection, through, normal, dvec2(seen->at)), through + in_plane * t, 1e-4);
  }
  for (double y = -500.0; y <= 700.0; y += 3.0) {  // over the horizon
    const dvec3 met = on_plane(projection, through, normal, {120, y});
    ASSERT_TRUE(std::isfinite(glm::length(met)));
    EXPECT_LT(glm::length(met - through), 1e4);
    EXPECT_NEAR(glm::dot(met - through, normal), 0.0, 1e-6);
  }
  const dvec3 edge_on = on_plane(projection, {0, 0, 0}, {0, 1, 0}, {120, 100});
  EXPECT_TRUE(std::isfinite(glm::length(edge_on)));
  expect_near(beside_point(projection, {1, 2, 3}, {100, 100}), {0, 0, 3}, 1e-5);
}

TEST(HandleMath, ARingTurnsByTheAngleThatIsSeen) {
  const Projection projection = ten_away();
  EXPECT_NEAR(ring_turn(projection, {0, 0, 0}, {0, 0, 1}, 1.0, {110, 100}, {100, 90}, 0.0), 90.0, 1e-6);
  EXPECT_NEAR(ring_turn(projection, {0, 0, 0}, {0, 0, -1}, 1.0, {110, 100}, {100, 90}, 0.0), -90.0, 1e-6);
  EXPECT_NEAR(view_turn(projection, {0, 0, 0}, {110, 100}, {100, 90}, 0.0), 90.0, 1e-6);
  // Which turn it is says what was reached before.
  EXPECT_NEAR(ring_turn(projection, {0, 0, 0}, {0, 0, 1}, 1.0, {110, 100}, {100, 90}, 400.0), 450.0, 1e-6);
  // Askew: points of the ring itself.
  const dvec3 axis = glm::normalize(dvec3(0.3, 0.8, 0.6)),
              u = glm::normalize(glm::cross(axis, dvec3(0, 0, 1))), v = glm::cross(axis, u);
  const auto at = [&](double degrees) {
    const double angle = glm::radians(degrees);
    return dvec2(projection.point(dvec3(1, 1, 0) + u * std::cos(angle) + v * std::sin(angle))->at);
  };
  EXPECT_NEAR(ring_turn(projection, {1, 1, 0}, axis, 1.0, at(20), at(65), 0.0), 45.0, 1e-3);
}

TEST(HandleMath, ARingSeenFromTheSideIsDraggedAsABelt) {
  const Projection projection = ten_away();
  // Its front goes to the right; a radius of 1 is 10 points long.
  const double turn = ring_turn(projection, {0, 0, 0}, {0, 1, 0}, 1.0, {100, 100}, {110, 103}, 0.0);
  EXPECT_NEAR(turn, glm::degrees(1.0), 1e-4);
}

TEST(HandleMath, StepsAreRound) {
  EXPECT_EQ(rounded(44.0, 15.0), 45.0);
  EXPECT_EQ(rounded(0.31, 0.1), 0.3) << "not 0.30000000000000004";
  EXPECT_EQ(rounded(-7.6, 5.0), -10.0);
  EXPECT_FALSE(std::signbit(rounded(-0.01, 0.1)));
  EXPECT_DOUBLE_EQ(round_step(0.037), 0.01);
  EXPECT_DOUBLE_EQ(round_step(100.0), 100.0);
}

class Handles : public testing::Test {
 protected:
  void run(const std::string& line, const std::string& key = "") { session().execute(line, key); }
  graph::Session& session() { return workspace_.session(); }
  dmat4 world(const std::string& name) {
    return scene::Placed(session().graph(), session().evaluator())
        .world_matrix(session().graph().get(name).id);
  }
  std::string text(const std::string& plug) { return session().execute("getAttr " + plug).at(0); }

  // Drags a part as the window would; from, to: [points].
  HandleDrag::Result drag(Tool tool, AxisSpace space, Part part, dvec2 from, dvec2 to, bool snaps = false) {
    ToolChoice choice;
    choice.tool = tool;
    choice.translate_space = choice.rotate_space = space;
    auto target = handle_target(session(), choice);
    if (!target) throw std::runtime_error("nothing to take hold of");
    target->place.radius = 1.0;
    HandleDrag drag(*target, part, ten_away(), from, 1.0f, 0.5);
    const auto result = [&] {
      for (int i = 1; i < 5; ++i) drag.to(glm::mix(from, to, i / 5.0), snaps);
      return drag.to(to, snaps);
    }();
    for (const std::string& line : result.lines) run(line, "drag");
    return result;
  }

 private:
  scene::Workspace workspace_;
};

TEST_F(Handles, TranslateAlongTheWorldUnderATurnedMirroredUnevenParent) {
  run("createNode transform -name above");
  run("setAttr above.translate 1 -1 0");
  run("setAttr above.rotate 30 40 50");
  run("setAttr above.scale 2 -0.5 3");
  run("createNode transform -name thing");
  run("parent -relative thing above");
  run("setAttr thing.translate 0.2 0.1 -0.3");
  run("select thing");
  const dvec3 before(world("thing")[3]);
  const auto seen = ten_away().point(before);
  drag(Tool::translate, AxisSpace::world, Part::y, dvec2(seen->at), dvec2(seen->at) + dvec2(0, -12));
  const dvec3 way = dvec3(world("thing")[3]) - before;
  EXPECT_NEAR(way.x, 0.0, 2e-3);
  EXPECT_NEAR(way.z, 0.0, 2e-3);
  const auto now = ten_away().point(world("thing")[3]);
  EXPECT_NEAR(now->at.y, seen->at.y - 12.0f, 0.2f) << "it stays under the mouse";
}

TEST_F(Handles, AlongItsOwnAxesOrAnUnturnedWorldOneNumberChangesAlone) {
  run("createNode transform -name thing");
  run("setAttr thing.translate 0.123456789 0 0");
  run("select thing");
  EXPECT_EQ(drag(Tool::translate, AxisSpace::world, Part::x, {110, 100}, {125, 103}).lines,
            std::vector<std::string>{"setAttr thing.translate.x 1.6234568"});
  EXPECT_EQ(drag(Tool::translate, AxisSpace::world, Part::zx, {100, 110}, {100, 110}).lines,
            (std::vector<std::string>{"setAttr thing.translate.x 1.6234568", "setAttr thing.translate.z 0"}))
      << "back where it was pressed, it is as it was";
  run("setAttr thing.translate 0 0 0");
  run("setAttr thing.rotate 0 0 30");
  const auto turned = drag(Tool::rotate, AxisSpace::local, Part::z, {110, 100}, {100, 90});
  EXPECT_EQ(turned.text, "90.0°");
  EXPECT_EQ(turned.lines, std::vector<std::string>{"setAttr thing.rotate.z 120"});
  run("setAttr thing.rotate 25 0 0");
  EXPECT_EQ(drag(Tool::rotate, AxisSpace::world, Part::z, {120, 100}, {116, 84}).lines.size(), 1u)
      << "about the last axis of its order";
}

TEST_F(Handles, SnapToStepsOfTheWayAndTellIt) {
  run("createNode transform -name thing");
  run("select thing");
  const auto moved = drag(Tool::translate, AxisSpace::world, Part::xy, {100, 100}, {107, 108}, true);
  EXPECT_EQ(moved.text, "x +0.5  y -1.0 m");
  EXPECT_EQ(text("thing.translate.x"), "0.5");
  run("setAttr thing.translate 0 0 0");
  EXPECT_EQ(drag(Tool::rotate, AxisSpace::world, Part::z, {110, 100}, {107, 93}, true).text, "45.0°");
  EXPECT_EQ(text("thing.rotate.z"), "45");
  const auto scaled = drag(Tool::scale, AxisSpace::local, Part::centre, {100, 100}, {130, 100}, true);
  EXPECT_EQ(scaled.text, "×1.20");
  EXPECT_EQ(text("thing.scale.y"), "1.2");
}

TEST_F(Handles, ScaleKeepsTheMirrorAndNeverReachesNothing) {
  run("createNode transform -name thing");
  run("setAttr thing.scale -2 1 1");
  run("select thing");
  EXPECT_EQ(drag(Tool::scale, AxisSpace::local, Part::x, {110, 100}, {115, 100}).lines,
            std::vector<std::string>{"setAttr thing.scale.x -3"});
  drag(Tool::scale, AxisSpace::local, Part::x, {110, 100}, {-400, 100});
  EXPECT_LT(std::stod(text("thing.scale.x")), 0.0);
}

TEST_F(Handles, TurnsInTheWorldUnderAMirroredParent) {
  run("createNode transform -name above");
  run("setAttr above.rotate 10 20 30");
  run("setAttr above.scale -2 2 2");
  run("createNode transform -name thing");
  run("parent -relative thing above");
  run("setAttr thing.rotate_order yzx");
  run("setAttr thing.rotate 15 25 35");
  run("select thing");
  const dmat4 before = world("thing");
  drag(Tool::rotate, AxisSpace::world, Part::z, {110, 100}, {100, 90});
  const dmat3 wanted = dmat3(rotation_xyz({0, 0, 90})) * dmat3(before), found(world("thing"));
  for (int i = 0; i < 3; ++i) expect_near(found[i], wanted[i], 2e-3);
}

TEST_F(Handles, APivotIsWhereItStaysAndIsTakenHoldOf) {
  run("createNode transform -name thing");
  run("setAttr thing.translate 1 0 0");
  run("setAttr thing.pivot 1 2 0");
  run("select thing");
  ToolChoice choice;
  choice.tool = Tool::rotate;
  expect_near(handle_target(session(), choice)->place.centre, {2, 2, 0}, 0.0);
  const dvec3 before(world("thing") * dvec4(1, 2, 0, 1));
  drag(Tool::rotate, AxisSpace::world, Part::z, {140, 80}, {120, 60});
  expect_near(dvec3(world("thing") * dvec4(1, 2, 0, 1)), before, 1e-12);
}

TEST_F(Handles, SeveralMoveTogetherAndWhatIsUnderThemOnce) {
  for (const char* name : {"a", "b", "under"}) run(std::string("createNode transform -name ") + name);
  run("parent -relative under a");
  run("setAttr b.translate 3 0 0");
  run("select under a b");
  ToolChoice choice;
  choice.tool = Tool::translate;
  const auto target = handle_target(session(), choice);
  ASSERT_EQ(target->nodes.size(), 2u);
  EXPECT_EQ(target->nodes[0].name, "b") << "what was selected last leads";
  drag(Tool::translate, AxisSpace::world, Part::x, {100, 100}, {110, 100});
  EXPECT_EQ(text("a.translate.x"), "1");
  EXPECT_EQ(text("b.translate.x"), "4");
  EXPECT_EQ(text("under.translate.x"), "0");
  run("undo");
  EXPECT_EQ(text("a.translate.x"), "0");
  EXPECT_EQ(text("b.translate.x"), "3");
}

TEST_F(Handles, OfAShapeThePlaceThatItIsUnderIsTaken) {
  run("createNode transform -name above");
  run("createNode transform -name place");
  run("parent -relative place above");
  run("createNode atfmVolume -name shape");
  run("parent -relative shape place");
  run("select place shape");
  ToolChoice choice;
  choice.tool = Tool::translate;
  const auto target = handle_target(session(), choice);
  ASSERT_TRUE(target);
  ASSERT_EQ(target->nodes.size(), 1u) << "once";
  EXPECT_EQ(target->nodes[0].name, "place");
}

TEST_F(Handles, WhatIsLockedOrDrivenSaysSoAndTheRestMoves) {
  run("createNode directionalLight -name key");
  run("createNode transform -name thing");
  run("lockAttr thing.translate.x");
  run("setKeyframe thing.rotate.y -time 1 -value 0");
  run("select thing");
  ToolChoice choice;
  const auto problem = [&](Tool tool, Part part) {
    choice.tool = tool;
    const auto target = handle_target(session(), choice);
    return target ? target_problem(session(), *target, target->nodes[0], part) : "none";
  };
  EXPECT_EQ(problem(Tool::translate, Part::x), "thing.translate.x is locked");
  EXPECT_EQ(problem(Tool::translate, Part::xy), "thing.translate.x is locked");
  EXPECT_EQ(problem(Tool::translate, Part::centre), "thing.translate.x is locked");
  EXPECT_EQ(problem(Tool::translate, Part::yz), "");
  EXPECT_NE(problem(Tool::rotate, Part::view).find("thing.rotate.y is keyed (thing_rotate_y)"),
            std::string::npos);
  EXPECT_EQ(problem(Tool::scale, Part::centre), "");
  run("select key");
  EXPECT_EQ(problem(Tool::translate, Part::x), "none") << "a sun has no place";
  EXPECT_EQ(problem(Tool::rotate, Part::x), "");
  run("setAttr thing.scale 1 0 1");
  run("parent -relative key thing");
  EXPECT_NE(problem(Tool::rotate, Part::x), "") << "no space to turn in";
}

TEST(HandleShape, EachPartIsTakenWhereItIsSeenAndAnAxisFromItsEndIsNot) {
  const HandlePlace place{.centre = dvec3(0), .axes = dmat3(1.0), .radius = 5.0};
  for (const Tool tool : {Tool::translate, Tool::rotate, Tool::scale}) {
    const Projection askew(look_at({7, 5, 10}, {0, 0, 0}, {0, 1, 0}, 60.0), 600, 600, vec2(0), vec2(600));
    const auto shapes = handle_shape(tool, place, askew, 1.0f);
    EXPECT_EQ(shapes.size(), tool == Tool::translate ? 7u : 4u);
    for (const PartShape& shape : shapes) {
      const auto grip = grip_of(shapes, shape, 6.0f);
      ASSERT_TRUE(grip) << name_of(shape.part);
      EXPECT_EQ(part_at(shapes, *grip, 6.0f), shape.part);
    }
    EXPECT_EQ(part_at(shapes, {5, 5}, 6.0f), Part::none);
    for (const PartShape& shape : handle_shape(tool, place, ten_away(), 1.0f))
      EXPECT_FALSE(tool != Tool::rotate && shape.part == Part::z && shape.can_be_taken) << "it points here";
  }
  EXPECT_TRUE(handle_shape(Tool::select, place, ten_away(), 1.0f).empty());
}

TEST(PluginHandleView, SeesPointsWhereTheOverlayDoes) {
  const Camera camera = look_at({3, 4, 10}, {0, 1, 0}, {0, 1, 0}, 50.0);
  const Projection projection(camera, 640, 360, vec2(0), vec2(640, 360));
  const sdk::HandleView view = handle_view(camera, 640, 360, vec2(640, 360), 10.0);
  for (const dvec3& point : {dvec3(0, 0, 0), dvec3(1, -2, 3), dvec3(-2, 1, -7)}) {
    const auto pixel = view.pixel(point);
    const auto seen = projection.point(point);
    ASSERT_TRUE(pixel && seen);
    EXPECT_NEAR(pixel->x, seen->at.x, 1e-3);
    EXPECT_NEAR(360.0 - pixel->y, seen->at.y, 1e-3);
    expect_near(view.world(*pixel), point, 1e-6);
  }
  EXPECT_FALSE(view.pixel({6, 7, 20})) << "behind the eye";
}

}  // namespace
}  // namespace plinian::window
