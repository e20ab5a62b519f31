// A medium's nodes share its name and add what they are to it.
#include "host/scene/medium_names.h"

#include <cctype>
#include <filesystem>

#include "core/media/frame_sequence.h"

namespace plinian::scene {

namespace fs = std::filesystem;

std::string node_name_of(const std::string& name) {
  std::string result = name;
  for (char& c : result)
    if (!std::isalnum((unsigned char)c) && c != '_') c = '_';
  if (result.empty() || std::isdigit((unsigned char)result[0])) result.insert(0, "_");
  return result;
}

std::string medium_name_of(const std::string& path) {
  const auto pattern = FramePattern::parse(path);
  const fs::path file = pattern ? pattern->unnumbered() : path;
  return file.has_extension() ? node_name_of(file.stem().string()) : "medium";
}

std::string free_medium_name(const graph::Graph& graph, const std::string& wanted,
                             const std::string& name_space) {
  const std::string before = name_space.empty() ? "" : name_space + ":";
  const auto is_free = [&](const std::string& name) {
    // A medium does not take the name of what a picture has one of.
    for (const char* other : {"camera", "key", "rim", "sky", "settings"})
      if (name == other) return false;
    for (const char* part : {"", "_place", "_shape", "_file", "_noise"})
      if (graph.find(before + name + part)) return false;
    return true;
  };
  if (is_free(wanted)) return wanted;
  int number = 1;
  while (!is_free(wanted + std::to_string(number))) ++number;
  return wanted + std::to_string(number);
}

}  // namespace plinian::scene
