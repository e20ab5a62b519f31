// Scores the attributes of each type once, however many nodes have them.
#include "host/window/palette/attribute_entries.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "host/graph/graph_error.h"
#include "host/window/fields/attribute_rows.h"
#include "host/window/fields/edit_lines.h"
#include "host/window/palette/fuzzy.h"

namespace plinian::window {

namespace {

using Scores = std::vector<std::optional<int>>;  // of each word

// What is typed: words that a node must have, that an attribute must have, and that either may have.
struct Query {
  std::vector<std::vector<std::string>> words;  // each by itself
  std::size_t of_node = 0;                      // the first ones are the node's
  bool is_dotted = false;                       // the others are the attribute's
};

Query read(const std::string& text) {
  Query query;
  const std::size_t dot = text.find('.');
  query.is_dotted = dot != text.npos;
  for (std::string& word : words_of(text.substr(0, dot))) query.words.push_back({std::move(word)});
  if (!query.is_dotted) return query;
  query.of_node = query.words.size();
  std::string rest = text.substr(dot + 1);
  std::replace(rest.begin(), rest.end(), '.', ' ');
  for (std::string& word : words_of(rest)) query.words.push_back({std::move(word)});
  return query;
}

Scores scores_of(const Query& query, const std::string& text) {
  Scores scores;
  for (const auto& word : query.words) scores.push_back(fuzzy_score(word, text));
  return scores;
}

struct Candidate {
  graph::AttributeIndex attribute = graph::no_attribute;
  Scores scores;
};

// Those of a type that have a word of the query.
std::vector<Candidate> candidates(const Query& query, const graph::Schema& schema) {
  std::vector<Candidate> found;
  for (const graph::AttributeIndex index : row_attributes(schema)) {
    // Not the first word of what it is called by: the node's name stands before it.
    Scores scores = scores_of(query, "." + schema[index].path);
    const Scores by_label = scores_of(query, " " + label_of(schema[index].spec));
    bool any = query.is_dotted && query.of_node == query.words.size();
    for (std::size_t w = 0; w < scores.size(); ++w) {
      scores[w] = std::max(scores[w], by_label[w]);
      any |= w >= query.of_node && scores[w];
    }
    if (any) found.push_back({index, std::move(scores)});
  }
  return found;
}

// Of both names together; none where a word is in neither.
std::optional<int> total(const Query& query, const Scores& of_attribute, const Scores& of_node) {
  int sum = 0;
  for (std::size_t w = 0; w < query.words.size(); ++w) {
    std::optional<int> score;
    if (w >= query.of_node) score = of_attribute[w];
    if ((w < query.of_node || !query.is_dotted) && !of_node.empty()) score = std::max(score, of_node[w]);
    if (!score) return std::nullopt;
    sum += *score;
  }
  return sum;
}

std::optional<AttributeRow> row_of(const graph::Graph& graph, const graph::Plug& plug) {
  for (AttributeGroup& group : attribute_groups(graph, *graph.find(plug.node)))
    for (AttributeRow& row : group.rows)
      if (row.plug == plug) return std::move(row);
  return std::nullopt;
}

// None while another attribute keeps it from being shown.
std::optional<PaletteEntry> entry_of(const graph::Graph& graph, const graph::Plug& plug) {
  const auto row = row_of(graph, plug);
  if (!row) return std::nullopt;
  const graph::AttributeSpec& spec = graph.attribute(plug).spec;
  std::string value;
  if (!row->driver.empty()) {
    value = "driven by " + row->driver;
  } else if (spec.type == graph::AttributeType::compound) {
    for (const graph::Plug& part : row->parts) value += (value.empty() ? "" : " ") + words_at(graph, part);
  } else {
    value = words_at(graph, plug);
  }
  std::string unit = spec.unit;
  if (unit.empty() && !row->parts.empty()) unit = graph.attribute(row->parts.front()).spec.unit;
  if (!unit.empty()) value += " " + unit;
  if (row->locked) value += ", locked";
  return PaletteEntry{.title = row->name,
                      .kind = "attribute",
                      .detail = value,
                      .keys = "",
                      .action = {},
                      .line = "select " + graph.find(plug.node)->name,
                      .field = row->name};
}

}  // namespace

std::vector<PaletteEntry> attribute_entries(const graph::Graph& graph, const std::string& text,
                                            std::size_t most) {
  const Query query = read(text);
  std::size_t letters = 0;
  for (const auto& word : query.words) letters += word[0].size();
  if (letters < 2) return {};
  constexpr int for_selected = 32;                                   // as much as the first letter of a name
  using Rank = std::tuple<int, std::size_t, graph::AttributeIndex>;  // -score, place of the node, attribute
  std::vector<std::pair<Rank, graph::NodeId>> found;
  std::map<const graph::Schema*, std::vector<Candidate>> of_types;
  const std::set<graph::NodeId> selected(graph.selection().begin(), graph.selection().end());
  const std::vector<const graph::Node*> nodes = graph.nodes();
  for (std::size_t place = 0; place < nodes.size(); ++place) {
    const graph::Node& node = *nodes[place];
    const auto [type, is_new] = of_types.try_emplace(node.schema.get());
    if (is_new) type->second = candidates(query, *node.schema);
    if (type->second.empty()) continue;
    // A single word is the attribute's.
    const bool asks_name = query.words.size() > 1 || query.of_node > 0;
    const Scores of_node = asks_name ? scores_of(query, node.name) : Scores();
    for (const Candidate& candidate : type->second)
      if (const auto sum = total(query, candidate.scores, of_node)) {
        const int score = *sum + (selected.contains(node.id) ? 0 : -for_selected);
        found.push_back({{-score, place, candidate.attribute}, node.id});
      }
  }
  std::sort(found.begin(), found.end());
  std::vector<PaletteEntry> entries;
  for (const auto& [rank, node] : found) {
    if (entries.size() >= most) break;
    if (auto entry = entry_of(graph, {node, std::get<2>(rank)})) {
      entry->score = -std::get<0>(rank);
      entries.push_back(std::move(*entry));
    }
  }
  return entries;
}

std::optional<PaletteEntry> attribute_entry(const graph::Graph& graph, const std::string& name) {
  try {
    return entry_of(graph, graph.plug(name));
  } catch (const graph::GraphError&) {
    return std::nullopt;
  }
}

}  // namespace plinian::window
