// Reads scenes: first all nodes, then what refers to them.
#include "host/graph/files/scene_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "host/graph/files/node_reader.h"
#include "host/graph/files/scene_sections.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/flat_map.h"

namespace plinian::graph {

namespace {

constexpr std::size_t max_warnings = 100;

std::vector<RequiredPlugin> requirements_in(const SceneSections& scene) {
  std::vector<RequiredPlugin> plugins;
  for (const SceneLine& line : scene.requirements) {
    const std::vector<Word> words = split_words(line.text);
    plugins.push_back({words.at(1).text, words.size() > 2 ? words[2].text : ""});
  }
  return plugins;
}

// Of two scenes that say the same of a type or a plug-in, or nothing.
KeptType newer_of(KeptType a, const KeptType& b) {
  a.version = std::max(a.version, b.version);
  if (version_numbers(a.plugin_version) < version_numbers(b.plugin_version)) {
    a.plugin = b.plugin;
    a.plugin_version = b.plugin_version;
  }
  return a;
}

class SceneReader {
 public:
  SceneReader(const std::string& name, const TypeRegistry& registry, Editor& editor,
              const std::string& name_space, const std::map<std::string, std::string>& held_back)
      : name_(name),
        registry_(registry),
        editor_(editor),
        prefix_(name_space.empty() ? "" : name_space + ":"),
        held_back_(held_back) {}

  SceneReport read(const SceneSections& scene) {
    const History::Scope scope(editor_.history(), "open");
    for (const Node* node : editor_.graph().nodes())
      if (node->type->spec().unique) own_.emplace(node->type.get(), node->id);
    greet(scene);
    check_held_back();
    prepare_types(scene);
    keep_requirements(scene);
    report_.nodes.reserve(scene.nodes.size());
    for (const NodeSection& section : scene.nodes) add_node(section, scene.is_newer());
    for (const Waiting& node : waiting_) finish(node);
    count_unknown();
    if (hidden_warnings_ > 0)
      report_.warnings.push_back(name_ + ": and " + std::to_string(hidden_warnings_) + " more warnings");
    return std::move(report_);
  }

 private:
  void add_warning(int line, const std::string& message) {
    if (report_.warnings.size() < max_warnings)
      report_.warnings.push_back(name_ + (line ? ":" + std::to_string(line) : "") + ": " + message);
    else
      ++hidden_warnings_;
  }
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw GraphError(name_ + ":" + std::to_string(line) + ": " + message);
  }

  void greet(const SceneSections& scene) {
    const std::string version = std::to_string(scene.major) + "." + std::to_string(scene.minor);
    if (scene.major > scene_major_version) {
      report_.read_only = true;
      add_warning(0, "was saved in the newer format " + version + ": it is opened read-only");
    } else if (scene.is_newer()) {
      add_warning(0,
                  "was saved in the newer format " + version + ": what is not known here is kept as it is");
    }
    if (scene.unknown.empty()) return;
    KeptType kept;
    for (const SceneLine& line : scene.unknown) kept.lines.emplace_back(line.text);
    editor_.set_kept_type("", kept);
  }

  // Their nodes are unknown here, beside which none that are known can be saved.
  void check_held_back() {
    for (const auto& [type, why] : held_back_) {
      for (const Node* node : editor_.graph().nodes())
        if (node->type->name() == type && !node->type->is_unknown())
          throw GraphError(name_ + ": " + why + ", or delete " + node->name + " and its like first");
      add_warning(0, why);
    }
  }

  void prepare_types(const SceneSections& scene) {
    for (const TypeSection& section : scene.types) {
      if (readers_.contains(section.name))
        fail(section.line, "the type '" + section.name + "' is there twice");
      NodeTypePtr type = registry_.find(section.name);
      if (!type || held_back_.contains(section.name)) type = NodeType::unknown(section.name, section.version);
      const NodeReader& reader =
          readers_.emplace(section.name, NodeReader(type, section, scene.is_newer())).first->second;
      if (section.version > type->version() && !type->is_unknown())
        add_warning(section.line, "the scene has version " + std::to_string(section.version) +
                                      " of the type '" + section.name + "', here is " +
                                      std::to_string(type->version()));
      if (!reader.keeps_anything()) continue;
      KeptType kept = reader.kept();
      const auto before = editor_.graph().kept_types().find(section.name);
      if (before != editor_.graph().kept_types().end() && before->second.lines != kept.lines) {
        spelled_out_.emplace(section.name, kept.lines);  // two scenes, two sets of defaults
        continue;
      }
      if (before != editor_.graph().kept_types().end()) kept = newer_of(before->second, kept);
      editor_.set_kept_type(section.name, std::move(kept));
    }
  }

