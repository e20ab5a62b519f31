// The life of draw data, with an override that says what is done to it.
#include "host/draw/draw_driver.h"

#include <thread>

#include "host/sdk/plugin.h"
#include "tests/host/draw/draw_scene.h"

namespace plinian::draw {
namespace {

using sdk::Attribute;

// What the override of "square" did and saw.
struct Log {
  std::atomic<int> prepares{0};
  std::thread::id prepared_on;
  int uploads = 0, draws = 0, releases = 0;
  std::uint32_t selection = 99;
  std::vector<std::string> lights;
  double frame = 0.0;
} log_of;

struct Square {
  float half, green;
  int slices;
  std::string fault;
};
struct SquareObjects {
  int uploaded = 0;
};

sdk::NodeType square() {
  sdk::NodeType type("square");
  type.hierarchical = true;
  const Attribute half = type.add({.name = "half", .default_value = "1"});
  const Attribute green = type.add({.name = "green", .default_value = "1"});
  const Attribute slices = type.add({.name = "slices", .type = "int", .default_value = "1"});
  const Attribute fault = type.add({.name = "fault", .type = "string"});
  type.add({.name = "note", .type = "string"});
  sdk::Draw<Square, SquareObjects> draw;
  draw.affected_by = "half green slices fault";
  draw.prepare = [=](sdk::Context& context) {
    ++log_of.prepares;
    log_of.prepared_on = std::this_thread::get_id();
    if (context.text(fault) == "prepare") throw sdk::Error("no data today");
    return std::make_unique<const Square>(Square{float(context.number(half)), float(context.number(green)),
                                                 int(context.number(slices)), context.text(fault)});
  };
  draw.upload = [](const sdk::Gl& gl, const Square& data, SquareObjects& objects) {
    ++log_of.uploads;
    if (data.fault == "upload") throw sdk::Error("no memory");
    if (data.fault == "function") {
      void (*function)() = nullptr;
      gl.load(function, "noSuchThing");
    }
    glEnable(GL_SCISSOR_TEST);  // to be put back
    return ++objects.uploaded >= data.slices;
  };
  draw.draw = [](const sdk::DrawContext& context, const Square& data, SquareObjects& objects) {
    ++log_of.draws;
    EXPECT_EQ(objects.uploaded, data.slices);
    log_of.selection = context.plain.selection;
    log_of.frame = context.plain.frame;
    log_of.lights.clear();
    for (std::size_t i = 0; i < context.plain.light_count; ++i)
      log_of.lights.push_back(std::string(context.plain.lights[i].name) + " " +
                              std::to_string(int(context.plain.lights[i].power[0])) + " " +
                              (context.plain.light_maps[i] ? context.plain.light_maps[i]->glsl : "none"));
    if (data.fault == "draw") throw sdk::Error("no ink");
    if (data.fault == "error") glEnable(GL_TEXTURE_2D + 12345);
    const auto clip = context.clip_from_object();
    const int middle = DrawScene::size / 2, half_pixels = int(data.half * clip[0] * float(middle));
    glEnable(GL_SCISSOR_TEST);
    glScissor(middle - half_pixels, middle - half_pixels, 2 * half_pixels, 2 * half_pixels);
    glClearColor(0.0f, data.green, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  };
  draw.release = [](const sdk::Gl&, SquareObjects&) { ++log_of.releases; };
  draw.hit = [](const sdk::DrawContext&, const Square& data, float x, float y) -> std::optional<double> {
    const float middle = DrawScene::size / 2.0f, reach = data.half * middle / 2.0f;
    if (std::abs(x - middle) > reach || std::abs(y - middle) > reach) return std::nullopt;
    return double(data.half);
  };
  type.draw = sdk::draw_override(draw);
  return type;
}

void initialise(sdk::Plugin& plugin) {
  plugin.add(square());
}
PLINIAN_LINKED_PLUGIN(squares, "squares", "1.0", "A. Artist", "node:square", initialise);

struct SquareScene : DrawScene {
  SquareScene() {
    log_of.prepares = 0;
    log_of.uploads = log_of.draws = log_of.releases = 0;
    plugins.add_linked(squares);
    run("createNode square -name s");
  }
  int green_pixels(const std::vector<std::array<unsigned char, 4>>& picture) {
    return int(
        std::count_if(picture.begin(), picture.end(), [](const auto& pixel) { return pixel[1] == 255; }));
  }
  graph::NodeId node(const std::string& name) { return session.graph().get(name).id; }
  DrawDriver::Place everywhere() {
    return [this](graph::NodeId id) { return place(id); };
  }
};

TEST(DrawDriver, PreparesOnWorkersAndDrawsWhatTheNodeSays) {
  SquareScene s;
  EXPECT_EQ(s.green_pixels(s.picture()), 32 * 32);
  EXPECT_NE(log_of.prepared_on, std::this_thread::get_id());
  s.run("setAttr s.half 0.5");
  EXPECT_EQ(s.green_pixels(s.picture()), 16 * 16);
  s.hidden.insert(s.node("s"));
  EXPECT_EQ(s.green_pixels(s.picture()), 0);
}

TEST(DrawDriver, IsCleanUntilAnAttributeChangesThatAffectsDrawing) {
  SquareScene s;
  s.picture();
  s.run("setAttr s.note \"hello\"\nselect s\ncurrentTime 5\ncreateNode time");
  s.picture();
  EXPECT_EQ(log_of.prepares, 1);
  EXPECT_EQ(log_of.uploads, 1);
  EXPECT_EQ(log_of.draws, 2);
  s.run("setAttr s.half 0.5");
  s.picture();
  EXPECT_EQ(log_of.prepares, 2);
  EXPECT_EQ(log_of.uploads, 2);
  s.run("undo");
  EXPECT_EQ(s.green_pixels(s.picture()), 32 * 32);
  EXPECT_EQ(log_of.prepares, 2);  // found again
}

TEST(DrawDriver, GoesOnDrawingTheOldWhileTheNewIsUploadedInSlices) {
  SquareScene s;
  s.picture();
  s.run("setAttr s.half 0.5\nsetAttr s.slices 3");
  s.prepare();
  EXPECT_TRUE(s.driver->upload(std::chrono::seconds(0)));
  EXPECT_EQ(s.green_pixels(s.drawn()), 32 * 32);
  EXPECT_EQ(log_of.releases, 0);
  while (s.driver->upload(std::chrono::milliseconds(1))) {
  }
  EXPECT_EQ(s.green_pixels(s.drawn()), 16 * 16);
  EXPECT_EQ(log_of.uploads, 1 + 3);
  EXPECT_EQ(log_of.releases, 1);
}

TEST(DrawDriver, ReleasesWhatWentAndWhatWasNeverShown) {
  {
    SquareScene s;
    // Not the same as the other: two workers may compute what is the same twice, and one of both is kept.
    s.run("createNode square -name t\nsetAttr t.half 0.5");
    s.picture();
    s.run("delete t");
    s.picture();
    EXPECT_EQ(log_of.releases, 1);
    s.run("setAttr s.slices 1000000");
    s.prepare();
    s.driver->upload(std::chrono::microseconds(100));
    s.run("setAttr s.slices 1");  // overtaken in the middle of its upload
    s.picture();
    EXPECT_EQ(log_of.releases, 2);  // what was shown all the while is what is wanted again
    EXPECT_EQ(s.green_pixels(s.drawn()), 32 * 32);
  }
  EXPECT_EQ(log_of.releases, 3);
}

TEST(DrawDriver, TellsTheOverrideAboutLightsSelectionAndTime) {
  SquareScene s;
  Light lamp;
  lamp.name = "lamp";
  lamp.intensity = 8.0f;
  s.view.lights = {{lamp, {77, 78, 0, std::make_shared<const std::string>("text")}}};
  s.run("select -clear\ncurrentTime 12");
  s.picture();
  EXPECT_EQ(log_of.lights, std::vector<std::string>{"lamp 8 text"});
  EXPECT_EQ(log_of.selection, 0u);
  EXPECT_EQ(log_of.frame, 12.0);
  s.run("createNode square -name t\nselect s t");
  s.hidden = {s.node("t")};
  s.picture();
  EXPECT_EQ(log_of.selection, 1u);
  s.run("select t s");
  s.picture();
  EXPECT_EQ(log_of.selection, 2u);
}

TEST(DrawDriver, PutsTheStateBackAroundEveryCall) {
  SquareScene s;
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0.25f, 0.5f, 0.75f, 1.0f);
  s.picture();
  EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
  std::array<float, 4> colour{};
  glGetFloatv(GL_COLOR_CLEAR_VALUE, colour.data());
  EXPECT_EQ(colour, (std::array<float, 4>{0.25f, 0.5f, 0.75f, 1.0f}));
}

TEST(DrawDriver, AFailureIsToldOnceAndEndsWithTheDataThatCauseIt) {
  SquareScene s;
  s.picture();
  const auto failing = [&](const std::string& fault) {
    s.run("setAttr s.fault \"" + fault + "\"");
    s.picture();
    s.picture();
    return s.driver->take_reports();
  };
  EXPECT_EQ(failing("draw"), std::vector<std::string>{"s: draw failed: no ink"});
  EXPECT_EQ(failing("error"), std::vector<std::string>{"s: draw failed: it left the GL error 0x0500"});
  EXPECT_EQ(failing("upload"), std::vector<std::string>{"s: upload failed: no memory"});
  EXPECT_EQ(failing("function"),
            std::vector<std::string>{"s: upload failed: there is no GL function noSuchThing"});
  EXPECT_EQ(s.green_pixels(s.picture()), 0);
  s.run("setAttr s.fault \"\"");
  EXPECT_EQ(s.green_pixels(s.picture()), 32 * 32);
  // What cannot be prepared leaves the last good drawing.
  EXPECT_EQ(failing("prepare"), std::vector<std::string>{"s: prepare failed: no data today"});
  EXPECT_EQ(s.green_pixels(s.picture()), 32 * 32);
  EXPECT_EQ(s.session.evaluator().take_reports(), std::vector<std::string>{"s.drawData: no data today"});
}

// A parameter that is dragged makes other data each time, which fail in the same way.
TEST(DrawDriver, ACauseIsToldAgainOnlyWhenItWasGone) {
  SquareScene s;
  s.run("setAttr s.fault draw");
  s.picture();
  EXPECT_TRUE(s.driver->drawable().empty());
  EXPECT_EQ(s.driver->take_reports().size(), 1u);
  s.run("setAttr s.half 0.5");
  s.picture();
  EXPECT_TRUE(s.driver->take_reports().empty());
  s.run("setAttr s.fault \"\"");
  s.picture();
  EXPECT_EQ(s.driver->drawable(), std::vector<graph::NodeId>{s.node("s")});
  s.run("setAttr s.fault draw");
  s.picture();
  EXPECT_EQ(s.driver->take_reports(), std::vector<std::string>{"s: draw failed: no ink"});
}

TEST(DrawDriver, FindsTheNearestNodeUnderAPixel) {
  SquareScene s;
  s.run("createNode square -name near\nsetAttr near.half 0.5");
  s.picture();
  const auto hit = [&](float x, float y) { return s.driver->hit(s.view, s.everywhere(), {x, y}); };
  ASSERT_TRUE(hit(32, 32));
  EXPECT_EQ(hit(32, 32)->node, s.node("near"));
  EXPECT_EQ(hit(32, 32)->distance, 0.5);
  EXPECT_EQ(hit(20, 32)->node, s.node("s"));
  EXPECT_FALSE(hit(2, 2));
  s.hidden = {s.node("near")};
  EXPECT_EQ(hit(32, 32)->node, s.node("s"));
}

}  // namespace
}  // namespace plinian::draw
