// A small file of lines that the window keeps for its user.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plinian::window {

/// Its lines without the empty ones; none where there is no such file.
std::vector<std::string> read_lines(const std::filesystem::path& file);

/// Writes them whole, one a line, and makes the folder where it is missing. file: empty for nowhere. Returns
/// whether they are kept now.
bool write_lines(const std::filesystem::path& file, const std::vector<std::string>& lines);

}  // namespace plinian::window
