// The outer shape of a scene file: its sections and lines, before they mean anything.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plinian::graph {

/// Looks into the text that the sections were cut from.
struct SceneLine {
  std::string_view text;  // with its indentation
  int number = 0;         // from 1
};

struct NodeSection {
  std::string type, name, parent;  // parent: empty for none
  int line = 0;
  std::vector<SceneLine> lines;
};

struct TypeSection {
  std::string name;
  int version = 1;
  std::string plugin, plugin_version;
  int line = 0;
  std::vector<SceneLine> lines;
};

struct SceneSections {
  int major = 1, minor = 0;             // version of the file format
  std::vector<SceneLine> requirements;  // "requires" lines
  std::vector<SceneLine> unknown;       // lines that a newer version may know
  std::vector<NodeSection> nodes;
  std::vector<TypeSection> types;

  bool is_newer() const;
};

/// Major and minor of a plug-in's version: of "1.4.2-beta" the first two numbers; none count as 0.
std::pair<unsigned long, unsigned long> version_numbers(const std::string& text);

/// Cuts a scene into its sections, which hold no longer than `text`. name: of the file, for errors. Throws
/// GraphError, with name and line, for a text that is no scene, was cut off, goes on behind its end, or has a
/// line that a scene of its version has not.
SceneSections read_sections(std::string_view text, const std::string& name);

}  // namespace plinian::graph
