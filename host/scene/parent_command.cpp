// parent, in a scene of places: what is put under another node stays where it is in the world, as in Maya.
#include "core/scene/placement_angles.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/hierarchy.h"
#include "host/scene/placed.h"
#include "host/scene/scene_commands.h"

namespace plinian::scene {

using graph::Arguments;
using graph::CommandResult;
using graph::Node;
using graph::NodeId;
using graph::Plug;
using graph::Session;

namespace {

constexpr const char* place_attributes[] = {"translate", "rotate", "scale"};

struct Stood {
  NodeId node, parent;
  dmat4 world;
};

// Why the place of a node cannot be written; empty where it can.
std::string fixed_place(Session& session, const Node& node) {
  for (const char* name : place_attributes)
    if (node.schema->find(name) != graph::no_attribute)
      for (const Plug& leaf : leaf_plugs(session.graph(), graph::Graph::plug(node, name)))
        if (const std::string problem = session.editor().set_problem(leaf); !problem.empty()) return problem;
  return "";
}

void write_place(Session& session, const Node& node, const Placement& placement) {
  const dvec3 values[] = {placement.translate, placement.rotate, placement.scale};
  for (int i = 0; i < 3; ++i) {
    const graph::AttributeIndex compound = node.schema->find(place_attributes[i]);
    if (compound == graph::no_attribute) continue;
    const auto leaves = leaf_plugs(session.graph(), {node.id, compound});
    for (int part = 0; part < 3; ++part)
      session.editor().set(leaves[std::size_t(part)], graph::Value(values[i][part]));
  }
}

// What a type has no attribute for, as a light's scale, is no part of where it is.
void keep_place(Session& session, const Stood& stood) {
  const Node& node = *session.graph().find(stood.node);
  if (node.parent == stood.parent) return;
  const auto moves = [&](const std::string& why) {
    session.warn("parent: " + node.name + " keeps its own values, and moves in the world: " + why);
  };
  const Placed placed(session.graph(), session.evaluator());
  const dmat4 above = node.parent ? placed.world_matrix(node.parent) : dmat4(1.0);
  const Placement before = placed.placement(node);
  const auto is_flat = [](const dmat4& m) { return !placement_of(m, {}); };
  if (is_flat(above)) return moves("its parent is scaled by 0");
  const auto found = placement_of(glm::inverse(above) * stood.world, before);
  if (!found) return moves("it is scaled by 0");
  if (matrix_of(found->placement) == matrix_of(before)) return;
  if (const std::string problem = fixed_place(session, node); !problem.empty()) return moves(problem);
  write_place(session, node, found->placement);
  if (found->sheared && node.schema->find("scale") != graph::no_attribute)
    session.warn("parent: " + node.name +
                 " changes its shape: turned within a parent that is stretched it would have to be sheared");
}

}  // namespace

void extend_parent_command(Workspace& workspace) {
  graph::CommandRegistry& commands = workspace.session().commands();
  graph::CommandSpec spec = commands.get("parent");
  commands.remove(spec.name);
  spec.help =
      "Puts nodes under another one in the transform hierarchy; they stay where they are in the world.";
  spec.flags.push_back({"relative", "they keep their values instead, and move with their new parent", {}});
  spec.run = [put = spec.run](Session& session, const Arguments& arguments) {
    const graph::Graph& graph = session.graph();
    std::vector<Stood> before;
    if (!arguments.has("relative")) {
      const Placed placed(graph, session.evaluator());
      for (const NodeId id : graph::matching_nodes(graph, arguments.texts("nodes"))) try {
          before.push_back({id, graph.find(id)->parent, placed.world_matrix(id)});
        } catch (const graph::GraphError&) {
          // What drives it failed: where it stands is not known.
        }
    }
    CommandResult result = put(session, arguments);
    for (const Stood& stood : before) keep_place(session, stood);
    return result;
  };
  commands.add(std::move(spec));
}

}  // namespace plinian::scene
