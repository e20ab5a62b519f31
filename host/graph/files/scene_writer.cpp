// Writes scenes.
#include "host/graph/files/scene_writer.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_set>

#include "core/files/atomic_file.h"
#include "host/graph/files/attribute_declaration.h"
#include "host/graph/files/scene_sections.h"
#include "host/graph/values/file_path.h"

namespace plinian::graph {

namespace {

std::string value_line(const Graph& graph, const Node& node, const StoredValue& stored,
                       const std::filesystem::path& folder) {
  const SchemaAttribute& attribute = (*node.schema)[stored.attribute];
  std::string line = "  .";
  line += Graph::path_of(*node.schema, {node.id, stored.attribute, stored.element, -1});
  const bool path = attribute.spec.type == AttributeType::path && !folder.empty();
  const std::string text = write_value(
      attribute.spec, path ? path_from(std::get<std::string>(stored.value), folder) : stored.value,
      graph.names());
  if (!text.empty()) line += " " + text;
  // Data whose type is not registered.
  if (text.empty() && attribute.spec.type == AttributeType::data) return "";
  return line;
}

std::string connection_line(const std::string& path, const std::string& source) {
  return "  ." + path + " <- " + source;
}

void add_kept_line(const Graph& graph, const KeptLine& kept, std::vector<std::string>& lines) {
  if (!kept.source)
    lines.push_back(kept.text);
  else if (const Node* source = graph.find(kept.source))  // gone: the connection went with it
    lines.push_back(connection_line(kept.path, source->name + "." + kept.source_path));
}

// What a line is about: "  .mode" of "  .mode high", "  .mode <-" of a connection; of others all of it.
std::string subject_of(const std::string& line) {
  if (!line.starts_with("  .")) return line;
  const std::size_t space = line.find(' ', 2);
  if (space == line.npos) return line;
  return line.substr(0, line.compare(space, 4, " <- ") == 0 ? space + 3 : space);
}

// The lines of a node, and where each of them stands.
class PlacedLines {
 public:
  PlacedLines(std::vector<std::string>& lines, bool placed) : lines_(lines), placed_(placed) {}

  void add(const LinePlace& place, std::string line) {
    if (placed_) places_.push_back(place);
    lines_.push_back(std::move(line));
  }
  /// Puts the kept lines among them, but those in whose place there is one by now.
  void merge(const Graph& graph, const std::vector<KeptLine>& kept) {
    std::vector<const KeptLine*> waiting;
    for (const KeptLine& line : kept) waiting.push_back(&line);
    std::ranges::stable_sort(waiting, {}, [](const KeptLine* line) { return line->place; });
    std::vector<std::string> known(lines_.end() - std::ptrdiff_t(places_.size()), lines_.end());
    lines_.resize(lines_.size() - places_.size());
    std::set<std::string> subjects;
    for (const std::string& line : known) subjects.insert(subject_of(line));
    std::size_t next = 0;
    for (const KeptLine* line : waiting) {
      // What was set or connected since.
      if (subjects.contains(line->source ? "  ." + line->path + " <-" : subject_of(line->text))) continue;
      for (; next < known.size() && places_[next] <= line->place; ++next)
        lines_.push_back(std::move(known[next]));
      add_kept_line(graph, *line, lines_);
    }
    for (; next < known.size(); ++next) lines_.push_back(std::move(known[next]));
  }

