// The node editor without a window: what it shows, where it puts it, what is hit, what a wire does.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/graph/edits/connect_problem.h"
#include "host/graph/graph_error.h"
#include "host/scene/workspace.h"
#include "host/window/nodes/canvas_view.h"
#include "host/window/nodes/connect_drag.h"
#include "host/window/nodes/diagram_hit.h"
#include "host/window/nodes/layered_layout.h"
#include "host/window/nodes/node_failure.h"
#include "host/window/nodes/node_map.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian::window {
namespace {

std::vector<LaidOut> laid_out(std::size_t count, const LayoutEdges& edges) {
  std::vector<LaidOut> boxes(count, LaidOut{{100.0f, 40.0f}, std::nullopt});
  lay_out(boxes, edges);
  return boxes;
}

bool overlap(const LaidOut& a, const LaidOut& b) {
  return a.place->x < b.place->x + b.size.x && b.place->x < a.place->x + a.size.x &&
         a.place->y < b.place->y + b.size.y && b.place->y < a.place->y + a.size.y;
}

TEST(LayeredLayout, EveryWireRunsFromLeftToRightAndNoBoxesOverlap) {
  const LayoutEdges edges = {{0, 2}, {1, 2}, {2, 3}, {0, 3}, {4, 5}, {7, 3}, {3, 8}};
  const auto boxes = laid_out(10, edges);
  for (const auto& [from, to] : edges)
    EXPECT_GE(boxes[to].place->x, boxes[from].place->x + boxes[from].size.x) << from << " to " << to;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << i << " and " << j;
}

// As they are made one by one, none of them moving another.
TEST(LayeredLayout, WhatComesAloneKeepsTheWholeAsWideAsAPane) {
  auto boxes = laid_out(4, {{0, 1}, {1, 2}, {2, 3}});
  for (int i = 0; i < 30; ++i) {
    const auto before = boxes;
    boxes.push_back({{100.0f, 40.0f}, std::nullopt});
    lay_out(boxes, {{0, 1}, {1, 2}, {2, 3}});
    vec2 begin(1e9f), end(-1e9f);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      if (b < before.size()) {
        EXPECT_EQ(*boxes[b].place, *before[b].place);
      }
      for (std::size_t c = 0; c < b; ++c) EXPECT_FALSE(overlap(boxes[b], boxes[c])) << b << " and " << c;
      begin = glm::min(begin, *boxes[b].place);
      end = glm::max(end, *boxes[b].place + boxes[b].size);
    }
    const vec2 size = end - begin;
    EXPECT_GT(size.x, 2.0f * size.y) << i;
    if (i > 1) {
      EXPECT_LT(size.x, 8.0f * size.y) << i;
    }
  }
}

TEST(LayeredLayout, WiresOfALadderDoNotCross) {
  // 0 to 5, 1 to 4, 2 to 3: told in the order that would cross.
  const auto boxes = laid_out(6, {{0, 5}, {1, 4}, {2, 3}, {0, 4}, {1, 3}});
  const auto order = [&](std::size_t a, std::size_t b) { return boxes[a].place->y < boxes[b].place->y; };
  EXPECT_EQ(order(0, 1), order(5, 4));
  EXPECT_EQ(order(1, 2), order(4, 3));
}

TEST(LayeredLayout, WiresIntoOneBoxComeInTheOrderOfItsPlugs) {
  const auto boxes = laid_out(4, {{2, 3}, {0, 3}, {1, 3}});
  EXPECT_LT(boxes[2].place->y, boxes[0].place->y);
  EXPECT_LT(boxes[0].place->y, boxes[1].place->y);
}

TEST(LayeredLayout, WhatIsFirstStandsRightBeforeWhatItDrives) {
  const auto boxes = laid_out(4, {{0, 1}, {1, 2}, {3, 2}});
  EXPECT_EQ(boxes[3].place->x, boxes[1].place->x) << "not in the first column, far from its only wire";
}

// Beneath the picture there is more width than height.
TEST(LayeredLayout, WhatNothingConnectsStandsSideBySide) {
  for (const std::size_t alone : {0u, 8u, 40u})
    for (const std::size_t pairs : {0u, 1u, 6u}) {
      if (alone + pairs < 4) continue;
      LayoutEdges edges;
      for (std::size_t i = 0; i < pairs; ++i) edges.emplace_back(2 * i, 2 * i + 1);
      const auto boxes = laid_out(2 * pairs + alone, edges);
      vec2 end(0.0f);
      for (const LaidOut& box : boxes) end = glm::max(end, *box.place + box.size);
      EXPECT_GT(end.x, 2.0f * end.y) << alone << " alone and " << pairs << " pairs: " << end.y << " high";
      EXPECT_LT(end.x, 10.0f * end.y) << alone << " alone and " << pairs << " pairs: " << end.x << " wide";
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << i << " and " << j;
    }
}

