// A ring that marks a place: a node, a draw override and a command.
#include <epoxy/gl.h>

#include <cmath>
#include <numbers>

#include "host/sdk/plugin.h"

using namespace plinian::sdk;

namespace {

// What is drawn, made of the node's values on any thread, ...
struct Ring {
  std::vector<float> points;  // x, y, z of each [object]
  std::array<float, 4> colour;
};

// ... and the same on the GPU.
struct RingObjects {
  GLuint program = 0, buffer = 0, array = 0;
};

GLuint compile(GLenum stage, const char* source) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  return shader;
}

bool upload(const Gl&, const Ring& ring, RingObjects& objects) {
  const GLuint vertex = compile(GL_VERTEX_SHADER,
                                "#version 450\n"
                                "layout(location = 0) in vec3 point;\n"
                                "layout(location = 0) uniform mat4 clip_from_object;\n"
                                "void main() { gl_Position = clip_from_object * vec4(point, 1.0); }\n");
  const GLuint fragment = compile(GL_FRAGMENT_SHADER,
                                  "#version 450\n"
                                  "layout(location = 1) uniform vec4 colour;\n"
                                  "out vec4 pixel;\n"
                                  "void main() { pixel = colour; }\n");
  objects.program = glCreateProgram();
  for (const GLuint shader : {vertex, fragment}) {
    glAttachShader(objects.program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(objects.program);
  glCreateBuffers(1, &objects.buffer);
  glNamedBufferStorage(objects.buffer, GLsizeiptr(ring.points.size() * sizeof(float)), ring.points.data(), 0);
  glCreateVertexArrays(1, &objects.array);
  glVertexArrayVertexBuffer(objects.array, 0, objects.buffer, 0, 3 * sizeof(float));
  glVertexArrayAttribFormat(objects.array, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glEnableVertexArrayAttrib(objects.array, 0);
  return true;  // done; false to be called again, where there is more than a few milliseconds of work
}

void draw(const DrawContext& context, const Ring& ring, RingObjects& objects) {
  glUseProgram(objects.program);
  glUniformMatrix4fv(0, 1, GL_FALSE, context.clip_from_object().data());
  const std::array<float, 4> selected = {1.0f, 1.0f, 1.0f, 1.0f};
  glUniform4fv(1, 1, context.plain.selection ? selected.data() : ring.colour.data());
  glBindVertexArray(objects.array);
  glDrawArrays(GL_LINE_LOOP, 0, GLsizei(ring.points.size() / 3));
}

void release(const Gl&, RingObjects& objects) {
  glDeleteVertexArrays(1, &objects.array);
  glDeleteBuffers(1, &objects.buffer);
  glDeleteProgram(objects.program);
}

// Along each side, whether the pixel is within four points of it.
std::optional<double> hit(const DrawContext& context, const Ring& ring, float x, float y) {
  const PlinianDrawContext& plain = context.plain;
  const Matrix view_from_object = DrawContext::product(plain.view_from_world, plain.world_from_object);
  const auto clip_from_object = context.clip_from_object();
  std::optional<double> nearest;
  for (std::size_t i = 0; i < ring.points.size(); i += 3)
    for (double share = 0.0; share < 1.0; share += 0.1) {
      std::array<double, 4> clip{};
      std::array<double, 3> view{};
      for (std::size_t k = 0; k < 4; ++k) {
        const double here = k < 3 ? ring.points[i + k] : 1.0;
        const double next = k < 3 ? ring.points[(i + 3) % ring.points.size() + k] : 1.0;
        for (std::size_t row = 0; row < 4; ++row)
          clip[row] += clip_from_object[4 * k + row] * std::lerp(here, next, share);
        for (std::size_t row = 0; row < 3; ++row)
          view[row] += view_from_object[4 * k + row] * std::lerp(here, next, share);
      }
      if (clip[3] <= 0.0) continue;  // behind the eye
      const double away =
          std::hypot(plain.viewport[0] + plain.viewport[2] * (0.5 + 0.5 * clip[0] / clip[3]) - x,
                     plain.viewport[1] + plain.viewport[3] * (0.5 + 0.5 * clip[1] / clip[3]) - y);
      const double distance = std::hypot(view[0], view[1], view[2]);
      if (away < 4.0 * plain.pixel_ratio && distance < nearest.value_or(INFINITY)) nearest = distance;
    }
  return nearest;
}

NodeType marker() {
  NodeType type("marker");
  type.help = "A ring that marks a place.";
  type.hierarchical = true;
  const Attribute radius = type.add({.name = "radius",
                                     .type = "distance",
                                     .default_value = "1",
                                     .help = "From the middle to the ring.",
                                     .unit = "m",
                                     .affects = "circumference",
                                     .minimum = 0.0});
  const Attribute colour = type.add({.name = "colour", .type = "colour", .default_value = "1 0.5 0"});
  const Attribute circumference = type.add({.name = "circumference", .type = "distance", .output = true});
  type.compute = [=](Context& context, Attribute) {
    context.set(circumference, 2.0 * std::numbers::pi * context.number(radius));
  };
  const auto prepare = [=](Context& context) {
    auto ring = std::make_unique<Ring>();
    const auto c = context.vector(colour);
    ring->colour = {c[0], c[1], c[2], 1.0f};
    for (int i = 0; i < 64; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 64.0, r = context.number(radius);
      ring->points.insert(ring->points.end(), {float(r * std::cos(angle)), float(r * std::sin(angle)), 0.0f});
    }
    return ring;
  };
  type.draw = draw_override(Draw<Ring, RingObjects>{.affected_by = "radius colour",
                                                    .prepare = prepare,
                                                    .upload = upload,
                                                    .draw = draw,
                                                    .release = release,
                                                    .hit = hit});
  return type;
}

Command add_marker() {
  Command command;
  command.name = "addMarker";
  command.help = "Marks a place and answers with the marker.";
  command.parameters = {{.name = "radius", .kind = "number", .help = "of the ring [m]"}};
  command.run = [](Call& call) {
    const std::string node = call.execute("createNode marker");
    call.execute("setAttr " + node + ".radius " + call.words("radius").at(0));
    call.answer(node);
  };
  return command;
}

void initialise(Plugin& plugin) {
  plugin.add(marker());
  plugin.add(add_marker());
  plugin.add(MenuEntry{.path = "Create/Marker", .command = "addMarker 1"});
}

}  // namespace

PLINIAN_PLUGIN("marker", "1.0", "A. Artist", "node:marker command:addMarker", initialise);
