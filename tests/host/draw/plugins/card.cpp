// A card that shows how much of the first light arrives at it: red where all does, green where none does.
// Draws nothing where the light has no map. Notes what it makes and lets go of in $PLINIAN_CARD_LOG.
#include <epoxy/gl.h>

#include <cstdlib>
#include <fstream>

#include "host/sdk/plugin.h"

using namespace plinian::sdk;

namespace {

struct Card {
  float height;       // [object] along y
  std::string fault;  // what is done badly
};

struct CardObjects {
  GLuint array = 0, program = 0;
  const char* glsl = nullptr;  // that the program is made with
};

void note(const char* line) {
  if (const char* path = std::getenv("PLINIAN_CARD_LOG")) std::ofstream(path, std::ios::app) << line << '\n';
}

constexpr const char* vertex_text =
    "#version 450\n"
    "layout(location = 0) uniform mat4 card_clip_from_object;\n"
    "layout(location = 1) uniform float card_height;\n"
    "out vec3 card_place;\n"
    "void main() {\n"
    "  card_place = vec3(2.5 * ((gl_VertexID & 1) * 2 - 1), card_height, 2.5 * ((gl_VertexID >> 1) * 2 - "
    "1));\n"
    "  gl_Position = card_clip_from_object * vec4(card_place, 1.0);\n"
    "}\n";
constexpr const char* fragment_text =
    "layout(location = 2) uniform int card_light;\n"
    "in vec3 card_place;\n"
    "out vec4 card_colour;\n"
    "void main() {\n"
    "  float share = plinian_light(card_light, card_place).x;\n"
    "  card_colour = vec4(share, 1.0 - share, 0.0, 1.0);\n"
    "}\n";

void make_program(CardObjects& objects, const char* glsl) {
  glDeleteProgram(objects.program);
  objects.program = glCreateProgram();
  objects.glsl = glsl;
  const auto attach = [&](GLenum stage, std::vector<const char*> texts) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, GLsizei(texts.size()), texts.data(), nullptr);
    glCompileShader(shader);
    glAttachShader(objects.program, shader);
    glDeleteShader(shader);
  };
  attach(GL_VERTEX_SHADER, {vertex_text});
  attach(GL_FRAGMENT_SHADER, {"#version 450\n", glsl, fragment_text});
  glLinkProgram(objects.program);
  GLint good = 0;
  glGetProgramiv(objects.program, GL_LINK_STATUS, &good);
  if (!good) throw Error("the card's shader does not link");
}

void draw(const DrawContext& context, const Card& card, CardObjects& objects) {
  if (card.fault == "error") {
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(0xffff);
    return;
  }
  if (card.fault == "draw") throw Error("out of ink");
  const PlinianLightMap* map = context.plain.light_count > 0 ? context.plain.light_maps[0] : nullptr;
  if (!map) return;
  if (map->glsl != objects.glsl) make_program(objects, map->glsl);
  glUseProgram(objects.program);
  glUniformMatrix4fv(0, 1, GL_FALSE, context.clip_from_object().data());
  glUniform1f(1, card.height);
  glUniform1i(2, map->light);
  constexpr GLuint unit = 3, binding = 5;
  glBindTextureUnit(unit, map->texels);
  glUniform1i(glGetUniformLocation(objects.program, "plinian_map_texels"), unit);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, map->block);
  glUniformBlockBinding(objects.program, glGetUniformBlockIndex(objects.program, "PlinianLights"), binding);
  glBindVertexArray(objects.array);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void initialise(Plugin& plugin) {
  NodeType type("card");
  type.hierarchical = true;
  const Attribute height = type.add({.name = "height", .default_value = "-1.2"});
  const Attribute fault = type.add({.name = "fault", .type = "string"});
  Draw<Card, CardObjects> card;
  card.prepare = [=](Context& context) {
    if (context.text(fault) == "prepare") throw Error("out of paper");
    return std::make_unique<const Card>(Card{float(context.number(height)), context.text(fault)});
  };
  card.upload = [](const Gl&, const Card&, CardObjects& objects) {
    glCreateVertexArrays(1, &objects.array);
    note("upload");
    return true;
  };
  card.draw = draw;
  card.release = [](const Gl&, CardObjects& objects) {
    // What is let go of after its context has gone is no vertex array any more.
    note(glIsVertexArray(objects.array) ? "release" : "lost");
    glDeleteVertexArrays(1, &objects.array);
    glDeleteProgram(objects.program);
  };
  type.draw = draw_override(card);
  plugin.add(type);
}

}  // namespace

PLINIAN_PLUGIN("card", "1.0", "A. Artist", "node:card", initialise);
