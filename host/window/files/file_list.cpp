// Lists, collapses, sorts.
#include "host/window/files/file_list.h"

#include <dirent.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <memory>

#include "core/media/sequence_names.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

char small(char c) {
  return char(std::tolower((unsigned char)c));
}

std::string extension_of(const std::string& name) {
  std::string extension = fs::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), small);
  return extension;
}

bool is_one_of(const std::string& extension, const std::vector<std::string>& extensions) {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

FileEntry entry_of(const NameGroup& group, const std::vector<FileEntry>& files) {
  FileEntry entry = files[group.members.front()];
  if (group.members.size() == 1) return entry;
  entry = {FileEntry::Kind::sequence, group.name, group.first, group.last, int(group.members.size())};
  for (const std::size_t member : group.members) {
    entry.bytes += files[member].bytes;
    entry.modified = std::max(entry.modified, files[member].modified);
  }
  return entry;
}

// Digits count as the number that they are. Negative, 0 or positive.
int compare_names(const std::string& a, const std::string& b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      while (i < a.size() && a[i] == '0') ++i;
      while (j < b.size() && b[j] == '0') ++j;
      std::size_t end_i = i, end_j = j;
      while (end_i < a.size() && is_digit(a[end_i])) ++end_i;
      while (end_j < b.size() && is_digit(b[end_j])) ++end_j;
      if (end_i - i != end_j - j) return end_i - i < end_j - j ? -1 : 1;
      if (const int order = a.compare(i, end_i - i, b, j, end_j - j); order != 0) return order;
      i = end_i;
      j = end_j;
    } else {
      const char x = small(a[i++]), y = small(b[j++]);
      if (x != y) return (unsigned char)x < (unsigned char)y ? -1 : 1;
    }
  }
  if (i < a.size() || j < b.size()) return i < a.size() ? 1 : -1;
  return a.compare(b);
}

template <class T>
int compare(T a, T b) {
  return a < b ? -1 : a > b ? 1 : 0;
}

}  // namespace

FolderListing list_folder(const fs::path& folder, const std::vector<std::string>& extensions,
                          const std::function<bool()>& keep_going) {
  FolderListing listing{folder, {}, ""};
  const auto close = [](DIR* directory) { closedir(directory); };
  const std::unique_ptr<DIR, decltype(close)> directory(opendir(folder.c_str()), close);
  if (!directory) {
    listing.problem = folder.string() + " cannot be read: " + std::strerror(errno);
    return listing;
  }
  std::vector<FileEntry> numbered;  // may be frames of sequences
  std::vector<std::string> names;
  while (const dirent* found = readdir(directory.get())) {
    if (keep_going && !keep_going()) break;
    const std::string name = found->d_name;
    if (name[0] == '.') continue;
    const std::string extension = extension_of(name);
    const bool wanted = extensions.empty() || is_one_of(extension, extensions);
    // What is of no interest need not be asked for on a slow disk.
    if (!wanted && found->d_type == DT_REG) continue;
    struct stat facts {};
    if (fstatat(dirfd(directory.get()), found->d_name, &facts, 0) != 0 && !wanted) continue;
    FileEntry entry{S_ISDIR(facts.st_mode) ? FileEntry::Kind::folder : FileEntry::Kind::file, name};
    entry.modified = facts.st_mtime;
    if (!entry.is_folder()) entry.bytes = std::uint64_t(facts.st_size);
    if (entry.is_folder() || (wanted && !is_one_of(extension, {".vdb", ".exr", ".png"}))) {
      listing.entries.push_back(std::move(entry));
    } else if (wanted) {
      numbered.push_back(std::move(entry));
      names.push_back(name);
    }
  }
  for (const NameGroup& group : group_names(names)) listing.entries.push_back(entry_of(group, numbered));
  return listing;
}

void sort_entries(std::vector<FileEntry>& entries, FileOrder order) {
  std::sort(entries.begin(), entries.end(), [&](const FileEntry& a, const FileEntry& b) {
    if (a.is_folder() != b.is_folder()) return a.is_folder();
    int way = 0;
    if (order.column == FileColumn::size) way = compare(a.bytes, b.bytes);
    if (order.column == FileColumn::modified) way = compare(a.modified, b.modified);
    if (way == 0 && order.column != FileColumn::name) return compare_names(a.name, b.name) < 0;
    if (order.column == FileColumn::name) way = compare_names(a.name, b.name);
    return order.descending ? way > 0 : way < 0;
  });
}

bool matches(const std::string& name, const std::string& letters) {
  return std::search(name.begin(), name.end(), letters.begin(), letters.end(),
                     [](char a, char b) { return small(a) == small(b); }) != name.end() ||
         letters.empty();
}

std::string range_text(const FileEntry& sequence) {
  const std::int64_t missing = std::int64_t(sequence.last) - sequence.first + 1 - sequence.count;
  return fmt::format("{}-{}{}", sequence.first, sequence.last,
                     missing > 0 ? fmt::format(", {} missing", missing) : "");
}

std::string list_of(const std::vector<std::string>& extensions) {
  std::string text;
  for (std::size_t i = 0; i < extensions.size(); ++i)
    text += (i == 0 ? "" : i + 1 == extensions.size() ? " and " : ", ") + extensions[i];
  return text;
}

std::string size_text(std::uint64_t bytes) {
  constexpr const char* units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  double amount = double(bytes);
  std::size_t unit = 0;
  for (; amount >= 1000.0 && unit < 4; ++unit) amount /= 1024.0;
  return fmt::format("{:.{}f} {}", amount, unit == 0 ? 0 : 1, units[unit]);
}

std::string time_text(std::int64_t seconds) {
  const std::time_t time = std::time_t(seconds);
  std::tm parts{};
  char text[32] = "";
  if (localtime_r(&time, &parts)) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
  return text;
}

}  // namespace plinian::window
