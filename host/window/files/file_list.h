// What a folder holds, as a file browser lists it: folders first, sequences of files as one line each.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace plinian::window {

struct FileEntry {
  enum class Kind { folder, file, sequence };
  Kind kind = Kind::file;
  std::string name;           // as it is opened: "smoke.####.vdb" for a sequence
  int first = 0, last = 0;    // frames of a sequence
  int count = 1;              // files
  std::uint64_t bytes = 0;    // of all of them; 0 for a folder
  std::int64_t modified = 0;  // [s] since the epoch; of the newest
  bool is_folder() const { return kind == Kind::folder; }
  bool operator==(const FileEntry&) const = default;
};

struct FolderListing {
  std::filesystem::path folder;
  std::vector<FileEntry> entries;  // in no order
  std::string problem;             // why it cannot be read, one line; else empty
  bool operator==(const FolderListing&) const = default;
};

/// Reads a folder; to be called where it may take its time. extensions: with their dots, in small letters;
/// empty for all files. Hidden files are left out. keep_going: asked now and then; what is there so far is
/// returned where it says no.
FolderListing list_folder(const std::filesystem::path& folder, const std::vector<std::string>& extensions,
                          const std::function<bool()>& keep_going = {});

enum class FileColumn { name, size, modified };
struct FileOrder {
  FileColumn column = FileColumn::name;
  bool descending = false;
};
/// Folders stay first; what is alike is in the order of names, where "smoke2" comes before "smoke10".
void sort_entries(std::vector<FileEntry>& entries, FileOrder order);

/// Whether the letters are in the name, large or small. Where they are none they are in every name.
bool matches(const std::string& name, const std::string& letters);

/// "1-48", or "1-48, 3 missing".
std::string range_text(const FileEntry& sequence);
/// ".plinian, .vdb and .exr"
std::string list_of(const std::vector<std::string>& extensions);
/// "1.5 MiB"; [bytes]
std::string size_text(std::uint64_t bytes);
/// "2026-11-29 09:31", where the user is. [s] since the epoch
std::string time_text(std::int64_t seconds);

}  // namespace plinian::window