  // What a scene needs beyond what its types say stays what it needs.
  void keep_requirements(const SceneSections& scene) {
    for (const RequiredPlugin& plugin : requirements_in(scene)) {
      const auto says_as_much = [&](const TypeSection& type) {
        return type.plugin == plugin.name &&
               version_numbers(type.plugin_version) >= version_numbers(plugin.version);
      };
      if (std::ranges::any_of(scene.types, says_as_much)) continue;
      const std::string name = "requires " + plugin.name;
      KeptType kept{1, plugin.name, plugin.version, {}};
      const auto before = editor_.graph().kept_types().find(name);
      if (before != editor_.graph().kept_types().end()) kept = newer_of(before->second, kept);
      editor_.set_kept_type(name, std::move(kept));
    }
  }

  const NodeReader& reader_of(const NodeSection& section, bool newer) {
    auto found = readers_.find(section.type);
    if (found == readers_.end()) {
      TypeSection none{section.type};
      NodeTypePtr type = registry_.find(section.type);
      if (type) none.version = type->version();
      if (!type) type = NodeType::unknown(section.type, 1);
      found = readers_.emplace(section.type, NodeReader(type, none, newer)).first;
    }
    return found->second;
  }

  void add_node(const NodeSection& section, bool newer) {
    if (by_name_.contains(section.name)) fail(section.line, "the node '" + section.name + "' is there twice");
    const NodeReader& reader = reader_of(section, newer);
    if (const auto own = own_.find(reader.type().get()); own != own_.end()) {
      by_name_[section.name] = own->second;
      report_.shared.push_back(own->second);
      return;
    }
    const WarnLine warn = [&](int line, const std::string& message) {
      add_warning(line ? line : section.line, message);
    };
    NodeText text = reader.read(section.name, section.lines, warn,
                                [this](int line, const std::string& message) { fail(line, message); });
    if (const auto spelled_out = spelled_out_.find(section.type); spelled_out != spelled_out_.end())
      spell_out(spelled_out->second, text.node);
    Node node = std::move(text.node);
    // What a scene has one of is found by its own name.
    node.name = (reader.type()->spec().unique ? "" : prefix_) + section.name;
    const NodeId id = editor_.add_node(std::move(node));
    by_name_[section.name] = id;
    if (reader.type()->spec().unique)
      if (const auto [first, alone] = read_unique_.emplace(reader.type().get(), id); !alone)
        add_warning(section.line, section.name + " is another " + section.type +
                                      ", of which a scene has one: " +
                                      editor_.graph().find(first->second)->name + ", the first, counts");
    report_.nodes.push_back(id);
    Waiting waiting{&section, id, std::move(text.links)};
    // Most refer to nodes before them: at once, while the node is at hand, costs less than a second round.
    if (are_known(waiting))
      finish(waiting);
    else
      waiting_.push_back(std::move(waiting));
  }

  // Gives a node what its scene leaves to the type's section and is not known here.
  static void spell_out(const std::vector<std::string>& lines, Node& node) {
    const auto path_of = [](std::string_view line) {
      const std::size_t begin = line.find('.'), end = line.find(' ', begin);
      return begin == line.npos ? line : line.substr(begin, end - begin);
    };
    std::vector<KeptLine> missing;
    for (const std::string& line : lines) {
      bool there = false;
      for (const KeptLine& kept : node.kept) there = there || path_of(kept.text) == path_of(line);
      if (!there) missing.push_back({line});
    }
    node.kept.insert(node.kept.begin(), missing.begin(), missing.end());
  }

  // A node whose parent and sources are yet to come.
  struct Waiting {
    const NodeSection* section;
    NodeId id;
    NodeLinks links;
  };

  NodeId node_of(std::string_view name) const {
    const NodeId* found = by_name_.find(name);
    return found ? *found : NodeId();
  }

