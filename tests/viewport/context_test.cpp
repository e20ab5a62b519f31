#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "tests/viewport/scenes.h"
#include "viewport/gl/egl_context.h"
#include "viewport/gl/objects.h"
#include "viewport/gl/shader.h"

namespace plinian::gl {
namespace {

TEST(EglContext, OffersComputeInOpenGl45) {
  EglContext context;
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(major * 10 + minor, 45);
}

TEST(Objects, AreDeletedOnceAndMoveTheirName) {
  EglContext context;
  Name name = 0;
  {
    Buffer a = make_buffer(64, nullptr);
    name = a.name();
    Buffer b = std::move(a);
    EXPECT_EQ(a.name(), 0u);
    EXPECT_EQ(b.name(), name);
    EXPECT_TRUE(glIsBuffer(name));
  }
  EXPECT_FALSE(glIsBuffer(name));
}

TEST(Shader, NamesTheFileThatDoesNotCompileOrIsMissing) {
  EglContext context;
  try {
    make_compute_program("viewport/passes/view.comp", {{"MEDIA_COUNT", "oops"}});
    FAIL() << "compiled";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("view.comp"), std::string::npos);
  }
  EXPECT_THROW(shader_source("viewport/passes/nothing.comp", {}), std::runtime_error);
}

TEST(Shader, IncludesEachFileOnceAndPutsDefinesBehindTheVersion) {
  const std::string text = shader_source("viewport/passes/view.comp", {{"ANSWER", "42"}});
  EXPECT_TRUE(text.starts_with("#version 450 core\n#define ANSWER 42\n"));
  EXPECT_EQ(text.find("#include \""), std::string::npos);
  const auto once = text.find("float henyey_greenstein(");
  EXPECT_NE(once, std::string::npos);
  EXPECT_EQ(text.find("float henyey_greenstein(", once + 1), std::string::npos);
}

}  // namespace
}  // namespace plinian::gl
