// A plug-in's own shader looks up how much of a light arrives, in the maps that the renderer made.
#include "host/sdk/plugin.h"
#include "tests/host/draw/draw_scene.h"
#include "viewport/light_map_upload.h"

namespace plinian::draw {
namespace {

// Draws the plane z = 0 in the colour of what arrives there of the light whose number is `light`.
struct Gauge {
  std::size_t light;
};
struct GaugeObjects {
  GLuint array = 0;
};

constexpr const char* vertex_text =
    "#version 450\n"
    "out vec2 gauge_place;\n"
    "void main() {\n"
    "  gauge_place = vec2(gl_VertexID == 1 ? 6.0 : -2.0, gl_VertexID == 2 ? 6.0 : -2.0);\n"
    "  gl_Position = vec4(gauge_place * 0.5, 0.0, 1.0);\n"
    "}\n";
constexpr const char* fragment_text =
    "in vec2 gauge_place;\n"
    "out vec4 gauge_colour;\n"
    "layout(location = 9) uniform int gauge_light;\n"
    "void main() { gauge_colour = vec4(plinian_light(gauge_light, vec3(gauge_place, 0.0)), 1.0); }\n";

GLuint compile(GLenum stage, const std::vector<const char*>& texts) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, GLsizei(texts.size()), texts.data(), nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  std::string log(2000, '\0');
  if (!good) glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
  EXPECT_TRUE(good) << log;
  return shader;
}

void draw_gauge(const sdk::DrawContext& context, const Gauge& gauge, GaugeObjects& objects) {
  const PlinianLightMap* map = context.plain.light_maps[gauge.light];
  if (!map) throw sdk::Error("the light has no map");
  const GLuint program = glCreateProgram();
  for (const GLuint shader : {compile(GL_VERTEX_SHADER, {vertex_text}),
                              compile(GL_FRAGMENT_SHADER, {"#version 450\n", map->glsl, fragment_text})}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  glUseProgram(program);
  constexpr GLuint unit = 3, binding = 5;
  glBindTextureUnit(unit, map->texels);
  glUniform1i(glGetUniformLocation(program, "plinian_map_texels"), unit);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, map->block);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "PlinianLights"), binding);
  glUniform1i(9, map->light);
  glBindVertexArray(objects.array);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glUseProgram(0);
  glDeleteProgram(program);
}

void initialise(sdk::Plugin& plugin) {
  sdk::NodeType type("gauge");
  type.hierarchical = true;
  const sdk::Attribute light = type.add({.name = "light", .type = "int"});
  sdk::Draw<Gauge, GaugeObjects> draw;
  draw.prepare = [=](sdk::Context& context) {
    return std::make_unique<const Gauge>(Gauge{std::size_t(context.number(light))});
  };
  draw.upload = [](const sdk::Gl&, const Gauge&, GaugeObjects& objects) {
    glCreateVertexArrays(1, &objects.array);
    return true;
  };
  draw.draw = draw_gauge;
  draw.release = [](const sdk::Gl&, GaugeObjects& objects) { glDeleteVertexArrays(1, &objects.array); };
  type.draw = sdk::draw_override(draw);
  plugin.add(type);
}
PLINIAN_LINKED_PLUGIN(gauges, "gauges", "1.0", "A. Artist", "node:gauge", initialise);

// Length of the way from p toward a direction, no further than `reach`, within the unit ball.
double way_inside(dvec3 p, dvec3 toward, double reach) {
  const double b = dot(p, toward), c = dot(p, p) - 1.0, square = b * b - c;
  if (square <= 0.0) return 0.0;
  const double root = std::sqrt(square);
  return std::max(0.0, std::min(-b + root, reach) - std::max(-b - root, 0.0));
}

struct GaugeScene : DrawScene {
  std::unique_ptr<Renderer> renderer = make_gl_renderer_on_current_context();
  SceneSnapshot scene;