TEST(LayeredLayout, AnEditMovesNothingThatWasThere) {
  auto boxes = laid_out(4, {{0, 1}, {1, 2}});
  const auto before = boxes;
  boxes.push_back({{100.0f, 40.0f}, std::nullopt});
  lay_out(boxes, {{0, 1}, {1, 2}, {1, 4}, {3, 4}});
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(*boxes[i].place, *before[i].place);
  ASSERT_TRUE(boxes[4].place);
  EXPECT_GE(boxes[4].place->x, boxes[1].place->x + 100.0f) << "right of what drives it";
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_FALSE(overlap(boxes[i], boxes[4])) << i;
}

TEST(LayeredLayout, NodesThatGoRoundInACircleHavePlacesToo) {
  const LayoutEdges edges = {{0, 1}, {1, 0}, {1, 2}, {2, 2}};
  std::vector<LaidOut> boxes = laid_out(3, edges);
  for (const std::size_t kept : {0u, 1u, 2u}) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (i != kept) boxes[i].place.reset();
    lay_out(boxes, edges);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      ASSERT_TRUE(boxes[i].place) << i;
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << i << " and " << j;
    }
  }
}

TEST(CanvasView, ZoomsAboutThePlaceUnderThePointerAndStopsWhereItCannotBeRead) {
  CanvasView view{{30.0f, -10.0f}, 1.0f};
  const vec2 at(200.0f, 90.0f), before = view.to_canvas(at);
  view = zoomed(view, at, 1.7f, 1.0f);
  EXPECT_LT(glm::distance(view.to_canvas(at), before), 1e-3f);
  EXPECT_FLOAT_EQ(view.zoom, 1.7f);
  for (int i = 0; i < 100; ++i) view = zoomed(view, at, 0.5f, 1.0f);
  EXPECT_GT(view.zoom, 0.1f);
  EXPECT_LT(glm::distance(view.to_canvas(at), before), 1e-2f);
}

TEST(CanvasView, AFrameShowsAllOfARectangleInTheMiddleAndNothingLargerThanLife) {
  const vec2 begin(-300.0f, 20.0f), end(500.0f, 900.0f), pane(400.0f, 200.0f);
  const CanvasView view = framed(begin, end, pane, 1.0f);
  const vec2 first = view.to_pane(begin), last = view.to_pane(end);
  EXPECT_GE(first.x, 0.0f);
  EXPECT_GE(first.y, 0.0f);
  EXPECT_LE(last.x, pane.x);
  EXPECT_LE(last.y, pane.y);
  EXPECT_NEAR(first.x, pane.x - last.x, 2.0f);
  EXPECT_EQ(framed({0.0f, 0.0f}, {10.0f, 10.0f}, {4000.0f, 4000.0f}, 1.0f).zoom, 1.0f);
}

class NodeEditor : public testing::Test {
 protected:
  NodeEditor() {
    for (const char* line :
         {"createNode transform -name place", "createNode atfmVolume -name shape", "parent shape place",
          "createNode volumeNoise -name noise", "createNode medium -name fog",
          "createNode medium -name other", "createNode directionalLight -name sun",
          "connectAttr noise.volume shape.volume", "connectAttr fog.out shape.medium"})
      session().execute(line);
  }
  graph::Session& session() { return workspace_.session(); }
  const graph::Graph& graph() { return workspace_.session().graph(); }
  Diagram diagram(const DiagramChoice& choice = {}) { return diagram_of(graph(), choice); }

  static std::size_t box_of(const Diagram& diagram, const std::string& name) {
    const auto found = std::find_if(diagram.boxes.begin(), diagram.boxes.end(),
                                    [&](const NodeBox& box) { return box.name == name; });
    if (found == diagram.boxes.end()) throw std::runtime_error("no box " + name);
    return std::size_t(found - diagram.boxes.begin());
  }
  static const PlugRow* row_of(const Diagram& diagram, const std::string& node, const std::string& label) {
    for (const PlugRow& row : diagram.boxes[box_of(diagram, node)].rows)
      if (row.label == label) return &row;
    return nullptr;
  }
  static DiagramHit at(const Diagram& diagram, const std::string& node, const std::string& label,
                       bool gives) {
    const std::size_t b = box_of(diagram, node);
    const auto& rows = diagram.boxes[b].rows;
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (rows[r].label == label) return {gives ? DiagramPart::giving_plug : DiagramPart::taking_plug, b, r};
    throw std::runtime_error("no plug " + label);
  }

