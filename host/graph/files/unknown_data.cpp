// Values whose data type comes or goes while a scene is open: with its plug-in.
#include "host/graph/files/unknown_nodes.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

bool is_of(const Node& node, AttributeIndex attribute, const std::string& data_type) {
  const AttributeSpec& spec = (*node.schema)[attribute].spec;
  return spec.type == AttributeType::data && spec.data_type == data_type;
}

}  // namespace

std::vector<std::string> revive_data(Editor& editor, const std::string& data_type) {
  const Graph& graph = editor.graph();
  std::vector<std::string> warnings;
  for (const Node* found : graph.nodes()) {
    if (found->type->is_unknown() || found->kept.empty()) continue;
    const NodeId id = found->id;
    std::vector<KeptLine> rest;
    std::vector<std::pair<Plug, Value>> values;
    for (const KeptLine& kept : found->kept) {
      // "  .path word"
      const std::size_t dot = kept.text.find('.'), space = kept.text.find(' ', dot);
      bool alive = false;
      if (!kept.source && dot != std::string::npos && space != std::string::npos &&
          kept.text.find_first_not_of(" \t") == dot) {
        try {
          Plug plug = Graph::plug(*found, kept.text.substr(dot + 1, space - dot - 1));
          if (is_of(*found, plug.attribute, data_type)) {
            const AttributeSpec& spec = (*found->schema)[plug.attribute].spec;
            plug.node = id;
            values.emplace_back(plug, read_value(spec, split_words(kept.text.substr(space + 1))));
            alive = true;
          }
        } catch (const GraphError& error) {
          warnings.push_back(found->name + ": " + error.what() + "; the line is kept as it is");
        }
      }
      if (!alive) rest.push_back(kept);
    }
    if (values.empty()) continue;
    editor.set_kept(id, std::move(rest));
    for (auto& [plug, value] : values) editor.history().perform(SetValue{plug, std::move(value)});
  }
  return warnings;
}

void forget_data(Editor& editor, const std::string& data_type) {
  const Graph& graph = editor.graph();
  for (const Node* found : graph.nodes()) {
    const NodeId id = found->id;
    std::vector<KeptLine> kept = found->kept;
    std::vector<Plug> plugs;
    for (const StoredValue& stored : found->values) {
      if (!is_of(*found, stored.attribute, data_type)) continue;
      const Plug plug{id, stored.attribute, stored.element, -1};
      const std::string text =
          write_value((*found->schema)[stored.attribute].spec, stored.value, graph.names());
      if (!text.empty())
        kept.push_back({"  ." + Graph::path_of(*found->schema, plug) + " " + text,
                        "",
                        {},
                        "",
                        LinePlace{false, plug.attribute, plug.element, -1}});
      plugs.push_back(plug);
    }
    if (plugs.empty()) continue;
    for (const Plug& plug : plugs) editor.history().perform(SetValue{plug, std::nullopt});
    editor.set_kept(id, std::move(kept));
  }
}

void drop_unwritable_data(Editor& editor) {
  const Graph& graph = editor.graph();
  std::vector<Plug> plugs;
  for (const Node* node : graph.nodes())
    for (const StoredValue& stored : node->values) {
      const AttributeSpec& spec = (*node->schema)[stored.attribute].spec;
      if (spec.type != AttributeType::data) continue;
      try {
        write_value(spec, stored.value);
      } catch (const GraphError&) {
        plugs.push_back({node->id, stored.attribute, stored.element, -1});
      }
    }
  for (const Plug& plug : plugs) editor.history().perform(SetValue{plug, std::nullopt});
}

}  // namespace plinian::graph
