// What panels show and send, without a window: rows by schema, commands of fields, console, completion,
// panes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/scene/placement.h"
#include "host/scene/workspace.h"
#include "host/window/console/completion.h"
#include "host/window/console/console_log.h"
#include "host/window/console/news.h"
#include "host/window/console/wrapped_rows.h"
#include "host/window/drawing/shortened.h"
#include "host/window/fields/attribute_rows.h"
#include "host/window/fields/edit_lines.h"
#include "host/window/navigation/key_light.h"
#include "host/window/panels/layout.h"
#include "host/window/panels/look_gallery.h"
#include "host/window/panels/status_line.h"

namespace plinian::window {
namespace {

const AttributeRow* row_of(const std::vector<AttributeGroup>& groups, const std::string& label) {
  for (const AttributeGroup& group : groups)
    for (const AttributeRow& row : group.rows)
      if (row.label == label) return &row;
  return nullptr;
}

TEST(News, AnErrorStaysUntilSomethingIsDoneOrItIsRead) {
  using std::chrono::seconds;
  ConsoleLog log;
  News news;
  const News::Time now{};
  const auto said = [&](int second) {
    news.update(log, now + seconds(second));
    const ConsoleLine* line = news.line(now + seconds(second));
    return line ? line->text : "";
  };
  EXPECT_EQ(said(0), "");
  log.add(LineKind::error, "nonsense: there is no such command");
  EXPECT_EQ(said(0), "nonsense: there is no such command");
  EXPECT_EQ(said(9), "nonsense: there is no such command");
  EXPECT_EQ(said(16), "");
  log.add(LineKind::error, "nonsense: there is no such command");
  EXPECT_EQ(said(20), "nonsense: there is no such command") << "once more";
  for (int i = 0; i < 9; ++i) log.echo("setAttr fog.g 0." + std::to_string(i), "drag 1");
  EXPECT_EQ(said(21), "") << "something was done";
  log.echo("import smoke.vdb", "");
  log.add(LineKind::note, "smoke.vdb: 2 x 3 x 2 m at (0, 0, 0)");
  log.echo("select smoke_place", "");
  EXPECT_EQ(said(22), "smoke.vdb: 2 x 3 x 2 m at (0, 0, 0)") << "what was noted is read";
  EXPECT_EQ(said(30), "");
  log.clear();
  EXPECT_EQ(said(31), "");
}

TEST(Shortened, LeavesRoomForTheDotsAndLettersWhole) {
  const auto width = [](const std::string& text) { return float(text.size()); };
  EXPECT_EQ(shortened("as it is", 8.0f, width), "as it is");
  EXPECT_EQ(shortened("as it is not", 8.0f, width), "as it...");
  EXPECT_EQ(shortened("größer als der Platz", 6.0f, width), "gr...") << "no half of a letter";
  EXPECT_EQ(shortened("anything", 0.0f, width), "...");
}

TEST(AttributeRows, FollowTheDeclaration) {
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  session.execute("createNode medium -name fog");
  const auto groups = [&] { return attribute_groups(session.graph(), session.graph().get("fog")); };
  const AttributeRow* albedo = row_of(groups(), "Albedo");
  ASSERT_TRUE(albedo);
  EXPECT_EQ(row_of(groups(), "Sigma s"), nullptr) << "shown only while coefficients reads as sigma";
  EXPECT_EQ(row_of(groups(), "Look hash"), nullptr) << "hidden";
  EXPECT_EQ(row_of(groups(), "Out"), nullptr) << "computed";
  session.execute("setAttr fog.coefficients sigma");
  EXPECT_EQ(row_of(groups(), "Albedo"), nullptr);
  const auto now = groups();
  const AttributeRow* sigma = row_of(now, "Sigma s");
  ASSERT_TRUE(sigma);
  EXPECT_EQ(sigma->parts.size(), 3u);
  EXPECT_EQ(part_label(session.graph(), *sigma, 0), "r");
  EXPECT_FALSE(sigma->changed);
  session.execute("setAttr fog.sigma_s 1 2 3");
  EXPECT_TRUE(row_of(groups(), "Sigma s")->changed);
  session.execute("resetAttr fog.sigma_s");
  EXPECT_FALSE(row_of(groups(), "Sigma s")->changed);
}

TEST(AttributeRows, AreShownWhereASwitchIsOn) {
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  graph::NodeTypeSpec spec;
  spec.name = "lamp";
  graph::AttributeSpec flag{.name = "flag", .type = graph::AttributeType::boolean, .default_value = false};
  graph::AttributeSpec size{.name = "size"};
  size.layout.shown_when = "flag";
  spec.attributes = {flag, size};
  session.types().add(std::move(spec));
  session.execute("createNode lamp -name l");
  const auto groups = [&] { return attribute_groups(session.graph(), session.graph().get("l")); };
  EXPECT_EQ(row_of(groups(), "Size"), nullptr);
  session.execute("setAttr l.flag on");
  EXPECT_NE(row_of(groups(), "Size"), nullptr);
}

TEST(AttributeRows, ThreeNumbersUnderOneNameAreARowAndDeepOnesAGroup) {
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  session.execute("createNode transform -name place");
  session.execute("createNode renderSettings -name settings");
  const auto place = attribute_groups(session.graph(), session.graph().get("place"));
  ASSERT_TRUE(row_of(place, "Translate"));
  EXPECT_EQ(row_of(place, "Translate")->parts.size(), 3u);
  session.execute("setAttr place.translate.y 2");
  const auto moved = attribute_groups(session.graph(), session.graph().get("place"));
  EXPECT_TRUE(row_of(moved, "Translate")->changed);
  const auto settings = attribute_groups(session.graph(), session.graph().get("settings"));
  const auto map = std::find_if(settings.begin(), settings.end(),
                                [](const AttributeGroup& g) { return g.title == "Fast · Map"; });
  ASSERT_NE(map, settings.end());
  EXPECT_FALSE(map->open);
  EXPECT_GT(map->rows.size(), 5u);
}

TEST(EditLines, EditWhatIsSelectedTogether) {
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  session.execute("createNode directionalLight -name a");
  session.execute("createNode spotLight -name b");
  session.execute("createNode camera -name c");
  session.execute("select a b c");
  const graph::Plug plug = session.graph().plug("a.exposure");
  EXPECT_EQ(set_lines(session.graph(), plug, "2"),
            (std::vector<std::string>{"setAttr a.exposure 2", "setAttr b.exposure 2"}));
  session.execute("select b");
  EXPECT_EQ(set_lines(session.graph(), plug, "2"), std::vector<std::string>{"setAttr a.exposure 2"})
      << "what is not selected is edited alone";
  EXPECT_EQ(reset_lines(session.graph(), plug), std::vector<std::string>{"resetAttr a.exposure"});
  EXPECT_EQ(number_at(session.graph(), session.graph().plug("a.colour.g")), 1.0);
}

// A drag of two lights at once: many commands, one step of undo.
TEST(EditLines, ADragIsOneStep) {
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  session.execute("createNode directionalLight -name a");
  session.execute("createNode directionalLight -name b");
  session.execute("select a b");
  const std::size_t before = session.history().undo_names().size();
  const graph::Plug plug = session.graph().plug("a.exposure");
  for (const char* value : {"0.1", "0.2", "0.3"})
    for (const std::string& line : set_lines(session.graph(), plug, value)) session.execute(line, "drag 1");
  session.history().end_merge();
  EXPECT_EQ(session.history().undo_names().size(), before + 1);
  session.execute("undo");
  EXPECT_EQ(number_at(session.graph(), session.graph().plug("b.exposure")), 0.0);
}

std::vector<std::string> wrapped(const std::vector<std::string>& lines, int columns) {
  ConsoleLog log;
  for (const std::string& line : lines) log.add(LineKind::note, line);
  std::vector<std::string> rows;
  for (const WrappedRow& row : wrapped_rows(log.lines(), columns)) rows.push_back(row.text);
  return rows;
}

TEST(WrappedRows, LoseNothingOfALineThatIsLongerThanThePane) {
  EXPECT_EQ(wrapped({"short", ""}, 20), (std::vector<std::string>{"short", ""}));
  EXPECT_EQ(wrapped({"setAttr medium.albedo 0.5 0.4"}, 15),
            (std::vector<std::string>{"setAttr", "  medium.albedo", "  0.5 0.4"}))
      << "a word that fits is whole";
  EXPECT_EQ(wrapped({"abcdefghijklmnop"}, 8), (std::vector<std::string>{"abcdefgh", "  ijklmn", "  op"}))
      << "one that does not is cut";
  EXPECT_EQ(wrapped({"two\nlines"}, 20), (std::vector<std::string>{"two", "  lines"}));
  EXPECT_EQ(wrapped({"\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4"}, 8),
            (std::vector<std::string>{"\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4", "  \u00e4"}))
      << "letters are not bytes";
  EXPECT_EQ(wrapped({"again", "again"}, 8), (std::vector<std::string>{"again", "  (2", "  times)"}));
}

TEST(ConsoleLog, ATimeThatRunsIsOneLine) {
  ConsoleLog log;
  log.echo("setAttr key.exposure 1", "");
  for (int frame = 2; frame < 90; ++frame) log.echo("currentTime " + std::to_string(frame), "");
  ASSERT_EQ(log.lines().size(), 2u);
  EXPECT_EQ(log.lines().back().text, "currentTime 89");
  log.echo("select key", "");
  log.echo("currentTime 90", "");
  EXPECT_EQ(log.lines().size(), 4u) << "what was done in between keeps its place";
}

TEST(ConsoleLog, FoldsADragAndCountsRepeats) {
  ConsoleLog log;
  log.echo("setAttr a.exposure 1", "drag 1");
  log.echo("setAttr b.exposure 1", "drag 1");
  log.echo("setAttr a.exposure 2", "drag 1");
  log.echo("setAttr b.exposure 2", "drag 1");
  ASSERT_EQ(log.lines().size(), 2u);
  EXPECT_EQ(log.lines()[0].text, "setAttr a.exposure 2");
  EXPECT_EQ(log.lines()[1].text, "setAttr b.exposure 2");
  log.echo("setAttr a.exposure 3", "drag 2");
  EXPECT_EQ(log.lines().size(), 3u) << "another drag";
  log.add(LineKind::warning, "careful");
  log.add(LineKind::warning, "careful");
  EXPECT_EQ(log.lines().back().repeats, 2);
}

TEST(Completion, KnowsCommandsFlagsNodesAttributesAndTypes) {
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  session.execute("createNode directionalLight -name key");
  const auto words = [&](const char* line) { return complete(session, line).words; };
  EXPECT_EQ(words("setA"), std::vector<std::string>{"setAttr"});
  EXPECT_EQ(words("setAttr k"), std::vector<std::string>{"key."});
  EXPECT_EQ(words("setAttr key.expo"), std::vector<std::string>{"key.exposure"});
  EXPECT_EQ(words("select -r"), std::vector<std::string>{"-remove"});
  EXPECT_EQ(words("createNode spotL"), std::vector<std::string>{"spotLight"});
  EXPECT_EQ(complete(session, "setAttr key.rotate_").common, "key.rotate_order");
  EXPECT_TRUE(words("nonsense k").empty());
}

TEST(KeyLight, IsTheSelectedOneOrTheOneCalledKey) {
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  EXPECT_FALSE(light_to_turn(session.graph()));
  session.execute("createNode directionalLight -name rim");
  session.execute("createNode directionalLight -name key");
  session.execute("select -clear");
  EXPECT_EQ(light_to_turn(session.graph()), session.graph().get("key").id);
  session.execute("select rim");
  EXPECT_EQ(light_to_turn(session.graph()), session.graph().get("rim").id);
}

dvec3 direction_after(const LightStand& stand, dvec2 points) {
  Placement turned = stand.placement;
  turned.rotate = turned_light(stand, points).value();
  return normalize(dvec3((stand.world_from_parent * matrix_of(turned))[2]));
}

TEST(KeyLight, ComesFromTheRightWhenItIsDraggedThere) {
  const LightStand front;  // shines along -z: it comes from +z
  const dvec3 right = direction_after(front, {100.0, 0.0});
  EXPECT_GT(right.x, 0.5);
  EXPECT_NEAR(right.y, 0.0, 1e-3);
  const dvec3 above = direction_after(front, {0.0, -100.0});
  EXPECT_GT(above.y, 0.5);
  EXPECT_LT(direction_after(front, {0.0, -1e6}).y, 1.0) << "never over the top";
}

TEST(KeyLight, IsDraggedInTheWorldWhateverItIsUnder) {
  LightStand stand;
  stand.placement.order = RotateOrder::zyx;
  stand.world_from_parent = matrix_of({.rotate = {0.0, 90.0, 30.0}});
  const dvec3 before = direction_after(stand, {0.0, 0.0});
  const dvec3 above = direction_after(stand, {0.0, -40.0});
  EXPECT_NEAR(glm::degrees(std::asin(above.y) - std::asin(before.y)), 20.0, 0.05);
  EXPECT_NEAR(std::atan2(above.x, above.z), std::atan2(before.x, before.z), 1e-3);
  stand.world_from_parent = matrix_of({.scale = {1.0, 0.0, 1.0}});
  EXPECT_FALSE(turned_light(stand, {1.0, 1.0}));
}

TEST(Layout, NothingOverlapsAndThePictureKeepsItsRoom) {
  for (const vec2 room : {vec2(1440, 900), vec2(720, 480), vec2(2560, 1440)}) {
    const Panes panes = lay_out({}, room, 22.0f, 30.0f, 24.0f, 1.0f, true);
    const PaneRect all[] = {panes.menu,       panes.outliner, panes.lights, panes.picture,
                            panes.attributes, panes.timeline, panes.bottom, panes.status};
    for (const PaneRect& a : all) {
      EXPECT_GE(a.begin.x, 0.0f);
      EXPECT_LE(a.begin.x + a.size.x, room.x + 0.5f);
      EXPECT_LE(a.begin.y + a.size.y, room.y + 0.5f);
      for (const PaneRect& b : all)
        if (&a != &b) {
          const vec2 begin = glm::max(a.begin, b.begin), end = glm::min(a.begin + a.size, b.begin + b.size);
          EXPECT_FALSE(end.x > begin.x && end.y > begin.y);
        }
    }
    EXPECT_GE(panes.picture.size.x, 199.0f);
    EXPECT_GE(panes.picture.size.y, 150.0f);
    EXPECT_GT(lay_out({}, room, 22.0f, 30.0f, 24.0f, 1.0f, false).picture.size.x, panes.picture.size.x);
  }
}

// A reference is as large as the pane was when it was rendered.
TEST(Layout, ThePictureIsAsLargeWhateverIsShownBeneath) {
  const PaneSizes console = read_pane_sizes("bottom 260\nnodes 400\n");
  PaneSizes nodes = console;
  nodes.shows_nodes = true;
  const vec2 room(1440, 900);
  const Panes a = lay_out(console, room, 22.0f, 30.0f, 24.0f, 1.0f, true);
  const Panes b = lay_out(nodes, room, 22.0f, 30.0f, 24.0f, 1.0f, true);
  EXPECT_EQ(a.bottom.size.y, 260.0f);
  EXPECT_EQ(b.picture.size, a.picture.size);
  EXPECT_EQ(b.bottom.size, a.bottom.size);
}

TEST(Layout, PanesAreRememberedAndNonsenseIsNot) {
  PaneSizes sizes;
  sizes.left = 301.0f;
  sizes.outliner = 0.5f;
  EXPECT_EQ(read_pane_sizes(text_of(sizes)).left, 301.0f);
  EXPECT_EQ(read_pane_sizes(text_of(sizes)).outliner, 0.5f);
  EXPECT_FALSE(read_pane_sizes(text_of(sizes)).probe) << "it was not dragged";
  sizes.probe = ProbeSpot{{0.75f, 0.125f}, {340.0f, 312.0f}};
  EXPECT_EQ(read_pane_sizes(text_of(sizes)).probe, sizes.probe);
  EXPECT_EQ(read_pane_sizes("left nan\nright 1e9\nwrong").left, PaneSizes().left);
  EXPECT_LE(read_pane_sizes("right 1e9").right, 1200.0f);
}

TEST(StatusLine, APictureOfNothingIsNotSaidToBeAtRest) {
  ViewPicture picture;
  picture.at_rest = true;
  EXPECT_EQ(state_of(picture, "reading smoke.vdb"), "reading smoke.vdb");
  EXPECT_EQ(state_of(picture, ""), "nothing to see");
  picture.passes = 4;
  EXPECT_EQ(state_of(picture, ""), "at rest, 4 passes");
  EXPECT_EQ(state_of(picture, "reading smoke.vdb"), "at rest, 4 passes") << "it stays while the next is read";
  picture.at_rest = false;
  picture.scene.quality.view.passes = 32;
  EXPECT_EQ(state_of(picture, "rendering"), "pass 4 of 32 at most");
  picture.quick = true;
  EXPECT_EQ(state_of(picture, "rendering"), "quick");
}

TEST(PictureGrid, ShowsAllAtOnceAsLargeAsTheRoomAllows) {
  for (const vec2 room : {vec2(800, 700), vec2(300, 400), vec2(500, 120), vec2(240, 90), vec2(200, 200)})
    for (const int count : {1, 4, 9})
      for (const float aspect : {0.6f, 1.0f, 1.78f}) {
        const PictureGrid grid = picture_grid(count, room, aspect, 27.0f, 10.0f, 50.0f, 96.0f);
        ASSERT_GE(grid.columns, 1);
        ASSERT_LE(grid.columns, count);
        EXPECT_LE(grid.height, 96.0f);
        if (grid.height <= 16.0f) continue;
        const int rows = (count + grid.columns - 1) / grid.columns;
        EXPECT_LE(float(rows) * (grid.height + 27.0f), room.y) << count << " in " << room.x << "x" << room.y;
        EXPECT_LE(float(grid.columns) * (grid.height * aspect + 10.0f) + 10.0f, room.x);
      }
  EXPECT_EQ(picture_grid(4, {800, 700}, 1.0f, 27.0f, 10.0f, 50.0f, 96.0f).columns, 1) << "a column beside it";
  EXPECT_EQ(picture_grid(4, {500, 130}, 1.0f, 27.0f, 10.0f, 50.0f, 96.0f).columns, 4);
}

}  // namespace
}  // namespace plinian::window
