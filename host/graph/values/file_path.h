// File paths as artists type them: with environment variables, and relative to the scene.
#pragma once

#include <filesystem>
#include <string>

namespace plinian::graph {

/// The path with $NAME, ${NAME} and a leading ~ replaced and, where it is relative, taken from `folder`
/// (empty: the current one). Throws GraphError, naming the variable, where one is not set.
std::string expand_path(const std::string& typed, const std::filesystem::path& folder);

/// The path as it is written in `folder`: relative to it where it is absolute and lies in it or under it,
/// else as it is.
std::string path_from(const std::string& typed, const std::filesystem::path& folder);

}  // namespace plinian::graph
