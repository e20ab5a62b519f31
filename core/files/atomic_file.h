// Files that are there whole or not at all.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plinian {

/// A file that cannot be written: one line that names it and the reason.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws FileError, naming the path and the reason, where a file could not be written there now: the folder
/// does not exist or refuses new files, or the target is a folder, not a plain file, or write-protected.
/// Changes nothing.
void check_writable(const std::string& path);

/// Writes a temporary file beside `path` and renames it over it, so that a failure leaves what was there
/// before. A link is followed, and the permissions of an existing file are kept. Throws FileError.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file(const std::string& path, std::string_view text);

/// As above for what cannot be made again, as a scene: the bytes are on the disk before they take the place
/// of what was there, and that is kept as `path`.bak. Whatever moment the power fails, `path` is whole.
void write_file_durably(const std::string& path, std::string_view text);

/// As above for bytes that somebody else writes: `fill` is given the path of the temporary file, which
/// exists, is empty and has the extension of `path`. What it throws is passed on.
void write_file(const std::string& path, const std::function<void(const std::string&)>& fill);

}  // namespace plinian
