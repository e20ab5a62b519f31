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
  std::string path, rest, last;
  for (const SceneLine& line : section_.lines) {
    try {
      if (!split_attribute(line.text, path, rest)) throw GraphError("");
      const Plug plug = Graph::plug(model, path);
      const SchemaAttribute& attribute = (*model.schema)[plug.attribute];
      last = attribute.path;
      if (attribute.spec.type == AttributeType::node) continue;  // always none
      const Value value = fitted(attribute.spec, read_value(attribute.spec, split_words(rest)));
      if (value != attribute.spec.default_value) other_defaults_.emplace_back(plug.attribute, value);
    } catch (const GraphError&) {
      // From an older version a migrator may make something of it; from a newer one it is kept.
      if (section_.version < type_->version()) continue;
      unknown_lines_.emplace_back(line.text);
      unknown_after_.push_back(last);
    }
  }
}

KeptType NodeReader::kept() const {
  return {section_.version, section_.plugin, section_.plugin_version, unknown_lines_, unknown_after_};
}

bool NodeReader::keeps_anything() const {
  const NodeTypeSpec& here = type_->spec();
  const bool of_newer_plugin = section_.plugin == here.plugin && version_numbers(section_.plugin_version) >
                                                                     version_numbers(here.plugin_version);
  return type_->is_unknown() || section_.version > type_->version() || of_newer_plugin ||
         !unknown_lines_.empty();
}

std::optional<LinePlace> place_in(const Node& node, const std::string& path, bool lock) {
  try {
    const Plug plug = Graph::plug(node, path);
    return LinePlace{lock, plug.attribute, plug.element, plug.component};
  } catch (const GraphError&) {
    return std::nullopt;
  }
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

namespace {

// Where the lines of a node stand, found out once anybody asks.
class Places {
 public:
  Places(const Node& node, const std::vector<SceneLine>& lines) : node_(node), lines_(lines) {}

  LinePlace operator[](std::size_t index) {
    if (places_.empty()) find();
    return places_[index];
  }

 private:
  void find() {
    LinePlace last;
    std::string path, rest;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::string_view line = lines_[i].text;
      std::optional<LinePlace> own;
      if (split_attribute(line, path, rest)) {
        own = place_in(node_, path);
      } else if (const std::size_t lock = line.find_first_not_of(" \t");
                 lock != line.npos && line.substr(lock).starts_with("lock .")) {
        own = place_in(node_, std::string(line.substr(lock + 6)), true);
        if (!own && !last.lock) own = LinePlace{true};
      }
      last = own.value_or(last);
      last.order = std::int32_t(i) + 1;
      places_.push_back(last);
    }
  }

  const Node& node_;
  const std::vector<SceneLine>& lines_;
  std::vector<LinePlace> places_;
};

}  // namespace