  GaugeScene() {
    plugins.add_linked(gauges);
    run("createNode gauge -name g");
    Medium ball{.shape = MediumShape::sphere, .density_scale = 1.0f};
    ball.sigma_s = vec3(0.8f, 0.4f, 0.2f);
    ball.sigma_a = vec3(0.2f, 0.2f, 0.1f);
    scene.media = {ball};
    scene.lights = {Light{.type = LightType::directional, .toward = vec3(1, 0, 0)},
                    Light{.type = LightType::point, .position = vec3(0.5f, 2.5f, 0.0f)},
                    Light{.type = LightType::spot,
                          .toward = vec3(-1, 0, 0),
                          .position = vec3(-1.5f, 0.0f, 0.0f),
                          .cone_angle = 100.0f}};
    scene.width = scene.height = 16;
    scene.camera = look_at(dvec3(0, 0, 6), dvec3(0), dvec3(0, 1, 0), 40.0);
    scene.quality.map.resolution = 256;
  }
  ~GaugeScene() { driver.reset(); }
  // Mean and largest difference to what a homogeneous ball lets through, away from its rim.
  std::pair<double, double> error_of(std::size_t light) {
    run("setAttr g.light " + std::to_string(light));
    const auto pixels = picture();
    const vec3 sigma_t = scene.media[0].sigma_s + scene.media[0].sigma_a;
    double sum = 0.0, most = 0.0, shadow = 0.0;
    int count = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const dvec3 p((x + 0.5) / 16.0 - 2.0, (y + 0.5) / 16.0 - 2.0, 0.0);
        const Light& lamp = scene.lights[light];
        const dvec3 way = lamp.type != LightType::directional ? dvec3(lamp.position) - p : dvec3(lamp.toward);
        const double reach = lamp.type != LightType::directional ? length(way) : 1e9;
        const dvec3 toward = way / length(way);
        if (std::abs(length(p - dot(p, toward) * toward) - 1.0) < 0.05) continue;  // grazes it
        for (int channel = 0; channel < 3; ++channel) {
          const double truth = std::exp(-sigma_t[channel] * way_inside(p, toward, reach));
          const double seen = pixels[std::size_t(y * size + x)][std::size_t(channel)] / 255.0;
          sum += std::abs(seen - truth);
          most = std::max(most, std::abs(seen - truth));
          shadow += 1.0 - truth;
          ++count;
        }
      }
    EXPECT_GT(shadow / count, 0.05) << "there is something to be wrong about";
    return {sum / count, most};
  }
};

TEST(LightMap, AShaderOfAPluginLooksUpWhatArrivesOfEachLight) {
  GaugeScene s;
  s.renderer->render(s.scene, 1);
  s.view.lights = lights_of(s.scene, light_maps(*s.renderer));
  ASSERT_EQ(s.view.lights.size(), 3u);
  for (const std::size_t light : {0u, 1u, 2u}) {
    const auto [mean, most] = s.error_of(light);
    EXPECT_LT(mean, 0.01) << light;
    EXPECT_LT(most, 0.08) << light;
  }
  EXPECT_TRUE(s.driver->take_reports().empty());
  EXPECT_EQ(s.view.lights[0].map.glsl, s.view.lights[1].map.glsl);
}

TEST(LightMap, ThereIsNoneWhereThePictureHasNone) {
  GaugeScene s;
  EXPECT_EQ(lights_of(s.scene, light_maps(*s.renderer))[0].map.glsl, nullptr) << "no picture yet";
  s.renderer->render(s.scene, 1);
  EXPECT_NE(lights_of(s.scene, light_maps(*s.renderer))[1].map.glsl, nullptr);
  const auto before = lights_of(s.scene, light_maps(*s.renderer))[0].map.glsl;
  s.renderer->render(s.scene, 1);
  EXPECT_EQ(lights_of(s.scene, light_maps(*s.renderer))[0].map.glsl, before) << "the same program will do";
  s.scene.quality.map.resolution = 128;
  s.renderer->render(s.scene, 1);
  EXPECT_EQ(lights_of(s.scene, light_maps(*s.renderer))[0].map.glsl, before) << "whatever their size";
  s.scene.quality.map.resolution = 256;
  s.scene.quality.map.coefficients = 9;
  s.renderer->render(s.scene, 1);
  EXPECT_NE(lights_of(s.scene, light_maps(*s.renderer))[0].map.glsl, before);
  s.scene.quality.map.coefficients = 6;
  s.renderer->render(s.scene, 1);
  EXPECT_EQ(lights_of(s.scene, light_maps(*s.renderer))[0].map.glsl, before) << "as it was made before";
  s.scene.media.clear();
  s.renderer->render(s.scene, 1);
  EXPECT_EQ(lights_of(s.scene, light_maps(*s.renderer))[0].map.glsl, nullptr);
  s.view.lights = lights_of(s.scene, light_maps(*s.renderer));
  s.picture();
  EXPECT_EQ(s.driver->take_reports(), std::vector<std::string>{"g: draw failed: the light has no map"});
}

