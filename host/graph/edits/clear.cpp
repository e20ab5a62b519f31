#include "host/graph/edits/clear.h"

namespace plinian::graph {

void clear_graph(Editor& editor) {
  std::vector<NodeId> nodes;
  for (const Node* node : editor.graph().nodes()) nodes.push_back(node->id);
  editor.delete_nodes(nodes);
  while (!editor.graph().kept_types().empty())
    editor.set_kept_type(std::string(editor.graph().kept_types().begin()->first), std::nullopt);
}

}  // namespace plinian::graph
