// Expands file paths. The path itself stays as typed, so that a scene works on another machine.
#include "host/graph/values/file_path.h"

#include <cstdlib>

#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

std::string variable(const std::string& name, const std::string& typed) {
  const char* value = std::getenv(name.c_str());
  if (!value) throw GraphError("the environment variable " + name + " in '" + typed + "' is not set");
  return value;
}

}  // namespace

std::string expand_path(const std::string& typed, const std::filesystem::path& folder) {
  std::string path;
  std::size_t at = 0;
  if (typed == "~" || typed.starts_with("~/")) {
    path = variable("HOME", typed);
    at = 1;
  }
  const auto in_name = [&](std::size_t i) {
    return i < typed.size() && (std::isalnum((unsigned char)typed[i]) || typed[i] == '_');
  };
  while (at < typed.size()) {
    const bool braced = typed.compare(at, 2, "${") == 0;
    const std::size_t begin = at + (braced ? 2 : 1);
    // "$F4" counts frames in a sequence's name; it is no variable.
    const bool frame =
        typed[at] == '$' && begin < typed.size() && typed[begin] == 'F' &&
        (!in_name(begin + 1) || (std::isdigit((unsigned char)typed[begin + 1]) && !in_name(begin + 2)));
    if (typed[at] != '$' || frame || !in_name(begin)) {
      path += typed[at++];
      continue;
    }
    std::size_t end = begin;
    while (in_name(end)) ++end;
    path += variable(typed.substr(begin, end - begin), typed);
    at = end + (braced && end < typed.size() && typed[end] == '}' ? 1 : 0);
  }
  if (path.empty()) return path;
  const std::filesystem::path result(path);
  return (result.is_absolute() ? result : folder / result).lexically_normal().string();
}

std::string path_from(const std::string& typed, const std::filesystem::path& folder) {
  const std::filesystem::path path(typed);
  if (!path.is_absolute()) return typed;
  const std::filesystem::path relative =
      path.lexically_normal().lexically_relative((folder / "").lexically_normal());
  if (relative.empty() || relative == "." || *relative.begin() == "..") return typed;
  // A name of a file that begins like somebody's home.
  return relative.string().front() == '~' ? "./" + relative.string() : relative.string();
}

}  // namespace plinian::graph
