// Node types.
#include "host/graph/types/node_type.h"

#include <algorithm>
#include <tuple>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

namespace {

// What could never be so, and hide an attribute for ever or show it always.
std::string shown_when_problem(const Schema& schema, const AttributeLayout& layout) {
  if (layout.shown_when.empty()) return "";
  const std::string name = "'" + layout.shown_when + "'";
  const AttributeIndex other = schema.find(layout.shown_when);
  if (other == no_attribute)
    return name + " reads so, which is no attribute" + did_you_mean(layout.shown_when, schema.paths());
  const AttributeSpec& spec = schema[other].spec;
  std::vector<std::string> words;
  if (spec.type == AttributeType::boolean) words = {"true", "false"};
  for (const Choice& choice : spec.choices) words.push_back(choice.word);
  for (const std::string& word : layout.shown_words)
    if (!words.empty() && std::find(words.begin(), words.end(), word) == words.end())
      return name + " reads " + shown(word) + ", which it never does" + did_you_mean(word, words);
  return "";
}

}  // namespace

NodeType::NodeType(NodeTypeSpec spec) : spec_(std::move(spec)) {
  const auto wrong = [&](const std::string& why) {
    throw GraphError("node type '" + spec_.name + "': " + why);
  };
  if (!is_identifier(spec_.name)) wrong("a name is a letter or _, then letters, digits and _");
  if (spec_.version < 1) wrong("versions count from 1");
  if (spec_.holds_children && !spec_.hierarchical) wrong("a parent must have a place in the hierarchy");
  try {
    schema_ = std::make_shared<const Schema>(spec_.attributes);
  } catch (const GraphError& error) {
    wrong(error.what());
  }
  for (AttributeIndex i = 0; i < schema_->size(); ++i)
    if (const std::string problem = shown_when_problem(*schema_, (*schema_)[i].spec.layout); !problem.empty())
      wrong("attribute '" + (*schema_)[i].path + "' is shown when " + problem);
  if (!spec_.compute && !schema_->outputs().empty()) wrong("has outputs but computes nothing");
  for (const AttributeAlias& alias : spec_.aliases) {
    if (schema_->find(alias.path) == no_attribute)
      wrong("the alias '" + alias.old_path + "' names no attribute");
    if (schema_->find(alias.old_path) != no_attribute)
      wrong("the alias '" + alias.old_path + "' is an attribute");
  }
  for (const Migrator& migrator : spec_.migrators)
    if (migrator.from < 1 || migrator.from >= spec_.version || !migrator.migrate)
      wrong("a migrator must lead from an older version");
  spec_.attributes.clear();  // the schema holds them
}

std::shared_ptr<const NodeType> NodeType::unknown(std::string name, int version) {
  const std::shared_ptr<NodeType> type(new NodeType);
  type->spec_.name = std::move(name);
  type->spec_.version = version;
  // Nothing is known against it.
  type->spec_.hierarchical = type->spec_.holds_children = true;
  type->schema_ = std::make_shared<const Schema>();
  type->unknown_ = true;
  return type;
}

std::shared_ptr<const NodeType> NodeType::without_code() const {
  const std::shared_ptr<NodeType> type(new NodeType(*this));
  type->spec_.compute = nullptr;
  type->spec_.migrators.clear();
  type->codeless_ = true;
  return type;
}

bool NodeType::holds_the_same(const NodeType& other) const {
  const Schema &a = *schema_, &b = *other.schema_;
  if (name() != other.name() || version() != other.version() || a.size() != b.size() ||
      spec_.hierarchical != other.spec_.hierarchical || spec_.holds_children != other.spec_.holds_children)
    return false;
  const auto facts = [](const SchemaAttribute& attribute) {
    const AttributeSpec& s = attribute.spec;
    return std::tie(attribute.path, s.type, s.array, s.output, s.data_type, s.default_value, s.minimum,
                    s.maximum);
  };
  const auto numbers = [](const SchemaAttribute& attribute) {
    std::vector<int> result;
    for (const Choice& choice : attribute.spec.choices) result.push_back(choice.value);
    return result;
  };
  for (AttributeIndex i = 0; i < a.size(); ++i)
    if (facts(a[i]) != facts(b[i]) || numbers(a[i]) != numbers(b[i])) return false;
  return true;
}

std::string current_path(const std::vector<AttributeAlias>& aliases, std::string_view path) {
  for (const AttributeAlias& alias : aliases) {
    if (path == alias.old_path) return alias.path;
    if (path.starts_with(alias.old_path) &&
        (path[alias.old_path.size()] == '[' || path[alias.old_path.size()] == '.'))
      return alias.path + std::string(path.substr(alias.old_path.size()));
  }
  return std::string(path);
}

}  // namespace plinian::graph
