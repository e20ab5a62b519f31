// A path as people hand it over: typed, pasted from a terminal, or copied in a file manager.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace plinian::window {

/// The path that a text is: with quotes or backslashes as shells write them, ~, $VARIABLES, "file://", also
/// relative to `folder`. None where it is a mere name. Throws graph::GraphError where a variable is not set.
std::optional<std::filesystem::path> typed_path(const std::string& text, const std::filesystem::path& folder);

/// "/a/b" of "/a/b/", "/a/./b" and "/a/c/../b": one spelling of a folder.
std::filesystem::path tidy_folder(const std::filesystem::path& folder);

}  // namespace plinian::window