// Uploads all of it; how often that took another turn.
int upload_all(LightMapUpload& upload, const LightMapCopyPtr& copy, std::chrono::microseconds budget) {
  int turns = 1;
  while (upload.upload(copy, budget)) ++turns;
  return turns;
}

TEST(LightMap, ACopyOnAContextThatSharesNothingTellsTheSame) {
  GaugeScene s;
  s.renderer->render(s.scene, 1);
  // The same picture by a renderer with a context of its own, whose maps go through memory.
  LightMapCopyPtr copy;
  {
    const std::unique_ptr<Renderer> other = make_gl_renderer();
    EXPECT_EQ(copy_light_maps(*other, nullptr), nullptr) << "no picture yet";
    other->render(s.scene, 1);
    copy = copy_light_maps(*other, nullptr);
  }
  ASSERT_TRUE(copy) << "and outlives the renderer that made it";
  s.context.make_current();
  LightMapUpload upload;
  EXPECT_GT(upload_all(upload, copy, std::chrono::microseconds(1)), 1) << "in slices";
  ASSERT_EQ(upload.maps().size(), 3u);
  for (const std::size_t light : {0u, 1u, 2u}) {
    s.view.lights = lights_of(s.scene, upload.maps());
    const auto [mean, most] = s.error_of(light);
    EXPECT_LT(mean, 0.01) << light;
    EXPECT_LT(most, 0.08) << light;
    const auto copied = s.drawn();
    s.view.lights = lights_of(s.scene, light_maps(*s.renderer));
    EXPECT_EQ(copied, s.drawn()) << light << ": to the bit what the renderer's own maps tell";
  }
  EXPECT_TRUE(s.driver->take_reports().empty());
  gl::check_errors("the test");
}

TEST(LightMap, ACopyIsMadeOfWhatWasBuiltAnewAlone) {
  GaugeScene s;
  s.renderer->render(s.scene, 1);
  const LightMapCopyPtr first = copy_light_maps(*s.renderer, nullptr);
  ASSERT_TRUE(first);
  s.scene.camera = look_at(dvec3(1, 0, 6), dvec3(0), dvec3(0, 1, 0), 40.0);
  s.renderer->render(s.scene, 1);
  EXPECT_EQ(copy_light_maps(*s.renderer, first), first) << "another view, the same maps";
  s.scene.lights[1].position = vec3(0.5f, 0.5f, 2.0f);
  s.renderer->render(s.scene, 1);
  const LightMapCopyPtr second = copy_light_maps(*s.renderer, first);
  ASSERT_TRUE(second);
  EXPECT_NE(second, first);
  EXPECT_NE(*second->batches[0].texels, *first->batches[0].texels);

  // What is drawn stays what it was until all of the new is there.
  LightMapUpload upload;
  upload_all(upload, first, std::chrono::seconds(1));
  ASSERT_TRUE(upload.upload(second, std::chrono::microseconds(0)));
  EXPECT_EQ(upload.shown(), first);
  s.view.lights = lights_of(s.scene, upload.maps());
  s.run("setAttr g.light 1");
  const auto before = s.picture();
  upload_all(upload, second, std::chrono::seconds(1));
  s.view.lights = lights_of(s.scene, upload.maps());
  EXPECT_NE(s.picture(), before);
  EXPECT_LT(s.error_of(1).first, 0.01);

  // Maps that stay as they are keep their buffer where only what goes with them is another.
  auto third = std::make_shared<LightMapCopy>(*second);
  third->batches[0].lights = 2;
  const unsigned texels = upload.maps()[0].texels;
  upload_all(upload, third, std::chrono::seconds(1));
  EXPECT_EQ(upload.maps().size(), 2u);
  EXPECT_EQ(upload.maps()[0].texels, texels);
  upload.upload(nullptr, std::chrono::seconds(1));
  EXPECT_TRUE(upload.maps().empty());
  EXPECT_FALSE(glIsTexture(texels)) << "let go of";
  gl::check_errors("the test");
}

}  // namespace
}  // namespace plinian::draw