NodeText NodeReader::read(const std::string& name, const std::vector<SceneLine>& lines, const WarnLine& warn,
                          const std::function<void(int, const std::string&)>& fail) const {
  NodeText result;
  Node& node = result.node;
  node.name = name;
  node.type = type_;
  node.schema = type_->schema();
  StoredAttributes stored;
  Places places(node, lines);
  std::map<std::string, std::size_t> line_of;       // by path: the index of the line
  std::vector<std::size_t> connections, not_known;  // indices; not_known: lines of a newer version
  std::vector<AttributeSpec> added;
  std::string path, rest;
  // The last of several lines about one thing counts.
  const auto warn_of_two = [&](const std::string& what, int before, int now) {
    warn(now, name + ": " + what + " is given a second time: this line counts" +
                  (before ? ", not line " + std::to_string(before) : ""));
  };
  for (std::size_t index = 0; index < lines.size(); ++index) {
    const SceneLine& line = lines[index];
    if (split_attribute(line.text, path, rest)) {
      if (type_->is_unknown() && !is_connection(rest)) {
        node.kept.push_back({std::string(line.text)});
      } else if (type_->is_unknown()) {
        result.links.connections.push_back({path, rest.substr(3), std::string(line.text), line.number});
        node.kept.push_back({std::string(line.text), path, {}, rest.substr(3)});
      } else if (is_connection(rest)) {
        connections.push_back(index);
      } else if (const auto [first, alone] = line_of.emplace(path, index); alone) {
        stored.push_back({path, ""});
      } else {
        warn_of_two("." + path, lines[first->second].number, line.number);
        first->second = index;
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
        not_known.push_back(index);
      } else {
        throw GraphError("is no line of a node: " + shown(line.text));
      }
    } catch (const GraphError& error) {
      if (!newer_) fail(line.number, error.what());
      warn(line.number, name + ": " + error.what() + "; the line is kept as it is");
      not_known.push_back(index);
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

  for (StoredAttribute& attribute : stored) {
    split_attribute(lines[line_of.at(attribute.path)].text, path, rest);
    attribute.text = rest;
  }
  std::map<std::string, std::size_t> connected;  // by path: which of the links
  for (const std::size_t index : connections) {
    split_attribute(lines[index].text, path, rest);
    const std::optional<LinePlace> own = place_in(node, path);
    NodeLinks::Link link{path, rest.substr(3), std::string(lines[index].text), lines[index].number,
                         own ? *own : places[index]};
    // Each connection to an array takes an element of its own.
    const bool array = own && own->element < 0 && (*node.schema)[own->attribute].array != no_attribute;
    const auto [first, alone] = connected.emplace(path, result.links.connections.size());
    if (alone || array) {
      result.links.connections.push_back(std::move(link));
      continue;
    }
    NodeLinks::Link& before = result.links.connections[first->second];
    warn_of_two("the source of ." + path, before.number, link.number);
    before = std::move(link);
  }
  for (const std::size_t index : not_known)
    node.kept.push_back({std::string(lines[index].text), "", {}, "", places[index]});
  for (auto& lock : result.links.locks)
    lock.place = place_in(node, lock.path, true).value_or(LinePlace{true});

  const bool migrates = !type_->is_unknown() && section_.version < type_->version();
  std::map<std::string, std::string> not_migrated;  // by path: the text
  if (migrates) {
    StoredAttributes defaults;
    for (const SceneLine& line : section_.lines)
      if (split_attribute(line.text, path, rest)) defaults.push_back({path, rest});
    stored = overlaid(defaults, stored);
    for (const StoredAttribute& attribute : stored) not_migrated.emplace(attribute.path, attribute.text);
    migrate(name, stored);
  }

  std::map<std::pair<AttributeIndex, std::int32_t>, Value> values;
  for (const StoredAttribute& attribute : stored) {
    const auto source = line_of.find(attribute.path);
    // What a migrator made stands in no line.
    std::string made;
    if (source == line_of.end()) made = "  ." + attribute.path + " " + attribute.text;
    const SceneLine line = source == line_of.end() ? SceneLine{made, 0} : lines[source->second];
    const auto before = not_migrated.find(attribute.path);
    const bool migrated = migrates && (before == not_migrated.end() || before->second != attribute.text);
    const auto place = [&] { return source == line_of.end() ? LinePlace() : places[source->second]; };
    bool known = false;
    try {
      const Plug plug = Graph::plug(node, attribute.path);
      known = true;
      const SchemaAttribute& found = (*node.schema)[plug.attribute];
      if (found.array != no_attribute && plug.element < 0) continue;  // default of an element
      if (found.spec.type == AttributeType::node) {
        result.links.references.push_back({attribute.path, attribute.text, std::string(line.text),
                                           line.number, LinePlace{false, plug.attribute, plug.element, -1}});
        continue;
      }
      bool clamped = false;
      Value value = fitted(found.spec, read_value(found.spec, split_words(attribute.text)), &clamped);
      if (clamped)
        warn(line.number, name + "." + attribute.path + " is out of its range (" + expectation(found.spec) +
                              ") and was set to " + write_value(found.spec, value));
      if (found.array == no_attribute && value == found.spec.default_value) value = std::monostate();
      const auto [set, alone] = values.insert_or_assign({plug.attribute, plug.element}, std::move(value));
      // By an older name and by its own.
      if (!alone && !migrates) warn_of_two("." + found.path, 0, line.number);
    } catch (const GraphError& error) {
      if (migrated) {
        warn(line.number, name + ": its migration from version " + std::to_string(section_.version) +
                              " of the type sets " + shown("." + attribute.path + " " + attribute.text) +
                              ", but " + (known ? name + "." + attribute.path + " " : "") + error.what() +
                              "; the line is kept as it " + (source == line_of.end() ? "is" : "was"));
      } else if (source == line_of.end() && migrates) {
        continue;  // a default of an attribute that is no more
      } else {
        warn(line.number,
             (known ? name + "." + attribute.path + " " : "") + error.what() + "; the line is kept as it is");
      }
      node.kept.push_back({std::string(line.text), "", {}, "", place()});
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
    kept.push_back({link.line, "", {}, "", link.place});
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
      kept.push_back({"", connection.path, source, source_path, connection.place});
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
