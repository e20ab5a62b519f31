// Pulls contributions and puts them into the world.
#include "host/scene/snapshot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "core/scene/default_lights.h"
#include "core/scene/nearest_word.h"
#include "core/scene/quality_parameters.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/scene/missing_types.h"
#include "host/scene/placed.h"
#include "host/sdk/abi/scene.h"
#include "host/sdk/contribution.h"

namespace plinian::scene {

using graph::Node;
using graph::NodeId;
using graph::Plug;

namespace {

// How much a matrix enlarges; exactly 1 where only rounding says otherwise.
double scale_of(const dmat4& matrix) {
  const double scale = std::cbrt(std::abs(glm::determinant(dmat3(matrix))));
  return std::abs(scale - 1.0) < 1e-9 ? 1.0 : scale;
}

std::string joined(const std::string& node, const std::string& name) {
  return name.empty() ? node : node + "_" + name;
}

Light placed_light(Light light, const std::string& node, const dmat4& world) {
  light.name = joined(node, light.name);
  light.position = vec3(dvec3(world * dvec4(dvec3(light.position), 1.0)));
  if (light.type != LightType::point) {
    const dvec3 toward = dmat3(world) * dvec3(light.toward);
    light.toward = vec3(toward / glm::length(toward));
  }
  light.radius = float(light.radius * scale_of(world));
  return light;
}

Camera placed_camera(Camera camera, const dmat4& world) {
  // A camera stays rigid, whatever it is under.
  const dmat4 matrix = world * camera.world_from_camera, rigid = sdk::rigid_part(matrix);
  double off = 0.0;
  for (int i = 0; i < 3; ++i) off = std::max(off, glm::length(dvec3(matrix[i] - rigid[i])));
  camera.world_from_camera = off > 1e-9 ? rigid : matrix;
  camera.near_clip = float(camera.near_clip * scale_of(world));
  return camera;
}

// Whether nodes of the type are shown or isolated away as a whole, so that those that are not are not
// computed.
bool takes_medium(const graph::NodeType& type) {
  const graph::Schema& schema = *type.schema();
  for (const graph::AttributeIndex index : schema.top())
    if (const graph::AttributeSpec& spec = schema[index].spec;
        !spec.output && (spec.data_type == PLINIAN_VOLUME_TYPE || spec.data_type == PLINIAN_MEDIUM_TYPE))
      return true;
  return false;
}

bool has_light_node(const graph::Graph& graph) {
  for (const Node* node : graph.nodes())
    for (const char* light : {"directionalLight", "spotLight", "pointLight", "ambientLight"})
      if (node->type->name() == light) return true;
  return false;
}

// What a bare volume on the command line is lit by. It stands still when the camera moves, so that looking
// around costs no map.
void add_default_lights(SceneSnapshot& snapshot) {
  const Camera front = look_at(direction_from(default_azimuth, 0.0), dvec3(0.0), dvec3(0, 1, 0), 40.0);
  snapshot.lights = {default_key(front), default_rim(front)};
  snapshot.ambient = default_ambient;
}

std::string described(const Node& unknown) {
  return unknown.name + ", whose type '" + unknown.type->name() + "' is not known here";
}

NodeId chosen_camera(graph::Session& session, const SceneView& view) {
  if (view.camera && session.graph().find(view.camera)) return view.camera;
  const Node* settings = first_of_type(session.graph(), "renderSettings");
  if (!settings) return {};
  const graph::Value& value = settings->value(settings->schema->find("camera"));
  const NodeId* camera = std::get_if<NodeId>(&value);
  return camera && session.graph().find(*camera) ? *camera : NodeId();
}

}  // namespace

std::vector<Plug> contributing_plugs(graph::Session& session, const SceneView& view) {
  const Placed placed(session.graph(), session.evaluator());
  std::vector<Plug> plugs;
  for (const Node* node : session.graph().nodes()) {
    const graph::AttributeIndex output = sdk::contribution_of(*node->type);
    if (output == graph::no_attribute) continue;
    // A camera is looked through whether it is seen or not.
    if (node->id == view.camera || node->type->name() == "camera" ||
        placed.is_shown(node->id, takes_medium(*node->type) ? view.isolated : std::set<NodeId>()))
      plugs.push_back({node->id, output});
  }
  return plugs;
}

const Node* first_of_type(const graph::Graph& graph, const std::string& type) {
  for (const Node* node : graph.nodes())
    if (node->type->name() == type && !node->type->is_unknown()) return node;
  return nullptr;
}

Quality quality_of(graph::Session& session, const std::string& set) {
  if (set != "fast" && set != "high")
    throw graph::GraphError("there is no quality set " + graph::shown(set) +
                            did_you_mean(set, {"fast", "high"}) + "; there are: fast, high");
  const Node* settings = first_of_type(session.graph(), "renderSettings");
  // Without the node, as if there were one with nothing set.
  const graph::NodeTypePtr type = session.types().get("renderSettings");
  const Placed placed(session.graph(), session.evaluator());
  const graph::Schema& schema = settings ? *settings->schema : *type->schema();
  const auto value = [&](const std::string& path) {
    const graph::AttributeIndex attribute = schema.find(path);
    return settings ? placed.value({settings->id, attribute}) : schema[attribute].spec.default_value;
  };
  Quality quality;
  quality.name = std::get<std::string>(value(set + ".preset"));
  for (const Parameter<Quality>& parameter : quality_parameters()) {
    const graph::Value found = value(set + "." + parameter.spec.name);
    const double number = graph::number_of(found);
    if (parameter.spec.type == ParameterType::boolean)
      parameter.set(quality, number != 0.0);
    else if (parameter.spec.type == ParameterType::real)
      parameter.set(quality, number);
    else
      parameter.set(quality, int(number));
  }
  return quality;
}

bool compute_plugs(graph::Session& session, std::vector<Plug> plugs,
                   const std::function<bool(double)>& progress) {
  graph::Evaluator& evaluator = session.evaluator();
  const auto share_now = [&] {
    double share = 0.0;
    for (const auto& running : evaluator.progress()) share = running.fraction;
    return share;
  };
  // What is under way already is not computed twice.
  while (!evaluator.finish_within(std::chrono::milliseconds(2)))
    if (progress && !progress(share_now())) return false;
  std::erase_if(plugs, [&](const Plug& plug) { return !evaluator.is_dirty(plug); });
  if (plugs.empty()) return true;
  // Shared: where progress throws, the request ends when nobody waits for it.
  const auto ended = std::make_shared<bool>(false);
  const auto request = evaluator.request(plugs, [ended](const graph::Evaluator::Outcome&) { *ended = true; });
  bool wanted = true;
  while (!*ended) {
    evaluator.poll();
    if (*ended) break;
    // Whoever draws by it goes on doing so until all has stopped.
    if (progress && !progress(share_now()) && wanted) {
      wanted = false;
      evaluator.cancel(request);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return wanted;
}

bool compute_contributions(graph::Session& session, const SceneView& view,
                           const std::function<bool(double)>& progress) {
  return compute_plugs(session, contributing_plugs(session, view), progress);
}

BuiltSnapshot build_snapshot(graph::Session& session, const SceneView& view) {
  const graph::Graph& graph = session.graph();
  graph::Evaluator& evaluator = session.evaluator();
  const Placed placed(graph, evaluator);
  BuiltSnapshot built;
  SceneSnapshot& snapshot = built.snapshot;
  const NodeId wanted_camera = chosen_camera(session, view);
  bool has_camera = false;
  std::set<Plug> told;
  for (const Plug& plug : contributing_plugs(session, view)) {
    const Node& node = *graph.find(plug.node);
    const graph::ResultPtr result = evaluator.evaluate(plug);
    if (result->error) {
      const Plug& origin = result->error->origin;
      const Node* missing = view.skip_unknown ? unknown_source(graph, origin.node) : nullptr;
      if (missing)
        built.left_out.push_back(node.name + " is left out: it needs " + described(*missing));
      else if (told.insert(origin).second)
        built.problems.push_back(graph.name_of(origin) + ": " + result->error->message);
      continue;
    }
    if (const Node* missing = view.skip_unknown ? unknown_source(graph, node.id) : nullptr)
      built.left_out.push_back(node.name + " is shown without what it takes from " + described(*missing));
    const sdk::ShapeContributionPtr shape = sdk::contribution_in(result->value);
    const dmat4 world = placed.world_matrix(node.id);
    if (!shape->cameras.empty() && (wanted_camera ? node.id == wanted_camera : !has_camera)) {
      snapshot.camera = placed_camera(shape->cameras.front().camera, world);
      has_camera = true;
    }
    if (!placed.is_shown(node.id, {})) continue;
    for (const Light& light : shape->lights) snapshot.lights.push_back(placed_light(light, node.name, world));
    snapshot.ambient += shape->ambient;
    if (!placed.is_shown(node.id, view.isolated)) continue;
    for (Medium medium : shape->media) {
      medium.name = joined(node.name, medium.name);
      medium.world_from_medium = world * medium.world_from_medium;
      snapshot.media.push_back(std::move(medium));
    }
  }
  const Node* settings = first_of_type(graph, "renderSettings");
  if (settings) {
    const auto side = [&](const char* name) { return int(placed.number(placed.plug(*settings, name))); };
    snapshot.width = side("width");
    snapshot.height = side("height");
    snapshot.background = std::get<vec3>(placed.value(placed.plug(*settings, "background")));
  }
  const bool wanted_dark = settings && placed.number(placed.plug(*settings, "default_lights")) == 0.0;
  if (!wanted_dark && !snapshot.media.empty() && snapshot.lights.empty() && snapshot.ambient == vec3(0.0f) &&
      !has_light_node(graph)) {
    add_default_lights(snapshot);
    built.notes.push_back(
        std::string("the scene has no lights: a key, a rim and a sky stand in for them (default_lights of ") +
        (settings ? settings->name : "renderSettings, which createNode makes") + ")");
  }
  if (view.size) {
    snapshot.width = view.size->x;
    snapshot.height = view.size->y;
  }
  if (!has_camera) {
    const SceneBounds bounds = scene_bounds(snapshot.media);
    snapshot.camera = frame_bounds(Camera(), bounds, default_azimuth, default_elevation(bounds),
                                   snapshot.width, snapshot.height);
    built.notes.push_back("the scene has no camera: one was placed to show everything");
  }
  snapshot.quality = quality_of(session, view.quality);
  return built;
}

}  // namespace plinian::scene
