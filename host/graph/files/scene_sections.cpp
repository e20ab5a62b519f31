// Cuts scenes into sections.
#include "host/graph/files/scene_sections.h"

#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "host/graph/edits/editor.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

bool parse_int(std::string_view text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number >= 0;
}

bool parse_version(std::string_view text, SceneSections& scene) {
  const std::size_t dot = text.find('.');
  return dot != text.npos && parse_int(text.substr(0, dot), scene.major) &&
         parse_int(text.substr(dot + 1), scene.minor);
}

}  // namespace

bool SceneSections::is_newer() const {
  return major > scene_major_version || (major == scene_major_version && minor > scene_minor_version);
}

SceneSections read_sections(std::string_view text, const std::string& name) {
  SceneSections scene;
  int number = 0;
  const auto fail = [&](const std::string& why) {
    throw GraphError(name + ":" + std::to_string(number) + ": " + why);
  };
  if (text.empty()) throw GraphError(name + ": is empty, not a scene");
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::vector<SceneLine>* section = nullptr;
  bool ended = false;
  while (!text.empty() && !ended) {
    ++number;
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (number == 1) {
      if (!line.starts_with("plinian scene ") || !parse_version(line.substr(14), scene))
        throw GraphError(name + ": is not a Plinian scene: its first line is " + shown(line));
      continue;
    }
    if (line.find('\0') != line.npos) fail("the line holds a zero byte: the file is damaged");
    if (line.starts_with(' ')) {
      if (!section) fail("the line belongs to no node: " + shown(line));
      section->push_back({line, number});
      continue;
    }
    std::vector<Word> words;
    try {
      words = split_words(line);
    } catch (const GraphError& error) {
      fail(error.what());
    }
    if (words.empty()) continue;
    const std::string& kind = words[0].text;
    if (kind == "end" && words.size() == 1) {
      ended = true;
    } else if (kind == "requires" && words.size() >= 2) {
      scene.requirements.push_back({line, number});
      section = nullptr;
    } else if (kind == "node" && (words.size() == 3 || (words.size() == 5 && words[3].text == "under"))) {
      if (!is_identifier(words[1].text)) fail(shown(words[1].text) + " cannot be a node type");
      if (!is_node_name(words[2].text)) fail(shown(words[2].text) + " cannot name a node");
      scene.nodes.push_back(
          {words[1].text, words[2].text, words.size() == 5 ? words[4].text : "", number, {}});
      section = &scene.nodes.back().lines;
    } else if (kind == "type" && (words.size() == 3 || (words.size() == 6 && words[3].text == "from"))) {
      TypeSection type{words[1].text, 1, "", "", number, {}};
      if (!is_identifier(type.name) || !parse_int(words[2].text, type.version) || type.version < 1)
        fail("a type has a name and a version: " + shown(line));
      if (words.size() == 6) {
        type.plugin = words[4].text;
        type.plugin_version = words[5].text;
      }
      scene.types.push_back(std::move(type));
      section = &scene.types.back().lines;
    } else if (scene.is_newer()) {
      scene.unknown.push_back({line, number});
      section = &scene.unknown;  // and what stands under it
    } else {
      fail("is no line of a scene: " + shown(line));
    }
  }
  if (!ended) {
    std::error_code error;
    const bool kept = std::filesystem::exists(name + ".bak", error);
    throw GraphError(name + ": ends too early, after line " + std::to_string(number) +
                     ": the file was cut off" +
                     (kept ? " (" + name + ".bak may hold the last whole scene)" : ""));
  }
  // Whoever put it there would lose it with the next save.
  for (; !text.empty(); text.remove_prefix(std::min(text.find('\n') + 1, text.size()))) {
    ++number;
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.find_first_not_of(" \t\r") != line.npos)
      fail("stands behind 'end', where a scene is over: " + shown(std::string(line)));
    if (text.find('\n') == text.npos) break;
  }
  return scene;
}

std::pair<unsigned long, unsigned long> version_numbers(const std::string& text) {
  std::pair<unsigned long, unsigned long> result;
  char* rest = nullptr;
  result.first = std::strtoul(text.c_str(), &rest, 10);
  if (*rest == '.') result.second = std::strtoul(rest + 1, nullptr, 10);
  return result;
}

}  // namespace plinian::graph
