// The shared maths gives the same numbers in C++ and in GLSL.
#include "tests/viewport/shared_parity.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "viewport/gl/egl_context.h"
#include "viewport/gl/shader.h"

namespace plinian::gl {
namespace {

std::string read_file(const std::string& name) {
  std::ifstream file(std::string(PLINIAN_SOURCE_DIR) + "/tests/viewport/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(SharedMaths, AgreesBetweenCppAndGlslToAFewRoundings) {
  EglContext context;
  std::string shader = read_file("shared_parity.comp");
  const std::string place = "PARITY_VALUES\n\n";
  shader.replace(shader.rfind(place), place.size(), read_file("shared_parity.h"));
  const Program program = make_compute_program_from("shared_parity.comp", shader, {});
  constexpr int rows = 256, functions = shared::parity_functions;
  std::vector<float> results(rows * functions, -1.0f);
  const Buffer buffer = make_buffer(results.size() * sizeof(float), results.data());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.name());
  glUseProgram(program.name());
  glDispatchCompute(rows / 16, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(buffer.name(), 0, GLsizeiptr(results.size() * sizeof(float)), results.data());
  check_errors("the parity test");
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < functions; ++k) {
      const float expected = shared::parity_value(k, float(i) / 255.0f);
      EXPECT_NEAR(results[i * functions + k], expected, 2e-5f * std::max(1.0f, std::abs(expected)))
          << k << " at " << i;
    }
}

}  // namespace
}  // namespace plinian::gl
