// Takes off what shells put around a path.
#include "host/window/files/typed_path.h"

#include <cctype>
#include <cstdlib>

#include "host/graph/values/file_path.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

std::string trimmed(const std::string& text) {
  const char* spaces = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(spaces);
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(spaces) - begin + 1);
}

// "%20" is a space.
std::string without_percents(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && std::isxdigit((unsigned char)text[i + 1]) &&
        std::isxdigit((unsigned char)text[i + 2])) {
      result += char(std::strtol(text.substr(i + 1, 2).c_str(), nullptr, 16));
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

// Quotes may begin and end anywhere, as in 'it'\''s here'. A quote that does not end is a letter.
std::string without_quotes(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\' && i + 1 < text.size() && !std::isalnum((unsigned char)text[i + 1])) {
      result += text[++i];
    } else if (const std::size_t end = text.find(c, i + 1); (c == '\'' || c == '"') && end != text.npos) {
      result += text.substr(i + 1, end - i - 1);
      i = end;
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::optional<fs::path> typed_path(const std::string& text, const fs::path& folder) {
  std::string path = trimmed(text);
  if (path.starts_with("file://")) {
    path = without_percents(path.substr(7));
    if (const std::size_t host = path.find('/'); host != path.npos) path = path.substr(host);
  } else {
    path = without_quotes(path);
  }
  if (path.find('/') == path.npos && path != "~" && path != ".." && path[0] != '$') return std::nullopt;
  const fs::path whole = fs::path(graph::expand_path(path, folder)).lexically_normal();
  return whole.has_filename() || whole == whole.root_path() ? whole : whole.parent_path();
}

std::filesystem::path tidy_folder(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder.lexically_normal();
  return path.has_filename() || path == path.root_path() ? path : path.parent_path();
}

}  // namespace plinian::window
