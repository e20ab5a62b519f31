// Its own failure before one that it waits for.
#include "host/window/nodes/node_failure.h"

namespace plinian::window {

std::optional<NodeFailure> failure_of(const graph::Session& session, graph::NodeId id) {
  const graph::Node* node = session.graph().find(id);
  if (!node) return std::nullopt;
  std::optional<NodeFailure> blocked;
  for (const graph::AttributeIndex output : node->schema->outputs())
    for (const std::int32_t element : node->elements(output)) {
      const graph::Plug plug{id, output, element};
      const graph::ResultPtr result = session.evaluator().known(plug);
      if (!result || !result->error) continue;
      NodeFailure failure{session.evaluator().error_text(plug, *result), result->error->origin.node != id};
      if (!failure.blocked) return failure;
      blocked = std::move(failure);
    }
  return blocked;
}

}  // namespace plinian::window
