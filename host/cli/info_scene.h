// What is in a scene, for `plinian info`.
#pragma once

#include <string>

namespace plinian::cli {

/// Nodes with their types, what they are under and the files that they read; as text, or as JSON for scripts.
/// Nothing is computed. Warns of what is not known. Throws std::runtime_error (one line).
std::string scene_info(const std::string& path, bool json);

}  // namespace plinian::cli