  bool are_known(const Waiting& node) const {
    const auto known = [this](const NodeLinks::Link& link) -> bool {
      return bool(node_of(std::string_view(link.text).substr(0, link.text.find('.'))));
    };
    return (node.section->parent.empty() || node_of(node.section->parent)) &&
           std::ranges::all_of(node.links.references, known) &&
           std::ranges::all_of(node.links.connections, known);
  }

  void finish(const Waiting& node) {
    place(*node.section, node.id);
    finish_node(
        editor_, node.id, node.links, [this](std::string_view name) { return node_of(name); },
        [this](int line, const std::string& message) { add_warning(line, message); });
  }

  void place(const NodeSection& section, NodeId id) {
    if (section.parent.empty()) return;
    const NodeId parent = node_of(section.parent);
    if (!parent) fail(section.line, "there is no node " + shown(section.parent));
    try {
      if (const std::string problem = editor_.place(id, parent); !problem.empty())
        add_warning(section.line, problem);
    } catch (const GraphError& error) {
      fail(section.line, error.what());
    }
  }

  void count_unknown() {
    std::map<std::string, int> unknown;
    for (const NodeId id : report_.nodes) {
      const NodeType& type = *editor_.graph().find(id)->type;
      if (type.is_unknown() && !held_back_.contains(type.name())) ++unknown[type.name()];
    }
    for (const auto& [type, count] : unknown) {
      const auto kept = editor_.graph().kept_types().find(type);
      const bool plugin = kept != editor_.graph().kept_types().end() && !kept->second.plugin.empty();
      add_warning(0, "the node type '" + type + "' is not known" +
                         (plugin ? ": it needs the plug-in " + kept->second.plugin : std::string()) + "; " +
                         std::to_string(count) + (count == 1 ? " node is" : " nodes are") + " kept as " +
                         (count == 1 ? "it is" : "they are"));
    }
  }

  const std::string name_;
  const TypeRegistry& registry_;
  Editor& editor_;
  const std::string prefix_;
  const std::map<std::string, std::string>& held_back_;  // types whose nodes cannot be migrated, and why
  std::map<const NodeType*, NodeId> own_;                // of unique types, before the scene was read
  std::map<const NodeType*, NodeId> read_unique_;        // likewise, of the scene
  SceneReport report_;
  std::map<std::string, NodeReader> readers_;
  std::map<std::string, std::vector<std::string>> spelled_out_;  // by type: lines of its section
  FlatMap<std::string_view, NodeId> by_name_;
  std::vector<Waiting> waiting_;
  std::size_t hidden_warnings_ = 0;
};

}  // namespace

SceneReport read_scene(std::string_view text, const std::string& name, const TypeRegistry& registry,
                       Editor& editor, const std::string& name_space) {
  const SceneSections scene = read_sections(text, name);
  std::map<std::string, std::string> held_back;
  while (true) {
    try {
      return SceneReader(name, registry, editor, name_space, held_back).read(scene);
    } catch (const MigrationError& error) {
      // Which of a type's nodes fail is known after others were read: from the start again, without the type.
      if (!held_back.emplace(error.type, error.what()).second) throw;
    }
  }
}

std::vector<RequiredPlugin> required_plugins(std::string_view text, const std::string& name) {
  return requirements_in(read_sections(text, name));
}

void compare_version(const RequiredPlugin& required, const std::string& version, const std::string& name,
                     SceneReport& report) {
  const auto [major, minor] = version_numbers(required.version);
  const auto [own_major, own_minor] = version_numbers(version);
  const bool newer_major = major > own_major;
  if (!newer_major && (major < own_major || minor <= own_minor)) return;
  report.read_only = report.read_only || newer_major;
  report.warnings.push_back(
      name + ": was saved with version " + required.version + " of the plug-in '" + required.name +
      "', here is " + version +
      (newer_major ? ": it is opened read-only" : ": what is not known here is kept as it is"));
}

std::string read_text_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw GraphError(path + ": is a folder");
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw GraphError(path + ": cannot be read: " + std::strerror(errno));
  const auto size = file.tellg();
  if (size < 0) throw GraphError(path + ": cannot be read");
  if (size > std::streamoff(1) << 30) throw GraphError(path + ": is larger than 1 GiB, no scene");
  std::string text(std::size_t(size), '\0');
  file.seekg(0);
  if (size > 0 && !file.read(text.data(), size))
    throw GraphError(path + ": cannot be read: " + std::strerror(errno));
  return text;
}

}  // namespace plinian::graph
