// Follows the graph by its generation.
#include "host/window/nodes/node_map.h"

#include <utility>

#include "host/window/nodes/layered_layout.h"

namespace plinian::window {

using graph::SceneMoment;

NodeMap::NodeMap(graph::Session& session, std::filesystem::path places_file)
    : session_(session), kept_(std::move(places_file)) {
  session_.add_listener(this);
  remembered_ = kept_.of(session_.scene_path());
}

NodeMap::~NodeMap() {
  keep_places();
  session_.remove_listener(this);
}

void NodeMap::keep_places() {
  if (places_.empty() || session_.scene_path().empty()) return;
  PlacesByName places;
  for (const auto& [id, place] : places_)
    if (const graph::Node* node = session_.graph().find(id)) places[node->name] = place;
  kept_.keep(session_.scene_path(), places);
}

void NodeMap::passed(SceneMoment moment, const std::string& path) {
  if (moment == SceneMoment::before_new || moment == SceneMoment::before_open ||
      moment == SceneMoment::after_save)
    keep_places();
  if (moment != SceneMoment::after_new && moment != SceneMoment::after_open) return;
  places_.clear();
  remembered_ = moment == SceneMoment::after_open ? kept_.of(path) : PlacesByName();
  choice = {};
  generation_ = ~std::uint64_t(0);
  ++scenes_;
}

const Diagram& NodeMap::update() {
  const graph::Graph& graph = session_.graph();
  if (generation_ == graph.generation() && shown_ == choice) return diagram_;
  generation_ = graph.generation();
  shown_ = choice;
  diagram_ = diagram_of(graph, choice);
  std::vector<LaidOut> boxes;
  LayoutEdges edges;
  for (const NodeBox& box : diagram_.boxes) {
    boxes.push_back({size_of(box), std::nullopt});
    if (const auto known = places_.find(box.id); known != places_.end())
      boxes.back().place = known->second;
    else if (const auto kept = remembered_.find(box.name); kept != remembered_.end())
      boxes.back().place = kept->second;
  }
  for (const Lineage& lineage : diagram_.lineages) edges.emplace_back(lineage.parent, lineage.child);
  for (const Wire& wire : diagram_.wires) edges.emplace_back(wire.from_box, wire.to_box);
  lay_out(boxes, edges);
  for (std::size_t i = 0; i < boxes.size(); ++i) move(i, boxes[i].place.value_or(vec2(0.0f)));
  return diagram_;
}

void NodeMap::move(std::size_t box, vec2 place) {
  diagram_.boxes[box].place = place;
  places_[diagram_.boxes[box].id] = place;
}

void NodeMap::lay_out_anew() {
  for (const NodeBox& box : diagram_.boxes) {
    places_.erase(box.id);
    remembered_.erase(box.name);
  }
  generation_ = ~std::uint64_t(0);
}

}  // namespace plinian::window
