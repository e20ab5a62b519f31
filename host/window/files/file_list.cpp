// Lists and collapses.
#include "host/window/files/file_list.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

// "smoke.0007.vdb" as before "smoke.", digits 4, after ".vdb": the last run of digits before the extension.
struct Numbered {
  std::string pattern;
  int number = 0;
};

bool split(const std::string& name, Numbered& found) {
  const std::size_t dot = name.rfind('.');
  if (dot == name.npos || dot == 0) return false;
  std::size_t begin = dot;
  while (begin > 0 && std::isdigit((unsigned char)name[begin - 1])) --begin;
  const std::size_t digits = dot - begin;
  if (digits == 0 || digits > 9) return false;
  // Numbers of their natural length have one place; padded ones as many as they show.
  found.number = std::stoi(name.substr(begin, digits));
  const bool padded = name[begin] == '0' && digits > 1;
  found.pattern =
      name.substr(0, begin) + (padded || digits > 1 ? std::string(digits, '#') : "#") + name.substr(dot);
  return true;
}

bool has_extension(const fs::path& path, const std::vector<std::string>& extensions) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = char(std::tolower((unsigned char)c));
  return extensions.empty() || std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

}  // namespace

std::vector<FileEntry> list_files(const fs::path& folder, const std::vector<std::string>& extensions,
                                  std::string* problem) {
  std::vector<FileEntry> folders, files;
  std::map<std::string, std::vector<std::pair<int, std::string>>> sequences;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(".")) continue;
    std::error_code ignored;
    Numbered numbered;
    if (entry->is_directory(ignored))
      folders.push_back({name, name + "/", true});
    else if (!has_extension(entry->path(), extensions))
      continue;
    else if (has_extension(entry->path(), {".vdb", ".exr", ".png"}) && split(name, numbered))
      sequences[numbered.pattern].emplace_back(numbered.number, name);
    else
      files.push_back({name, name, false});
  }
  if (problem) *problem = error ? folder.string() + ": " + error.message() : "";
  for (auto& [pattern, members] : sequences) {
    std::sort(members.begin(), members.end());
    if (members.size() == 1)
      files.push_back({members[0].second, members[0].second, false});
    else
      files.push_back({pattern,
                       pattern + "  " + std::to_string(members.front().first) + "-" +
                           std::to_string(members.back().first),
                       false});
  }
  const auto by_name = [](const FileEntry& a, const FileEntry& b) { return a.name < b.name; };
  std::sort(folders.begin(), folders.end(), by_name);
  std::sort(files.begin(), files.end(), by_name);
  folders.insert(folders.end(), files.begin(), files.end());
  return folders;
}

}  // namespace plinian::window
