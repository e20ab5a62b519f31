#include "viewport/gl/shader.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "viewport/gl/unroll.h"

namespace plinian::gl {
namespace {

constexpr const char* version_line = "#version 450 core\n";

std::string_view find_file(std::string_view path) {
  for (const auto& [name, text] : shader_files())
    if (name == path) return text;
  throw std::runtime_error("shader file '" + std::string(path) + "' is not part of this build");
}

using Seen = std::set<std::string, std::less<>>;

void append_text(std::string_view text, Seen& seen, std::string& out);

void append_file(std::string_view path, Seen& seen, std::string& out) {
  if (seen.emplace(path).second) append_text(find_file(path), seen, out);
}

void append_text(std::string_view text, Seen& seen, std::string& out) {
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
      const std::size_t comment = line.find("//");
      out += line.substr(0, comment);
      if (comment != line.npos) out += '\n';
    }
  }
}

std::string with_defines(std::string_view text, const Defines& defines, std::string out) {
  for (const auto& [name, value] : defines) out += "#define " + name + " " + value + "\n";
  Seen seen;
  append_text(text, seen, out);
  return out;
}

std::string written_out(std::string_view path, std::string source, const Defines& defines) {
  try {
    return unroll(std::move(source), defines);
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string(path) + ": " + error.what());
  }
}

Program compile(std::string_view path, const std::string& source, const Defines& defines) {
  const std::string whole = written_out(path, source, defines);
  const char* text = whole.c_str();
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

}  // namespace

std::string shader_source(std::string_view path, const Defines& defines) {
  return with_defines(find_file(path), defines, version_line);
}

std::string shader_part(std::string_view path, const Defines& defines) {
  return with_defines(find_file(path), defines, "");
}

Program make_compute_program_from(std::string_view name, std::string_view text, const Defines& defines) {
  return compile(name, with_defines(text, defines, version_line), defines);
}

Program make_compute_program(std::string_view path, const Defines& defines) {
  return compile(path, shader_source(path, defines), defines);
}

}  // namespace plinian::gl
