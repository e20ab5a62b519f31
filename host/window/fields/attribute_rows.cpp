// Walks the schema.
#include "host/window/fields/attribute_rows.h"

#include <algorithm>
#include <cctype>

#include "host/graph/model/conversion.h"

namespace plinian::window {

using graph::AttributeIndex;
using graph::AttributeType;
using graph::Plug;

namespace {

bool has_row(const graph::AttributeSpec& spec) {
  return !spec.output && !spec.hidden && !spec.array && spec.type != AttributeType::data &&
         spec.type != AttributeType::matrix;
}

// A few numbers under one name read as a vector.
bool is_row_of_numbers(const graph::Schema& schema, const graph::SchemaAttribute& attribute) {
  return attribute.children.size() <= 4 &&
         std::all_of(attribute.children.begin(), attribute.children.end(), [&](AttributeIndex child) {
           return graph::is_number(schema[child].spec.type) && schema[child].spec.name.size() == 1;
         });
}

void add_rows(const graph::Schema& schema, AttributeIndex index, std::vector<AttributeIndex>& rows) {
  const graph::SchemaAttribute& attribute = schema[index];
  if (!has_row(attribute.spec)) return;
  if (attribute.spec.type != AttributeType::compound || is_row_of_numbers(schema, attribute))
    return rows.push_back(index);
  for (const AttributeIndex child : attribute.children) add_rows(schema, child, rows);
}

class Walk {
 public:
  Walk(const graph::Graph& graph, const graph::Node& node) : graph_(graph), node_(node) {}

  std::vector<AttributeGroup> run() {
    const graph::Schema& schema = *node_.schema;
    for (AttributeIndex i = 0; i < schema.size(); ++i)
      if (schema[i].parent == graph::no_attribute) add(i, "", 0);
    std::erase_if(groups_, [](const AttributeGroup& group) { return group.rows.empty(); });
    return std::move(groups_);
  }

 private:
  bool is_shown(const graph::AttributeSpec& spec) const {
    if (!has_row(spec)) return false;
    if (spec.layout.shown_when.empty()) return true;
    const AttributeIndex other = node_.schema->find(spec.layout.shown_when);
    if (other == graph::no_attribute) return true;
    const std::string now = write_value((*node_.schema)[other].spec, node_.value(other));
    if (spec.layout.shown_words.empty()) return !now.empty() && now != "false" && now != "0";
    return std::find(spec.layout.shown_words.begin(), spec.layout.shown_words.end(), now) !=
           spec.layout.shown_words.end();
  }

  AttributeGroup& group(const std::string& title, int depth) {
    for (AttributeGroup& known : groups_)
      if (known.title == title) return known;
    // What is deep is seldom touched.
    return groups_.emplace_back(AttributeGroup{title, depth, depth == 0, {}});
  }

  void add(AttributeIndex index, const std::string& above, int depth) {
    const graph::SchemaAttribute& attribute = (*node_.schema)[index];
    const graph::AttributeSpec& spec = attribute.spec;
    if (!is_shown(spec)) return;
    if (spec.type == AttributeType::compound && !is_row_of_numbers(*node_.schema, attribute)) {
      const std::string title = above.empty() ? label_of(spec) : above + " · " + label_of(spec);
      group(title, depth + 1);
      for (const AttributeIndex child : attribute.children) add(child, title, depth + 1);
      return;
    }
    std::string title = above;
    if (title.empty()) title = spec.layout.group.empty() ? "General" : spec.layout.group;
    if (std::islower((unsigned char)title[0])) title[0] = char(std::toupper((unsigned char)title[0]));
    group(title, depth).rows.push_back(row(index));
  }

  AttributeRow row(AttributeIndex index) const {
    const graph::SchemaAttribute& attribute = (*node_.schema)[index];
    AttributeRow row;
    row.plug = {node_.id, index};
    row.name = graph_.name_of(row.plug);
    row.label = label_of(attribute.spec);
    if (attribute.spec.type == AttributeType::compound)
      for (const AttributeIndex child : attribute.children) row.parts.push_back({node_.id, child});
    else if (const int components = graph::component_count(attribute.spec.type); components > 0)
      for (int c = 0; c < components; ++c) row.parts.push_back({node_.id, index, -1, c});
    else if (graph::is_number(attribute.spec.type))
      row.parts.push_back(row.plug);
    std::vector<AttributeIndex> holders = {index};
    holders.insert(holders.end(), attribute.children.begin(), attribute.children.end());
    for (const AttributeIndex holder : holders) {
      row.changed |= node_.stored(holder) != nullptr;
      row.locked |= node_.is_locked(holder);
      for (const graph::Input& input : node_.inputs_of(holder)) row.driver = graph_.name_of(input.source);
    }
    return row;
  }

  const graph::Graph& graph_;
  const graph::Node& node_;
  std::vector<AttributeGroup> groups_;
};

}  // namespace

std::vector<AttributeGroup> attribute_groups(const graph::Graph& graph, const graph::Node& node) {
  return Walk(graph, node).run();
}

std::vector<AttributeIndex> row_attributes(const graph::Schema& schema) {
  std::vector<AttributeIndex> rows;
  for (const AttributeIndex index : schema.top()) add_rows(schema, index, rows);
  return rows;
}

std::string label_of(const graph::AttributeSpec& spec) {
  if (!spec.nice_name.empty()) return spec.nice_name;
  std::string label = spec.name;
  std::replace(label.begin(), label.end(), '_', ' ');
  if (!label.empty() && label.size() > 1) label[0] = char(std::toupper((unsigned char)label[0]));
  return label;
}

std::string part_label(const graph::Graph& graph, const AttributeRow& row, std::size_t part) {
  if (row.parts.size() < 2) return "";
  const std::string name = graph.name_of(row.parts[part]);
  return name.substr(name.rfind('.') + 1);
}

}  // namespace plinian::window
