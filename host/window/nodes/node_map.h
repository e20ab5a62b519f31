// The diagram of a session's scene, kept up to date: what is shown of it, where its boxes stand, and what
// failed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/graph/commands/session.h"
#include "host/window/nodes/diagram.h"
#include "host/window/nodes/node_places.h"

namespace plinian::window {

class NodeMap : private graph::SessionListener {
 public:
  /// places_file: see NodePlaces. The session must outlive it.
  NodeMap(graph::Session& session, std::filesystem::path places_file);
  ~NodeMap() override;
  NodeMap(const NodeMap&) = delete;
  NodeMap& operator=(const NodeMap&) = delete;

  DiagramChoice choice;

  /// The diagram of the graph and the choice as they are now, with a place for every box.
  const Diagram& update();
  const Diagram& diagram() const { return diagram_; }
  /// Puts a box somewhere else. [points of the canvas]
  void move(std::size_t box, vec2 place);
  /// Forgets where the boxes that are shown stand, and lays them out anew.
  void lay_out_anew();
  /// Counts scenes: another one calls for another look.
  std::uint64_t scenes() const { return scenes_; }

 private:
  void passed(graph::SceneMoment moment, const std::string& path) override;
  void begun() override {}
  void ended(bool) override {}
  void keep_places();

  graph::Session& session_;
  NodePlaces kept_;
  Diagram diagram_;
  DiagramChoice shown_;
  std::uint64_t generation_ = ~std::uint64_t(0);
  std::map<graph::NodeId, vec2> places_;  // also of nodes that are gone: undo brings them back
  PlacesByName remembered_;               // of nodes that were not there yet
  std::uint64_t scenes_ = 0;
};

}  // namespace plinian::window
