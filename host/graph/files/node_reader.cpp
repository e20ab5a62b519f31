// Reads nodes from lines.
#include "host/graph/files/node_reader.h"

#include <algorithm>
#include <map>

#include "host/graph/files/attribute_declaration.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

// "  .path the rest": path and rest. False where the line is none such.
bool split_attribute(std::string_view line, std::string& path, std::string& rest) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == line.npos || line[begin] != '.') return false;
  line.remove_prefix(begin + 1);
  const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  path = line.substr(0, end);
  const std::size_t more = line.find_first_not_of(" \t", end);
  rest = more == line.npos ? "" : line.substr(more);
  return !path.empty();
}

bool is_connection(const std::string& rest) {
  return rest.starts_with("<- ");
}

// The defaults of a section beneath the lines of a node: what the node was when it was saved.
StoredAttributes overlaid(const StoredAttributes& section, const StoredAttributes& node) {
  StoredAttributes result = section;
  for (const StoredAttribute& attribute : node) {
    const auto same = std::find_if(result.begin(), result.end(), [&](const StoredAttribute& other) {
      return other.path == attribute.path;
    });
    if (same == result.end())
      result.push_back(attribute);
    else
      same->text = attribute.text;
  }
  return result;
}

}  // namespace

NodeReader::NodeReader(NodeTypePtr type, const TypeSection& section, bool newer)
    : type_(std::move(type)), section_(section), newer_(newer) {
  if (type_->is_unknown()) {
    for (const SceneLine& line : section_.lines) unknown_lines_.emplace_back(line.text);
    return;
  }
  Node model;
  model.type = type_;
  model.schema = type_->schema();
  std::string path, rest;
  for (const SceneLine& line : section_.lines) {
    try {
      if (!split_attribute(line.text, path, rest)) throw GraphError("");
      const Plug plug = Graph::plug(model, path);
      const SchemaAttribute& attribute = (*model.schema)[plug.attribute];
      if (attribute.spec.type == AttributeType::node) continue;  // always none
      const Value value = fitted(attribute.spec, read_value(attribute.spec, split_words(rest)));
      if (value != attribute.spec.default_value) other_defaults_.emplace_back(plug.attribute, value);
    } catch (const GraphError&) {
      // From an older version a migrator may make something of it; from a newer one it is kept.
      if (section_.version >= type_->version()) unknown_lines_.emplace_back(line.text);
    }
  }
}

KeptType NodeReader::kept() const {
  return {section_.version, section_.plugin, section_.plugin_version, unknown_lines_};
}

bool NodeReader::keeps_anything() const {
  return type_->is_unknown() || section_.version > type_->version() || !unknown_lines_.empty();
}

void NodeReader::migrate(const std::string& name, StoredAttributes& stored) const {
  for (int version = section_.version; version < type_->version(); ++version)
    for (const Migrator& migrator : type_->spec().migrators) {
      if (migrator.from != version) continue;
      try {
        migrator.migrate(stored);
      } catch (const std::exception& error) {
        throw MigrationError(
            type_->name(),
            name + " cannot be migrated from version " + std::to_string(version) + " of the type '" +
                type_->name() + "': " + error.what() +
                "; nodes of the type are kept as they are: load a plug-in that can migrate them");
      }
    }
}

