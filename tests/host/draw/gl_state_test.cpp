#include "host/draw/gl_state.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "viewport/gl/egl_context.h"

namespace plinian::draw {
namespace {

// What can be asked of a context, by name; several numbers each.
std::map<GLenum, std::vector<GLdouble>> everything() {
  std::map<GLenum, std::vector<GLdouble>> values;
  for (const GLenum name : {GLenum(GL_CURRENT_PROGRAM),
                            GLenum(GL_VERTEX_ARRAY_BINDING),
                            GLenum(GL_ARRAY_BUFFER_BINDING),
                            GLenum(GL_DRAW_FRAMEBUFFER_BINDING),
                            GLenum(GL_READ_FRAMEBUFFER_BINDING),
                            GLenum(GL_RENDERBUFFER_BINDING),
                            GLenum(GL_VIEWPORT),
                            GLenum(GL_SCISSOR_BOX),
                            GLenum(GL_SCISSOR_TEST),
                            GLenum(GL_BLEND),
                            GLenum(GL_BLEND_SRC_RGB),
                            GLenum(GL_BLEND_DST_ALPHA),
                            GLenum(GL_BLEND_EQUATION_RGB),
                            GLenum(GL_BLEND_COLOR),
                            GLenum(GL_DEPTH_TEST),
                            GLenum(GL_DEPTH_FUNC),
                            GLenum(GL_DEPTH_WRITEMASK),
                            GLenum(GL_DEPTH_RANGE),
                            GLenum(GL_DEPTH_CLEAR_VALUE),
                            GLenum(GL_COLOR_WRITEMASK),
                            GLenum(GL_COLOR_CLEAR_VALUE),
                            GLenum(GL_STENCIL_TEST),
                            GLenum(GL_STENCIL_FUNC),
                            GLenum(GL_STENCIL_REF),
                            GLenum(GL_STENCIL_BACK_WRITEMASK),
                            GLenum(GL_STENCIL_PASS_DEPTH_PASS),
                            GLenum(GL_CULL_FACE),
                            GLenum(GL_CULL_FACE_MODE),
                            GLenum(GL_FRONT_FACE),
                            GLenum(GL_POLYGON_MODE),
                            GLenum(GL_LINE_WIDTH),
                            GLenum(GL_POINT_SIZE),
                            GLenum(GL_PROGRAM_POINT_SIZE),
                            GLenum(GL_ACTIVE_TEXTURE),
                            GLenum(GL_FRAMEBUFFER_SRGB),
                            GLenum(GL_UNPACK_ALIGNMENT),
                            GLenum(GL_PACK_ROW_LENGTH),
                            GLenum(GL_PIXEL_UNPACK_BUFFER_BINDING),
                            GLenum(GL_UNIFORM_BUFFER_BINDING),
                            GLenum(GL_SHADER_STORAGE_BUFFER_BINDING),
                            GLenum(GL_CLIP_ORIGIN),
                            GLenum(GL_CLIP_DEPTH_MODE),
                            GLenum(GL_POLYGON_OFFSET_FILL),
                            GLenum(GL_POLYGON_OFFSET_FACTOR),
                            GLenum(GL_PRIMITIVE_RESTART),
                            GLenum(GL_RASTERIZER_DISCARD),
                            GLenum(GL_DRAW_BUFFER),
                            GLenum(GL_READ_BUFFER),
                            GLenum(GL_LOGIC_OP_MODE),
                            GLenum(GL_PATCH_VERTICES),
                            GLenum(GL_PROVOKING_VERTEX),
                            GLenum(GL_CLIP_DISTANCE0)}) {
    std::vector<GLdouble> value(4, -1.0);
    glGetDoublev(name, value.data());
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << name;
    values[name] = value;
  }
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (GLenum unit = 0; unit < 16; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    std::vector<GLdouble>& bound = values[GL_TEXTURE0 + unit];
    for (const GLenum name :
         {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_2D_ARRAY, GL_SAMPLER_BINDING}) {
      GLdouble value = -1.0;
      glGetDoublev(name, &value);
      bound.push_back(value);
    }
  }
  glActiveTexture(GLenum(active));
  for (GLuint i = 0; i < 8; ++i)
    for (const GLenum name :
         {GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE,
          GL_SHADER_STORAGE_BUFFER_BINDING, GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_FORMAT}) {
      GLint value = -1;
      glGetIntegeri_v(name, i, &value);
      values[name + 0x100000 * (i + 1)] = {GLdouble(value)};
    }
  return values;
}

struct Things {
  GLuint framebuffer = 0, colour = 0, buffers[3] = {}, textures[3] = {}, array = 0, sampler = 0;
  Things() {
    glCreateRenderbuffers(1, &colour);
    glNamedRenderbufferStorage(colour, GL_RGBA8, 32, 16);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferRenderbuffer(framebuffer, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
    glCreateBuffers(3, buffers);
    for (const GLuint buffer : buffers) glNamedBufferStorage(buffer, 1024, nullptr, 0);
    glCreateTextures(GL_TEXTURE_2D, 1, &textures[0]);
    glTextureStorage2D(textures[0], 1, GL_RGBA8, 4, 4);
    glCreateTextures(GL_TEXTURE_3D, 1, &textures[1]);
    glTextureStorage3D(textures[1], 1, GL_R16, 4, 4, 4);
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &textures[2]);
    glTextureStorage3D(textures[2], 1, GL_RGBA32F, 4, 4, 2);
    glCreateVertexArrays(1, &array);
    glCreateSamplers(1, &sampler);
  }
};

// Puts a bit of everything another way; i: 0 or 1, two different ways.
void mess(const Things& t, int i) {
  const bool odd = i != 0;
  for (const GLenum capability : {GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE,
                                  GL_FRAMEBUFFER_SRGB, GL_PROGRAM_POINT_SIZE, GL_POLYGON_OFFSET_FILL,
                                  GL_PRIMITIVE_RESTART, GL_RASTERIZER_DISCARD, GL_CLIP_DISTANCE0})
    odd ? glEnable(capability) : glDisable(capability);
  glBlendFunc(odd ? GL_ONE : GL_SRC_ALPHA, odd ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
  glBlendEquation(odd ? GL_MAX : GL_FUNC_ADD);
  glBlendColor(0.25f * float(i), 0.5f, 0.75f, 1.0f);
  glDepthFunc(odd ? GL_ALWAYS : GL_LEQUAL);
  glDepthMask(!odd);
  glDepthRangef(odd ? 0.25f : 0.0f, odd ? 0.5f : 1.0f);
  glClearDepthf(odd ? 0.5f : 1.0f);
  glColorMask(odd, !odd, odd, !odd);
  glClearColor(float(i), 0.5f, 0.25f, 0.125f);
  glStencilFuncSeparate(GL_FRONT, odd ? GL_LESS : GL_GREATER, 1 + i, 7);
  glStencilMaskSeparate(GL_BACK, odd ? 3 : 255);
  glStencilOp(GL_KEEP, GL_KEEP, odd ? GL_INVERT : GL_REPLACE);
  glCullFace(odd ? GL_FRONT : GL_BACK);
  glFrontFace(odd ? GL_CW : GL_CCW);
  glPolygonMode(GL_FRONT_AND_BACK, odd ? GL_LINE : GL_FILL);
  glPolygonOffset(float(i), 2.0f);
  glPointSize(1.0f + float(i));
  glViewport(i, 2, 3, 4);
  glScissor(5, i, 7, 8);
  glLogicOp(odd ? GL_XOR : GL_COPY);
  glPatchParameteri(GL_PATCH_VERTICES, 3 + i);
  glProvokingVertex(odd ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
  glClipControl(odd ? GL_UPPER_LEFT : GL_LOWER_LEFT, odd ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, odd ? 1 : 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, i * 16);
  glBindVertexArray(odd ? t.array : 0);
  glBindBuffer(GL_ARRAY_BUFFER, t.buffers[i]);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, odd ? t.buffers[2] : 0);
  glBindBufferRange(GL_UNIFORM_BUFFER, 2, t.buffers[i], 256 * GLintptr(i), 256);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, t.buffers[i + 1]);
  glBindTextureUnit(0, odd ? t.textures[0] : 0);
  glBindTextureUnit(7, t.textures[1]);
  glBindTextureUnit(7, odd ? t.textures[2] : t.textures[1]);
  glBindSampler(1, odd ? t.sampler : 0);
  if (odd) glBindImageTexture(4, t.textures[2], 0, GL_TRUE, 0, GL_READ_ONLY, GL_RGBA32F);
  glActiveTexture(odd ? GL_TEXTURE5 : GL_TEXTURE2);
  glBindFramebuffer(GL_FRAMEBUFFER, odd ? 0 : t.framebuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, odd ? t.colour : 0);
}

TEST(GlState, IsPutBackAsItWas) {
  const gl::EglContext context;
  const Things things;
  mess(things, 0);
  const auto before = everything();
  {
    const GlState state;
    mess(things, 1);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    // The test would see it: most of what is asked for is another now.
    const auto during = everything();
    int changed = 0;
    for (const auto& [name, value] : before) changed += during.at(name) != value;
    EXPECT_GE(changed, 40);
  }
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  const auto after = everything();
  for (const auto& [name, value] : before) EXPECT_EQ(after.at(name), value) << std::hex << name;
}

TEST(GlState, AFreshContextCausesNoErrors) {
  const gl::EglContext context;
  const auto before = everything();
  { const GlState state; }
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  EXPECT_EQ(everything(), before);
}

}  // namespace
}  // namespace plinian::draw
