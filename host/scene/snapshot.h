// From the graph to the snapshot that renderers take.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/scene/framing.h"
#include "core/scene/snapshot.h"
#include "host/graph/commands/session.h"

namespace plinian::scene {

/// How a scene is looked at: no part of the scene, and nothing that undo knows of.
struct SceneView {
  graph::NodeId camera;          // 0: the one that renderSettings names, else the first there is
  std::string quality = "fast";  // the set of renderSettings that is on: fast or high
  // Where not empty, of what takes up light only these, what is above and what is under them. Lights and
  // cameras stay, but for those of shapes that take a volume or a medium.
  std::set<graph::NodeId> isolated;
  std::optional<ivec2> size;  // [pixels]; empty: as renderSettings says
  bool skip_unknown = false;  // shapes that fail for want of a node of an unknown type are left out
};

struct BuiltSnapshot {
  SceneSnapshot snapshot;
  std::vector<std::string> problems;  // shapes that are left out because they failed, one line for each cause
  std::vector<std::string> left_out;  // likewise: those that skip_unknown leaves out
  std::vector<std::string> notes;     // what was assumed
};

/// Pulls what every visible shape contributes at the current time, and places it in the world. Where nothing
/// that matters has changed it holds the same volumes as the one before, so that renderers keep theirs.
/// Throws GraphError where the place of a node cannot be told.
BuiltSnapshot build_snapshot(graph::Session& session, const SceneView& view);

/// The outputs that build_snapshot will ask for: what every shape says that may have a part in the picture.
/// Whoever cannot wait requests those that are dirty, and builds the snapshot once none is.
std::vector<graph::Plug> contributing_plugs(graph::Session& session, const SceneView& view);

/// Computes what build_snapshot will ask for on workers, and tells how far that is. Returns false where
/// `progress` returned false, and waits until all has stopped.
bool compute_contributions(graph::Session& session, const SceneView& view,
                           const std::function<bool(double share)>& progress);
/// As above, for outputs of one's own choice.
bool compute_plugs(graph::Session& session, std::vector<graph::Plug> plugs,
                   const std::function<bool(double share)>& progress);

/// The node of a type that was made first, or null.
const graph::Node* first_of_type(const graph::Graph& graph, const std::string& type);

/// The quality set of that name; the shipped one where the scene has no renderSettings. Throws GraphError
/// where there is no such set.
Quality quality_of(graph::Session& session, const std::string& set);

}  // namespace plinian::scene
