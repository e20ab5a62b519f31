#include "viewport/gl/shader.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace plinian::gl {
namespace {

std::string_view find_file(std::string_view path) {
  for (const auto& [name, text] : shader_files())
    if (name == path) return text;
  throw std::runtime_error("shader file '" + std::string(path) + "' is not part of this build");
}

void append_file(std::string_view path, std::set<std::string, std::less<>>& seen, std::string& out) {
  if (!seen.emplace(path).second) return;
  std::string_view text = find_file(path);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    constexpr std::string_view ours = "#include \"", system = "#include <";
    if (line.starts_with(ours)) {
      const std::string_view rest = line.substr(ours.size());
      const std::string_view included = rest.substr(0, rest.find('"'));
      // What is not carried is meant for C++ alone, in the half of a shared file that GLSL skips.
      if (included.starts_with("core/shared/") || included.starts_with("viewport/passes/"))
        append_file(included, seen, out);
    } else if (!line.starts_with(system)) {
      out += line;
    }
  }
}

}  // namespace

std::string shader_source(std::string_view path, const Defines& defines) {
  std::string out = "#version 450 core\n";
  for (const auto& [name, value] : defines) out += "#define " + name + " " + value + "\n";
  std::set<std::string, std::less<>> seen;
  append_file(path, seen, out);
  return out;
}

Program make_compute_program(std::string_view path, const Defines& defines) {
  const std::string source = shader_source(path, defines);
  const char* text = source.c_str();
  Program program(glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &text));
  GLint linked = 0;
  if (program) glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (!linked) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    if (program) glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw std::runtime_error(std::string(path) + ": the shader does not compile: " + log);
  }
  return program;
}

}  // namespace plinian::gl