  scene::Workspace workspace_;
};

TEST_F(NodeEditor, ABoxShowsWhatIsConnectedCarriesDataOrIsNamedByTheFilterUntilItIsOpened) {
  Diagram now = diagram();
  ASSERT_TRUE(row_of(now, "fog", "out"));
  EXPECT_TRUE(row_of(now, "fog", "out")->gives);
  EXPECT_TRUE(row_of(now, "fog", "out")->drives);
  EXPECT_FALSE(row_of(now, "other", "out")->drives);
  EXPECT_TRUE(row_of(now, "shape", "medium")->driven);
  EXPECT_FALSE(row_of(now, "fog", "albedo"));
  EXPECT_TRUE(now.boxes[box_of(now, "fog")].has_more);
  EXPECT_EQ(now.wires.size(), 2u);
  ASSERT_EQ(now.lineages.size(), 1u);
  EXPECT_EQ(now.boxes[now.lineages[0].child].name, "shape");

  now = diagram({.around = {}, .open = {}, .filter = "Albedo"});
  ASSERT_TRUE(row_of(now, "fog", "albedo"));
  EXPECT_TRUE(row_of(now, "fog", "albedo")->colour) << "shown as a colour";
  now = diagram({.around = {}, .open = {graph().get("sun").id}, .filter = ""});
  ASSERT_TRUE(row_of(now, "sun", "exposure"));
  EXPECT_EQ(row_of(now, "sun", "exposure")->value, "0");
  EXPECT_FALSE(row_of(now, "fog", "albedo"));
  session().execute("connectAttr sun.exposure fog.density_scale");
  EXPECT_TRUE(row_of(diagram(), "fog", "density_scale")) << "because it is connected";
}

TEST_F(NodeEditor, AroundWhatIsSelectedStandsAllThatItDependsOnAndDrives) {
  const auto names = [&](const char* node) {
    std::set<std::string> found;
    for (const NodeBox& box :
         diagram({.around = std::set{graph().get(node).id}, .open = {}, .filter = ""}).boxes)
      found.insert(box.name);
    return found;
  };
  EXPECT_EQ(names("fog"), (std::set<std::string>{"fog", "shape"}));
  EXPECT_EQ(names("shape"), (std::set<std::string>{"fog", "noise", "place", "shape"}));
  EXPECT_EQ(names("sun"), (std::set<std::string>{"sun"}));
}

TEST_F(NodeEditor, APlugIsHitBeforeTheBoxThatItStandsOn) {
  NodeMap map(session(), {});
  const Diagram& now = map.update();
  const DiagramHit wanted = at(now, "fog", "out", true);
  const NodeBox& box = now.boxes[wanted.box];
  EXPECT_EQ(hit(now, plug_place(box, wanted.row, true) + vec2(3.0f, -2.0f), 8.0f), wanted);
  EXPECT_EQ(hit(now, box.place + vec2(40.0f, 10.0f), 8.0f).part, DiagramPart::box);
  EXPECT_EQ(hit(now, box.place + vec2(box_width - 6.0f, 8.0f), 8.0f).part, DiagramPart::opener);
  EXPECT_EQ(hit(now, box.place - 50.0f, 8.0f).part, DiagramPart::nothing);
  EXPECT_EQ(boxes_within(now, box.place + size_of(box) + 2.0f, box.place - 2.0f), std::vector{wanted.box});
}

TEST_F(NodeEditor, APlugIsRefusedForTheReasonThatTheCommandWouldGiveAndForNoOther) {
  session().execute("lockAttr shape.volume");
  DiagramChoice all;
  for (const graph::Node* node : graph().nodes())
    if (node->name != "sun") all.open.insert(node->id);
  const Diagram now = diagram(all);
  std::size_t refused = 0, taken = 0;
  for (std::size_t b = 0; b < now.boxes.size(); ++b)
    for (std::size_t r = 0; r < now.boxes[b].rows.size(); ++r) {
      const PlugRow& from = now.boxes[b].rows[r];
      if (!from.gives) continue;
      ConnectDrag wire(graph(), now, {DiagramPart::giving_plug, b, r});
      for (const NodeBox& box : now.boxes)
        for (const PlugRow& to : box.rows) {
          if (!to.takes) continue;
          const std::string problem = wire.problem(graph(), to.plug, false);
          const std::string line =
              "connectAttr " + graph().name_of(from.plug) + " " + graph().name_of(to.plug) + " -force";
          const std::uint64_t before = graph().generation();
          std::string said;
          try {
            session().execute(line);
          } catch (const graph::GraphError& error) {
            said = error.what();
          }
          ++(said.empty() ? taken : refused);
          EXPECT_EQ(problem, said) << line;
          if (graph().generation() != before) session().execute("undo");
        }
    }
  EXPECT_GT(refused, 100u);
  EXPECT_GT(taken, 100u);
}