NodeText NodeReader::read(const std::string& name, const std::vector<SceneLine>& lines, const WarnLine& warn,
                          const std::function<void(int, const std::string&)>& fail) const {
  NodeText result;
  Node& node = result.node;
  node.name = name;
  node.type = type_;
  node.schema = type_->schema();
  StoredAttributes stored;
  std::map<std::string, SceneLine> line_of;  // by path, for messages and for keeping
  std::vector<AttributeSpec> added;
  std::string path, rest;
  for (const SceneLine& line : lines) {
    if (split_attribute(line.text, path, rest)) {
      if (is_connection(rest)) {
        result.links.connections.push_back({path, rest.substr(3), std::string(line.text), line.number});
        if (type_->is_unknown()) node.kept.push_back({std::string(line.text), path, {}, rest.substr(3)});
      } else if (type_->is_unknown()) {
        node.kept.push_back({std::string(line.text)});
      } else if (line_of.emplace(path, line).second) {
        stored.push_back({path, rest});
      }
      continue;
    }
    if (type_->is_unknown()) {
      node.kept.push_back({std::string(line.text)});
      continue;
    }
    try {
      const std::vector<Word> words = split_words(line.text);
      if (words.empty()) continue;
      if (words[0].text == "add") {
        std::string added_path;
        AttributeSpec spec = read_declaration(std::span(words).subspan(1), added_path);
        add_declaration(added, added_path, std::move(spec));
      } else if (words[0].text == "lock" && words.size() == 2 && words[1].text.starts_with('.')) {
        result.links.locks.push_back({words[1].text.substr(1), "", std::string(line.text), line.number});
      } else if (newer_) {
        node.kept.push_back({std::string(line.text)});
      } else {
        throw GraphError("is no line of a node: " + shown(line.text));
      }
    } catch (const GraphError& error) {
      fail(line.number, error.what());
    }
  }
  for (const AttributeSpec& spec : added) {
    try {
      node.schema = std::make_shared<const Schema>(node.schema->with_dynamic(spec));
    } catch (const GraphError& error) {
      // The type has one of that name by now: the value goes there.
      if (node.schema->find(spec.name) == no_attribute) warn(0, name + ": " + error.what());
    }
  }

  const bool migrates = !type_->is_unknown() && section_.version < type_->version();
  if (migrates) {
    StoredAttributes defaults;
    for (const SceneLine& line : section_.lines)
      if (split_attribute(line.text, path, rest)) defaults.push_back({path, rest});
    stored = overlaid(defaults, stored);
    migrate(name, stored);
  }

  std::map<std::pair<AttributeIndex, std::int32_t>, Value> values;
  for (const StoredAttribute& attribute : stored) {
    const auto source = line_of.find(attribute.path);
    // What a migrator made stands in no line.
    std::string made;
    if (source == line_of.end()) made = "  ." + attribute.path + " " + attribute.text;
    const SceneLine line = source == line_of.end() ? SceneLine{made, 0} : source->second;
    bool known = false;
    try {
      const Plug plug = Graph::plug(node, attribute.path);
      known = true;
      const SchemaAttribute& found = (*node.schema)[plug.attribute];
      if (found.array != no_attribute && plug.element < 0) continue;  // default of an element
      if (found.spec.type == AttributeType::node) {
        result.links.references.push_back(
            {attribute.path, attribute.text, std::string(line.text), line.number});
        continue;
      }
      bool clamped = false;
      Value value = fitted(found.spec, read_value(found.spec, split_words(attribute.text)), &clamped);
      if (clamped)
        warn(line.number, name + "." + attribute.path + " is out of its range (" + expectation(found.spec) +
                              ") and was set to " + write_value(found.spec, value));
      if (found.array == no_attribute && value == found.spec.default_value)
        values.emplace(std::pair(plug.attribute, plug.element), std::monostate());
      else
        values.emplace(std::pair(plug.attribute, plug.element), std::move(value));
    } catch (const GraphError& error) {
      if (source == line_of.end() && migrates) continue;  // a default of an attribute that is no more
      warn(line.number,
           (known ? name + "." + attribute.path + " " : "") + error.what() + "; the line is kept as it is");
      node.kept.push_back({std::string(line.text)});
    }
  }
  if (!migrates)
    for (const auto& [attribute, value] : other_defaults_) values.emplace(std::pair(attribute, -1), value);
  for (auto& [place, value] : values) {
    if (std::holds_alternative<std::monostate>(value)) continue;
    if (place.second < 0 && (*node.schema)[place.first].array != no_attribute) continue;
    node.values.push_back({place.first, place.second, std::move(value)});
  }
  // Elements that exist and leave one of their attributes at a default that is another by now.
  for (const auto& [attribute, value] : other_defaults_) {
    if ((*node.schema)[attribute].array == no_attribute) continue;
    for (const std::int32_t element : node.elements(attribute))
      if (!node.stored(attribute, element)) {
        const auto at = std::find_if(node.values.begin(), node.values.end(), [&](const StoredValue& other) {
          return std::pair(other.attribute, other.element) > std::pair(attribute, element);
        });
        node.values.insert(at, {attribute, element, value});
      }
  }
  return result;
}

void finish_node(Editor& editor, NodeId id, const NodeLinks& links,
                 const std::function<NodeId(std::string_view)>& node_of, const WarnLine& warn) {
  const Graph& graph = editor.graph();
  std::vector<KeptLine> kept = graph.find(id)->kept;
  const std::size_t kept_before = kept.size();
  bool resolved = false;
  const auto keep = [&](const NodeLinks::Link& link, const std::string& why) {
    warn(link.number, why + "; the line is kept as it is");
    kept.push_back({link.line});
  };
  for (const auto& reference : links.references) {
    try {
      const std::vector<Word> words = split_words(reference.text);
      const NodeId target = words.size() == 1 ? node_of(words[0].text) : NodeId();
      if (words.size() != 1 || (!target && words[0].text != "none"))
        throw GraphError(graph.find(id)->name + "." + reference.path + ": there is no node " +
                         shown(reference.text));
      if (target) editor.set(Graph::plug(*graph.find(id), reference.path), target);
    } catch (const GraphError& error) {
      keep(reference, error.what());
    }
  }
  for (const auto& connection : links.connections) {
    const std::size_t dot = connection.text.find('.');
    const std::string source_path = dot == std::string::npos ? "" : connection.text.substr(dot + 1);
    const NodeId source = node_of(connection.text.substr(0, dot));
    if (graph.find(id)->type->is_unknown()) {
      // Kept at its place; only the name of the source is looked up, so that it follows a new name.
      for (KeptLine& line : kept)
        if (source && line.text == connection.line && line.path == connection.path && !line.source) {
          line.source = source;
          line.source_path = source_path;
          resolved = true;
          break;
        }
      continue;
    }
    if (source && graph.find(source)->type->is_unknown()) {
      kept.push_back({"", connection.path, source, source_path});
      continue;
    }
    try {
      if (!source)
        throw GraphError(graph.find(id)->name + "." + connection.path +
                         ": there is no node for the connection from " + shown(connection.text));
      editor.connect(Graph::plug(*graph.find(source), source_path),
                     Graph::plug(*graph.find(id), connection.path));
    } catch (const GraphError& error) {
      keep(connection, error.what());
    }
  }
  for (const auto& lock : links.locks) {
    try {
      editor.lock(Graph::plug(*graph.find(id), lock.path), true);
    } catch (const GraphError& error) {
      keep(lock, error.what());
    }
  }
  if (kept.size() != kept_before || resolved) editor.set_kept(id, std::move(kept));
}

}  // namespace plinian::graph
