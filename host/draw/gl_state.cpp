// One table for each kind of state, so that saving and restoring cannot disagree.
#include "host/draw/gl_state.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <vector>

namespace plinian::draw {

namespace {

constexpr int unit_count = 16, buffer_count = 8, image_count = 8, draw_buffer_count = 8;

constexpr std::array capabilities = {GL_BLEND,
                                     GL_CULL_FACE,
                                     GL_DEPTH_TEST,
                                     GL_DEPTH_CLAMP,
                                     GL_DITHER,
                                     GL_FRAMEBUFFER_SRGB,
                                     GL_LINE_SMOOTH,
                                     GL_POLYGON_SMOOTH,
                                     GL_COLOR_LOGIC_OP,
                                     GL_MULTISAMPLE,
                                     GL_POLYGON_OFFSET_FILL,
                                     GL_POLYGON_OFFSET_LINE,
                                     GL_POLYGON_OFFSET_POINT,
                                     GL_PRIMITIVE_RESTART,
                                     GL_PRIMITIVE_RESTART_FIXED_INDEX,
                                     GL_PROGRAM_POINT_SIZE,
                                     GL_RASTERIZER_DISCARD,
                                     GL_SAMPLE_ALPHA_TO_COVERAGE,
                                     GL_SAMPLE_ALPHA_TO_ONE,
                                     GL_SAMPLE_COVERAGE,
                                     GL_SAMPLE_MASK,
                                     GL_SAMPLE_SHADING,
                                     GL_SCISSOR_TEST,
                                     GL_STENCIL_TEST,
                                     GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                     GL_CLIP_DISTANCE0,
                                     GL_CLIP_DISTANCE1,
                                     GL_CLIP_DISTANCE2,
                                     GL_CLIP_DISTANCE3};

struct TextureTarget {
  GLenum target, binding;
};
constexpr std::array texture_targets = {
    TextureTarget{GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
    TextureTarget{GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
    TextureTarget{GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
    TextureTarget{GL_TEXTURE_1D_ARRAY, GL_TEXTURE_BINDING_1D_ARRAY},
    TextureTarget{GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
    TextureTarget{GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
    TextureTarget{GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY},
    TextureTarget{GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER},
    TextureTarget{GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE},
    TextureTarget{GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE}};

struct BufferTarget {
  GLenum target, binding;
};
constexpr std::array buffer_targets = {
    BufferTarget{GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
    BufferTarget{GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING},
    BufferTarget{GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING},
    BufferTarget{GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING},
    BufferTarget{GL_DISPATCH_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER_BINDING},
    BufferTarget{GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
    BufferTarget{GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING},
    BufferTarget{GL_QUERY_BUFFER, GL_QUERY_BUFFER_BINDING}};

struct IndexedTarget {
  GLenum target, binding, start, size;
};
constexpr std::array indexed_targets = {
    IndexedTarget{GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START,
                  GL_UNIFORM_BUFFER_SIZE},
    IndexedTarget{GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
                  GL_SHADER_STORAGE_BUFFER_SIZE},
    IndexedTarget{GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_BINDING, GL_ATOMIC_COUNTER_BUFFER_START,
                  GL_ATOMIC_COUNTER_BUFFER_SIZE}};

constexpr std::array pixel_stores = {
    GL_PACK_ALIGNMENT,     GL_PACK_ROW_LENGTH,     GL_PACK_SKIP_ROWS,    GL_PACK_SKIP_PIXELS,
    GL_PACK_SKIP_IMAGES,   GL_PACK_IMAGE_HEIGHT,   GL_PACK_SWAP_BYTES,   GL_PACK_LSB_FIRST,
    GL_UNPACK_ALIGNMENT,   GL_UNPACK_ROW_LENGTH,   GL_UNPACK_SKIP_ROWS,  GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST};

GLint integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

GLint64 integer_at(GLenum name, int index) {
  GLint64 value = 0;
  glGetInteger64i_v(name, GLuint(index), &value);
  return value;
}

template <std::size_t N>
std::array<GLint, N> integers(GLenum name) {
  std::array<GLint, N> values{};
  glGetIntegerv(name, values.data());
  return values;
}

template <std::size_t N>
std::array<GLfloat, N> floats(GLenum name) {
  std::array<GLfloat, N> values{};
  glGetFloatv(name, values.data());
  return values;
}

struct Stencil {
  GLint function, reference, value_mask, fail, pass_depth_fail, pass_depth_pass, write_mask;
};

Stencil stencil(bool back) {
  return {integer(back ? GL_STENCIL_BACK_FUNC : GL_STENCIL_FUNC),
          integer(back ? GL_STENCIL_BACK_REF : GL_STENCIL_REF),
          integer(back ? GL_STENCIL_BACK_VALUE_MASK : GL_STENCIL_VALUE_MASK),
          integer(back ? GL_STENCIL_BACK_FAIL : GL_STENCIL_FAIL),
          integer(back ? GL_STENCIL_BACK_PASS_DEPTH_FAIL : GL_STENCIL_PASS_DEPTH_FAIL),
          integer(back ? GL_STENCIL_BACK_PASS_DEPTH_PASS : GL_STENCIL_PASS_DEPTH_PASS),
          integer(back ? GL_STENCIL_BACK_WRITEMASK : GL_STENCIL_WRITEMASK)};
}

void set_stencil(GLenum face, const Stencil& s) {
  glStencilFuncSeparate(face, GLenum(s.function), s.reference, GLuint(s.value_mask));
  glStencilOpSeparate(face, GLenum(s.fail), GLenum(s.pass_depth_fail), GLenum(s.pass_depth_pass));
  glStencilMaskSeparate(face, GLuint(s.write_mask));
}

struct Binding {
  GLint64 buffer = 0, start = 0, size = 0;
};

struct Image {
  GLint texture = 0, level = 0, layered = 0, layer = 0, access = 0, format = 0;
};

}  // namespace

struct GlState::Values {
  std::array<bool, capabilities.size()> enabled{};
  GLint program = integer(GL_CURRENT_PROGRAM), pipeline = integer(GL_PROGRAM_PIPELINE_BINDING),
        vertex_array = integer(GL_VERTEX_ARRAY_BINDING),
        draw_framebuffer = integer(GL_DRAW_FRAMEBUFFER_BINDING),
        read_framebuffer = integer(GL_READ_FRAMEBUFFER_BINDING),
        renderbuffer = integer(GL_RENDERBUFFER_BINDING), active_texture = integer(GL_ACTIVE_TEXTURE);
  std::array<GLint, draw_buffer_count> draw_buffers{};
  GLint read_buffer = integer(GL_READ_BUFFER);
  std::array<std::array<GLint, texture_targets.size()>, unit_count> textures{};
  std::array<GLint, unit_count> samplers{};
  std::array<GLint, buffer_targets.size()> buffers{};
  std::array<std::array<Binding, buffer_count>, indexed_targets.size()> indexed{};
  std::array<GLint, indexed_targets.size()> indexed_generic{};
  std::array<Image, image_count> images{};
  std::array<GLint, pixel_stores.size()> pixels{};
  std::array<GLint, 4> viewport = integers<4>(GL_VIEWPORT), scissor = integers<4>(GL_SCISSOR_BOX);
  std::array<GLint, 4> colour_mask = integers<4>(GL_COLOR_WRITEMASK);
  std::array<GLfloat, 4> blend_colour = floats<4>(GL_BLEND_COLOR),
                         clear_colour = floats<4>(GL_COLOR_CLEAR_VALUE);
  GLint blend_source_rgb = integer(GL_BLEND_SRC_RGB), blend_target_rgb = integer(GL_BLEND_DST_RGB),
        blend_source_alpha = integer(GL_BLEND_SRC_ALPHA), blend_target_alpha = integer(GL_BLEND_DST_ALPHA),
        blend_equation_rgb = integer(GL_BLEND_EQUATION_RGB),
        blend_equation_alpha = integer(GL_BLEND_EQUATION_ALPHA);
  GLint depth_function = integer(GL_DEPTH_FUNC), depth_mask = integer(GL_DEPTH_WRITEMASK);
  std::array<GLfloat, 2> depth_range = floats<2>(GL_DEPTH_RANGE), polygon_offset{};
  GLfloat clear_depth = floats<1>(GL_DEPTH_CLEAR_VALUE)[0];
  GLint clear_stencil = integer(GL_STENCIL_CLEAR_VALUE);
  Stencil front = stencil(false), back = stencil(true);
  GLint cull_face = integer(GL_CULL_FACE_MODE), front_face = integer(GL_FRONT_FACE);
  GLint polygon_mode = integers<2>(GL_POLYGON_MODE)[0];
  GLfloat line_width = floats<1>(GL_LINE_WIDTH)[0], point_size = floats<1>(GL_POINT_SIZE)[0];
  GLint logic_operation = integer(GL_LOGIC_OP_MODE), restart_index = integer(GL_PRIMITIVE_RESTART_INDEX),
        provoking_vertex = integer(GL_PROVOKING_VERTEX), patch_vertices = integer(GL_PATCH_VERTICES),
        clip_origin = integer(GL_CLIP_ORIGIN), clip_depth = integer(GL_CLIP_DEPTH_MODE);
};

GlState::GlState() : values_(std::make_unique<Values>()) {
  Values& v = *values_;
  for (std::size_t i = 0; i < capabilities.size(); ++i) v.enabled[i] = glIsEnabled(GLenum(capabilities[i]));
  for (int i = 0; i < draw_buffer_count; ++i)
    v.draw_buffers[std::size_t(i)] = integer(GLenum(GL_DRAW_BUFFER0 + i));
  for (int unit = 0; unit < unit_count; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    for (std::size_t i = 0; i < texture_targets.size(); ++i)
      v.textures[std::size_t(unit)][i] = integer(texture_targets[i].binding);
    v.samplers[std::size_t(unit)] = integer(GL_SAMPLER_BINDING);
  }
  glActiveTexture(GLenum(v.active_texture));
  for (std::size_t i = 0; i < buffer_targets.size(); ++i) v.buffers[i] = integer(buffer_targets[i].binding);
  for (std::size_t i = 0; i < indexed_targets.size(); ++i) {
    v.indexed_generic[i] = integer(indexed_targets[i].binding);
    for (int k = 0; k < buffer_count; ++k)
      v.indexed[i][std::size_t(k)] = {integer_at(indexed_targets[i].binding, k),
                                      integer_at(indexed_targets[i].start, k),
                                      integer_at(indexed_targets[i].size, k)};
  }
  for (int i = 0; i < image_count; ++i) {
    Image& image = v.images[std::size_t(i)];
    const auto read = [&](GLenum name, GLint& value) { glGetIntegeri_v(name, GLuint(i), &value); };
    read(GL_IMAGE_BINDING_NAME, image.texture);
    read(GL_IMAGE_BINDING_LEVEL, image.level);
    read(GL_IMAGE_BINDING_LAYERED, image.layered);
    read(GL_IMAGE_BINDING_LAYER, image.layer);
    read(GL_IMAGE_BINDING_ACCESS, image.access);
    read(GL_IMAGE_BINDING_FORMAT, image.format);
  }
  for (std::size_t i = 0; i < pixel_stores.size(); ++i) v.pixels[i] = integer(GLenum(pixel_stores[i]));
  v.polygon_offset = {floats<1>(GL_POLYGON_OFFSET_FACTOR)[0], floats<1>(GL_POLYGON_OFFSET_UNITS)[0]};
}

GlState::~GlState() {
  const Values& v = *values_;
  const auto name = [](GLint value) { return GLuint(value); };
  glUseProgram(name(v.program));
  glBindProgramPipeline(name(v.pipeline));
  glBindVertexArray(name(v.vertex_array));
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name(v.draw_framebuffer));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, name(v.read_framebuffer));
  glBindRenderbuffer(GL_RENDERBUFFER, name(v.renderbuffer));
  // Of the framebuffers that are bound; one without any buffer to draw to has none in the first place.
  if (v.draw_framebuffer != 0) {
    std::array<GLenum, draw_buffer_count> buffers{};
    for (std::size_t i = 0; i < buffers.size(); ++i) buffers[i] = GLenum(v.draw_buffers[i]);
    glDrawBuffers(draw_buffer_count, buffers.data());
  }
  if (v.read_framebuffer != 0) glReadBuffer(GLenum(v.read_buffer));
  for (int unit = 0; unit < unit_count; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    for (std::size_t i = 0; i < texture_targets.size(); ++i)
      glBindTexture(texture_targets[i].target, name(v.textures[std::size_t(unit)][i]));
    glBindSampler(GLuint(unit), name(v.samplers[std::size_t(unit)]));
  }
  glActiveTexture(GLenum(v.active_texture));
  for (std::size_t i = 0; i < indexed_targets.size(); ++i) {
    for (int k = 0; k < buffer_count; ++k) {
      const Binding& binding = v.indexed[i][std::size_t(k)];
      if (binding.buffer != 0 && binding.size > 0)
        glBindBufferRange(indexed_targets[i].target, GLuint(k), GLuint(binding.buffer),
                          GLintptr(binding.start), GLsizeiptr(binding.size));
      else
        glBindBufferBase(indexed_targets[i].target, GLuint(k), GLuint(binding.buffer));
    }
    glBindBuffer(indexed_targets[i].target, name(v.indexed_generic[i]));
  }
  for (std::size_t i = 0; i < buffer_targets.size(); ++i)
    glBindBuffer(buffer_targets[i].target, name(v.buffers[i]));
  for (int i = 0; i < image_count; ++i) {
    const Image& image = v.images[std::size_t(i)];
    glBindImageTexture(GLuint(i), name(image.texture), image.level, GLboolean(image.layered), image.layer,
                       GLenum(image.access), GLenum(image.format));
  }
  for (std::size_t i = 0; i < pixel_stores.size(); ++i) glPixelStorei(GLenum(pixel_stores[i]), v.pixels[i]);
  glViewport(v.viewport[0], v.viewport[1], v.viewport[2], v.viewport[3]);
  glScissor(v.scissor[0], v.scissor[1], v.scissor[2], v.scissor[3]);
  glColorMask(GLboolean(v.colour_mask[0]), GLboolean(v.colour_mask[1]), GLboolean(v.colour_mask[2]),
              GLboolean(v.colour_mask[3]));
  glBlendColor(v.blend_colour[0], v.blend_colour[1], v.blend_colour[2], v.blend_colour[3]);
  glClearColor(v.clear_colour[0], v.clear_colour[1], v.clear_colour[2], v.clear_colour[3]);
  glBlendFuncSeparate(GLenum(v.blend_source_rgb), GLenum(v.blend_target_rgb), GLenum(v.blend_source_alpha),
                      GLenum(v.blend_target_alpha));
  glBlendEquationSeparate(GLenum(v.blend_equation_rgb), GLenum(v.blend_equation_alpha));
  glDepthFunc(GLenum(v.depth_function));
  glDepthMask(GLboolean(v.depth_mask));
  glDepthRangef(v.depth_range[0], v.depth_range[1]);
  glClearDepthf(v.clear_depth);
  glClearStencil(v.clear_stencil);
  set_stencil(GL_FRONT, v.front);
  set_stencil(GL_BACK, v.back);
  glCullFace(GLenum(v.cull_face));
  glFrontFace(GLenum(v.front_face));
  glPolygonMode(GL_FRONT_AND_BACK, GLenum(v.polygon_mode));
  glPolygonOffset(v.polygon_offset[0], v.polygon_offset[1]);
  glLineWidth(v.line_width);
  glPointSize(v.point_size);
  glLogicOp(GLenum(v.logic_operation));
  glPrimitiveRestartIndex(name(v.restart_index));
  glProvokingVertex(GLenum(v.provoking_vertex));
  glPatchParameteri(GL_PATCH_VERTICES, v.patch_vertices);
  glClipControl(GLenum(v.clip_origin), GLenum(v.clip_depth));
  for (std::size_t i = 0; i < capabilities.size(); ++i)
    if (v.enabled[i])
      glEnable(GLenum(capabilities[i]));
    else
      glDisable(GLenum(capabilities[i]));
}

}  // namespace plinian::draw