 private:
  std::vector<std::string>& lines_;
  bool placed_;
  std::vector<LinePlace> places_;  // of the last lines
};

}  // namespace

std::vector<std::string> node_lines(const Graph& graph, const Node& node,
                                    const std::filesystem::path& folder) {
  std::vector<std::string> lines;
  const Schema& schema = *node.schema;
  for (const AttributeIndex index : schema.top())
    if (schema[index].dynamic)
      for (const std::string& line : write_declaration(schema.declaration(index)))
        lines.push_back("  add " + line);
  // Nodes of unknown types have nothing but kept lines.
  const bool placed = !node.kept.empty() && !node.type->is_unknown();
  PlacedLines body(lines, placed);
  // Values and connections in the order in which the attributes are declared.
  auto input = node.inputs.begin();
  const auto add_inputs_before = [&](AttributeIndex attribute, std::int32_t element) {
    for (; input != node.inputs.end() &&
           std::pair(input->attribute, input->element) < std::pair(attribute, element);
         ++input)
      body.add({false, input->attribute, input->element, input->component},
               connection_line(
                   Graph::path_of(schema, {node.id, input->attribute, input->element, input->component}),
                   graph.name_of(input->source)));
  };
  for (const StoredValue& stored : node.values) {
    const AttributeSpec& spec = schema[stored.attribute].spec;
    if (!spec.storable) continue;
    add_inputs_before(stored.attribute, stored.element);
    if (std::string line = value_line(graph, node, stored, folder); !line.empty())
      body.add({false, stored.attribute, stored.element}, std::move(line));
  }
  add_inputs_before(schema.size(), 0);
  for (const Plug& plug : node.locked)
    body.add({true, plug.attribute, plug.element}, "  lock ." + Graph::path_of(schema, plug));
  if (placed)
    body.merge(graph, node.kept);
  else
    for (const KeptLine& kept : node.kept) add_kept_line(graph, kept, lines);
  return lines;
}

std::vector<std::string> type_lines(const NodeType& type, const KeptType* kept) {
  std::vector<std::string> lines;
  const Schema& schema = *type.schema();
  std::size_t next = 0;
  // The kept lines behind the one of a path; several in their order.
  const auto add_kept_behind = [&](const std::string& path) {
    for (; kept && next < kept->after.size() && kept->after[next] == path; ++next)
      lines.push_back(kept->lines[next]);
  };
  add_kept_behind("");
  for (AttributeIndex index = 0; index < schema.size(); ++index) {
    const SchemaAttribute& attribute = schema[index];
    const AttributeType kind = attribute.spec.type;
    if (!attribute.spec.storable || kind == AttributeType::compound || kind == AttributeType::data) continue;
    std::string line = "  ." + attribute.path;
    const std::string text = write_value(attribute.spec, attribute.spec.default_value);
    if (!text.empty()) line += " " + text;
    lines.push_back(line);
    add_kept_behind(attribute.path);
  }
  // In another order there than here, or of an unknown type.
  for (; kept && next < kept->lines.size(); ++next) lines.push_back(kept->lines[next]);
  return lines;
}

namespace {

std::string scene_text(const Graph& graph, const std::vector<const Node*>& nodes,
                       const std::filesystem::path& folder) {
  std::map<std::string, NodeTypePtr> types;
  for (const Node* node : nodes) types.emplace(node->type->name(), node->type);
  const auto kept_of = [&](const std::string& type) -> const KeptType* {
    const auto kept = graph.kept_types().find(type);
    return kept == graph.kept_types().end() ? nullptr : &kept->second;
  };
  struct Section {
    int version;
    std::string plugin, plugin_version;
    std::vector<std::string> lines;
  };
  std::map<std::string, Section> sections;
  std::map<std::string, std::string> plugins;
  for (const auto& [name, type] : types) {
    const KeptType* kept = kept_of(name);
    Section section{type->version(), type->spec().plugin, type->spec().plugin_version,
                    type_lines(*type, kept)};
    if (kept) {
      // What an older plug-in saves of a newer one stays the newer one's: else the next that opens it would
      // take lines that it does not know for all there is.
      const bool is_newer = !kept->plugin.empty() &&
                            (kept->version > section.version ||
                             version_numbers(kept->plugin_version) > version_numbers(section.plugin_version));
      section.version = std::max(section.version, kept->version);
      if (type->is_unknown() || is_newer) {
        section.plugin = kept->plugin;
        section.plugin_version = kept->plugin_version;
      }
    }
    if (!section.plugin.empty()) {
      std::string& required = plugins[section.plugin];
      if (version_numbers(required) <= version_numbers(section.plugin_version))
        required = section.plugin_version;
    }
    sections.emplace(name, std::move(section));
  }
  for (const auto& [name, kept] : graph.kept_types())
    // A part of the scene needs what its own types need.
    if (name.starts_with("requires ") && (nodes.size() == graph.size() || plugins.contains(kept.plugin))) {
      std::string& required = plugins.try_emplace(kept.plugin, kept.plugin_version).first->second;
      if (version_numbers(required) < version_numbers(kept.plugin_version)) required = kept.plugin_version;
    }

  std::string text = "plinian scene " + std::to_string(scene_major_version) + "." +
                     std::to_string(scene_minor_version) + "\n";
  const auto add_line = [&](const std::string& line) { (text += line) += '\n'; };
  for (const auto& [name, version] : plugins)
    add_line("requires " + (name.find(' ') == name.npos ? name : quote(name)) +
             (version.empty() ? "" : " " + version));
  if (const KeptType* kept = kept_of(""))
    for (const std::string& line : kept->lines) add_line(line);
  for (const Node* node : nodes) {
    ((text += "node ") += node->type->name()) += ' ';
    text += node->name;
    const Node* above = graph.find(node->kept_parent);  // gone: it stands where it does
    if (!above) above = graph.find(node->parent);
    if (above) (text += " under ") += above->name;
    text += '\n';
    for (const std::string& line : node_lines(graph, *node, folder)) add_line(line);
  }
  for (const auto& [name, section] : sections) {
    std::string line = "type " + name + " " + std::to_string(section.version);
    if (!section.plugin.empty()) line += " from " + section.plugin + " " + section.plugin_version;
    add_line(line);
    for (const std::string& inner : section.lines) add_line(inner);
  }
  add_line("end");
  return text;
}

}  // namespace

std::string write_scene(const Graph& graph, const std::filesystem::path& folder) {
  return scene_text(graph, graph.nodes(), folder);
}

std::string write_scene(const Graph& graph, const std::vector<NodeId>& ids,
                        const std::filesystem::path& folder) {
  const std::unordered_set<NodeId> wanted(ids.begin(), ids.end());
  // What the others drive is cut off in copies of the nodes.
  std::vector<Node> copies;
  for (const Node* node : graph.nodes())
    if (wanted.contains(node->id)) copies.push_back(*node);
  std::vector<const Node*> nodes;
  for (Node& node : copies) {
    std::erase_if(node.inputs, [&](const Input& input) { return !wanted.contains(input.source.node); });
    std::erase_if(node.kept,
                  [&](const KeptLine& kept) { return kept.source && !wanted.contains(kept.source); });
    for (NodeId* above : {&node.parent, &node.kept_parent})
      if (!wanted.contains(*above)) *above = {};
    nodes.push_back(&node);
  }
  return scene_text(graph, nodes, folder);
}

void save_scene(const std::string& path, const std::string& text) {
  write_file_durably(path, text);
}

}  // namespace plinian::graph