TEST_F(NodeEditor, AWireThatIsTakenToAnotherPlugBreaksAndConnects) {
  session().execute("createNode atfmVolume -name second");
  const Diagram now = diagram();
  ConnectDrag wire(graph(), now, at(now, "shape", "medium", false));
  EXPECT_TRUE(wire.wants_taker());
  ASSERT_TRUE(wire.taken_off());
  EXPECT_EQ(graph().name_of(wire.held()), "fog.out");
  EXPECT_EQ(wire.let_go(graph(), now, at(now, "second", "medium", false)),
            (std::vector<std::string>{"disconnectAttr shape.medium", "connectAttr fog.out second.medium"}));
  EXPECT_EQ(wire.let_go(graph(), now, {}), std::vector<std::string>{"disconnectAttr shape.medium"});
  EXPECT_TRUE(wire.let_go(graph(), now, at(now, "shape", "medium", false)).empty()) << "put back";
  EXPECT_TRUE(wire.let_go(graph(), now, at(now, "second", "volume", false)).empty()) << "cannot end there";
}

TEST_F(NodeEditor, ANewWireIsDrawnFromEitherEndAndTakesOver) {
  const Diagram now = diagram();
  ConnectDrag forth(graph(), now, at(now, "other", "out", true));
  EXPECT_EQ(forth.let_go(graph(), now, at(now, "shape", "medium", false)),
            std::vector<std::string>{"connectAttr other.out shape.medium -force"});
  EXPECT_TRUE(forth.let_go(graph(), now, {}).empty());
  session().execute("disconnectAttr shape.medium");
  const Diagram free = diagram();
  ConnectDrag back(graph(), free, at(free, "shape", "medium", false));
  EXPECT_FALSE(back.wants_taker());
  EXPECT_EQ(back.let_go(graph(), free, at(free, "other", "out", true)),
            std::vector<std::string>{"connectAttr other.out shape.medium"});
}

TEST_F(NodeEditor, PlacesStayThroughEditsUndoAndAnotherSession) {
  TemporaryFolder folder;
  const auto file = folder.path() / "node_places";
  const std::string scene = (folder.path() / "shot.plinian").string();
  vec2 fog_place, sun_place;
  {
    NodeMap map(session(), file);
    map.update();
    map.move(box_of(map.diagram(), "fog"), {-345.0f, 678.0f});
    sun_place = map.diagram().boxes[box_of(map.diagram(), "sun")].place;
    session().execute("delete fog");
    map.update();
    session().execute("undo");
    map.update();
    fog_place = map.diagram().boxes[box_of(map.diagram(), "fog")].place;
    EXPECT_EQ(fog_place, vec2(-345.0f, 678.0f)) << "undo brings it back to where it was";
    const bool modified = session().history().is_modified();
    map.move(box_of(map.diagram(), "fog"), {-340.0f, 680.0f});
    EXPECT_EQ(session().history().is_modified(), modified);
    session().execute("save \"" + scene + "\"");
    EXPECT_FALSE(session().history().is_modified());
    map.move(box_of(map.diagram(), "fog"), {-330.0f, 690.0f});
    EXPECT_FALSE(session().history().is_modified()) << "a place is no edit";
  }
  scene::Workspace other;
  NodeMap map(other.session(), file);
  other.session().execute("open \"" + scene + "\"");
  map.update();
  EXPECT_EQ(map.diagram().boxes[box_of(map.diagram(), "fog")].place, vec2(-330.0f, 690.0f));
  EXPECT_EQ(map.diagram().boxes[box_of(map.diagram(), "sun")].place, sun_place);
}

TEST_F(NodeEditor, AFailureIsToldOfTheNodeThatFailedAndOfThoseThatItBlocks) {
  session().execute("createNode volumeRead -name file");
  session().execute("setAttr file.file \"/nowhere/smoke.vdb\"");
  session().execute("connectAttr file.volume shape.volume -force");
  EXPECT_FALSE(failure_of(session(), graph().get("file").id)) << "nothing is computed to find out";
  session().evaluator().evaluate(graph().plug("file.volume"));
  const auto failure = failure_of(session(), graph().get("file").id);
  ASSERT_TRUE(failure);
  EXPECT_FALSE(failure->blocked);
  EXPECT_NE(failure->message.find("smoke.vdb"), std::string::npos) << failure->message;
  EXPECT_FALSE(failure_of(session(), graph().get("noise").id));
}

}  // namespace
}  // namespace plinian::window
