// Compute programs from the shader files that the library carries.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "viewport/gl/objects.h"

namespace plinian::gl {

using Defines = std::vector<std::pair<std::string, std::string>>;

/// A truth value, as it stands in a define.
inline std::string flag(bool on) {
  return on ? "true" : "false";
}

/// Every file of core/shared and viewport/passes, by its path from the project's root.
const std::vector<std::pair<std::string_view, std::string_view>>& shader_files();

/// The text of a shader with `#include "path"` resolved (each file once) and `defines` (name, value) after
/// the version line. Throws std::runtime_error naming a file that is not carried.
std::string shader_source(std::string_view path, const Defines& defines);

/// The same without a version line: for shaders that others write around it.
std::string shader_part(std::string_view path, const Defines& defines);

/// The same for a text that is not carried; `name` stands in messages.
Program make_compute_program_from(std::string_view name, std::string_view text, const Defines& defines);

/// Compiles and links a compute shader. Throws std::runtime_error with the file and the compiler's message.
Program make_compute_program(std::string_view path, const Defines& defines);

}  // namespace plinian::gl
