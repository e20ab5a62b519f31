// Contributions and draw data as outputs.
#include "host/sdk/hidden_outputs.h"

#include <algorithm>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/sdk/contribute_table.h"
#include "host/sdk/contribution.h"
#include "host/sdk/data_type_table.h"
#include "host/sdk/draw_override.h"
#include "host/sdk/inside_plugin.h"
#include "host/sdk/plain_text.h"

namespace plinian::sdk {

using graph::AttributeSpec;
using graph::GraphError;

namespace {

graph::AttributeIndex count(const std::vector<AttributeSpec>& attributes) {
  graph::AttributeIndex result = 0;
  for (const AttributeSpec& attribute : attributes) result += 1 + count(attribute.children);
  return result;
}

// As a schema numbers them.
void add_paths(const std::vector<AttributeSpec>& attributes, const std::string& prefix,
               std::vector<std::string>& paths) {
  for (const AttributeSpec& attribute : attributes) {
    paths.push_back(prefix + attribute.name);
    add_paths(attribute.children, paths.back() + ".", paths);
  }
}

// Returns its place in the schema.
graph::AttributeIndex add_output(graph::NodeTypeSpec& spec, const char* name, const char* data_type,
                                 const char* help) {
  const graph::AttributeIndex place = count(spec.attributes);
  spec.attributes.push_back({.name = name,
                             .type = graph::AttributeType::data,
                             .help = help,
                             .data_type = data_type,
                             .output = true,
                             .connectable = false,
                             .hidden = true,
                             .read_only = true});
  return place;
}

graph::AttributeIndex add_draw_data(graph::NodeTypeSpec& spec, const PlinianDraw& draw) {
  if (!draw.prepare || !draw.draw)
    throw GraphError("node type '" + spec.name + "': a draw override needs prepare and draw");
  const std::vector<std::string> wanted = words_of(draw.affected_by);
  std::vector<std::string> known;
  for (AttributeSpec& attribute : spec.attributes) {
    if (attribute.output) continue;
    known.push_back(attribute.name);
    if (!draw.affected_by || std::find(wanted.begin(), wanted.end(), attribute.name) != wanted.end())
      attribute.affects.push_back(draw_data_output);
  }
  for (const std::string& name : wanted)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw GraphError("node type '" + spec.name + "': its draw override is affected by '" + name +
                       "', which is no input" + did_you_mean(name, known));
  return add_output(spec, draw_data_output, draw_data_type, "What a viewport draws of the node.");
}

graph::Value draw_data_by(const PlinianDraw& draw, ComputeState& state) {
  PlinianData plain{};
  plain.size = sizeof(plain);
  draw.prepare(draw.user, &compute_table, state.plain(), &plain);
  plain.type = draw_data_type;
  // Also where it failed after all: what it made must be released.
  graph::DataPtr data = data_from(&plain, state.data);
  if (!state.failure.empty()) throw GraphError(state.failure);
  return data;
}

}  // namespace

graph::AttributeIndex draw_data_of(const graph::NodeType& type) {
  const graph::AttributeIndex output = type.schema()->find(draw_data_output);
  const bool drawn =
      output != graph::no_attribute && (*type.schema())[output].spec.data_type == draw_data_type;
  return drawn ? output : graph::no_attribute;
}

void add_hidden_outputs(graph::NodeTypeSpec& spec, const PlinianNodeType& from,
                        const std::shared_ptr<DataCount>& data) {
  if (from.contribute) {
    const std::vector<PlinianAttribute> attributes = all_of(from.attributes, from.attribute_count);
    for (std::size_t i = 0; i < attributes.size(); ++i)
      if (!(attributes[i].flags & (PLINIAN_ATTRIBUTE_NOT_OF_PICTURE | PLINIAN_ATTRIBUTE_OUTPUT)))
        spec.attributes[i].affects.push_back(contribution_output);
  }
  const PlinianDraw draw = whole(from.draw);
  const graph::AttributeIndex drawn = from.draw ? add_draw_data(spec, draw) : graph::no_attribute;
  graph::AttributeIndex contribution = graph::no_attribute;
  if (from.contribute) {
    contribution =
        add_output(spec, contribution_output, contribution_type, "What the shape adds to the picture.");
    spec.hierarchical = true;
  }
  if (!from.compute && !from.contribute && !from.draw) return;
  const auto paths = std::make_shared<std::vector<std::string>>();
  add_paths(spec.attributes, "", *paths);
  spec.compute = [=, compute = from.compute, contribute = from.contribute, user = from.user](
                     graph::ComputeContext& context, graph::AttributeIndex wanted) {
    const InsidePlugin inside(data->owner, "computing", context.node_name().c_str(),
                              (*paths)[std::size_t(wanted)].c_str());
    ComputeState state(context, data);
    if (wanted == contribution) return context.set_output(wanted, contribution_by(contribute, user, state));
    if (wanted == drawn) return context.set_output(wanted, draw_data_by(draw, state));
    if (!compute) throw GraphError("the type has no compute function");
    compute(user, &compute_table, state.plain(), wanted);
    if (!state.failure.empty()) throw GraphError(state.failure);
  };
}

}  // namespace plinian::sdk
