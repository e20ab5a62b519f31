// quality, isolate, frameView, snapshot: how a scene is looked at.
#include <fmt/format.h>

#include "core/scene/framing.h"
#include "core/scene/nearest_word.h"
#include "core/scene/placement.h"
#include "core/scene/scene_hash.h"
#include "core/scene/scene_loader.h"
#include "host/graph/graph_error.h"
#include "host/scene/placed.h"
#include "host/scene/scene_commands.h"
#include "host/sdk/contribution.h"

namespace plinian::scene {

using graph::Arguments;
using graph::CommandResult;
using graph::GraphError;
using graph::NodeId;
using graph::Session;

namespace {

CommandResult quality(Workspace& workspace, const Arguments& arguments) {
  if (arguments.has("set")) {
    quality_of(workspace.session(), arguments.text("set"));  // refuses what is none
    workspace.view().quality = arguments.text("set");
  }
  return {workspace.view().quality};
}

CommandResult isolate(Workspace& workspace, const Arguments& arguments) {
  workspace.view().isolated.clear();
  if (arguments.has("off")) return {};
  for (const NodeId id : graph::nodes_or_selection(workspace.session(), arguments.texts("nodes")))
    workspace.view().isolated.insert(id);
  return {};
}

// Where somebody looks on, workers compute, and what is looked at goes on being drawn.
void await_contributions(Session& session, const SceneView& view) {
  if (session.on_progress && !compute_contributions(session, view, session.on_progress))
    throw SceneLoadCancelled();
}

bool is_camera(Session& session, const graph::Node& node) {
  const graph::AttributeIndex output = sdk::contribution_of(*node.type);
  if (output == graph::no_attribute || node.schema->find("translate") == graph::no_attribute) return false;
  const graph::ResultPtr result = session.evaluator().evaluate({node.id, output});
  return result->error || !sdk::contribution_in(result->value)->cameras.empty();
}

// Moves the camera that is looked through, as the artist's hand would.
CommandResult frame_view(Workspace& workspace, const Arguments& arguments) {
  Session& session = workspace.session();
  SceneView view = workspace.view();
  if (const auto nodes = arguments.texts("nodes"); !nodes.empty()) {
    view.isolated.clear();
    for (const NodeId id : graph::matching_nodes(session.graph(), nodes)) view.isolated.insert(id);
  }
  await_contributions(session, view);
  const graph::Node* camera = nullptr;
  if (arguments.has("camera")) {
    camera = &session.graph().get(arguments.text("camera"));
  } else if (view.camera) {
    camera = session.graph().find(view.camera);
  } else {
    const graph::Node* settings = first_of_type(session.graph(), "renderSettings");
    if (settings)
      camera = session.graph().find(std::get<NodeId>(settings->value(settings->schema->find("camera"))));
    if (!camera) camera = first_of_type(session.graph(), "camera");
  }
  if (!camera) throw GraphError("frameView: the scene has no camera: createNode camera makes one");
  if (!is_camera(session, *camera))
    throw GraphError("frameView: " + camera->name + " (" + camera->type->name() + ") is no camera");
  view.camera = camera->id;
  const BuiltSnapshot now = build_snapshot(session, view);
  if (now.snapshot.media.empty()) {
    const std::string why = now.problems.empty() ? std::string() : ": " + now.problems.front();
    throw GraphError(arguments.has("nodes")
                         ? "frameView: there is no volume to frame in " + join(arguments.texts("nodes")) + why
                         : "frameView: there is nothing to frame: no volume is shown" + why);
  }
  const SceneBounds bounds = scene_bounds(now.snapshot.media);
  // From where it stands, unless it is told.
  const dmat4& stands = now.snapshot.camera.world_from_camera;
  const SkyAngles from = angles_of_direction(dvec3(stands[2]), dvec3(stands[0]));
  const double azimuth = arguments.number("azimuth").value_or(from.azimuth);
  const double elevation = arguments.number("elevation").value_or(from.elevation);
  const Camera framed =
      frame_bounds(now.snapshot.camera, bounds, azimuth, elevation, now.snapshot.width, now.snapshot.height);
  dmat4 parent(1.0);
  if (camera->parent) parent = Placed(session.graph(), session.evaluator()).world_matrix(camera->parent);
  const dmat4 own = glm::inverse(parent) * framed.world_from_camera;
  dmat4 turned = own;
  for (int i = 0; i < 3; ++i) turned[i] /= glm::length(dvec3(own[i]));
  const auto set = [&](const char* name, const dvec3& v) {
    session.execute("setAttr " + camera->name + "." + name + " " + graph::write_number(v.x) + " " +
                    graph::write_number(v.y) + " " + graph::write_number(v.z));
  };
  session.execute("setAttr " + camera->name + ".rotate_order xyz");
  set("translate", dvec3(own[3]));
  set("rotate", angles_of(turned));
  return {camera->name};
}

CommandResult snapshot(Workspace& workspace) {
  await_contributions(workspace.session(), workspace.view());
  const BuiltSnapshot built = build_snapshot(workspace.session(), workspace.view());
  if (!built.problems.empty())
    throw GraphError(
        "snapshot: " + built.problems.front() +
        (built.problems.size() > 1 ? fmt::format(" (and {} more)", built.problems.size() - 1) : ""));
  const SceneSnapshot& s = built.snapshot;
  CommandResult lines = {fmt::format("hash {}", scene_hash_text(s)),
                         fmt::format("size {} {}", s.width, s.height),
                         fmt::format("quality {} {}", workspace.view().quality, s.quality.name)};
  for (const Medium& medium : s.media)
    lines.push_back(
        fmt::format("medium {} {} voxels", medium.name, medium.volume ? medium.volume->active_voxels : 0));
  for (const Light& light : s.lights) lines.push_back("light " + light.name);
  return lines;
}

}  // namespace

void add_view_commands(Workspace& workspace) {
  using enum graph::ArgumentKind;
  graph::CommandRegistry& commands = workspace.session().commands();
  commands.add(
      {.name = "quality",
       .help = "Turns a quality set on and answers with the one that is; no edit, so that undo knows nothing "
               "of it.",
       .parameters = {{"set", text, "fast or high; else stays", true}},
       .run = [&workspace](Session&, const Arguments& a) { return quality(workspace, a); }});
  commands.add(
      {.name = "isolate",
       .help = "Shows only these nodes, what is above and what is under them, in the light of the scene; "
               "no edit.",
       .parameters = {{"nodes", node, "names or patterns; else the selection", true, true}},
       .flags = {{"off", "shows everything again", {}}},
       .run = [&workspace](Session&, const Arguments& a) { return isolate(workspace, a); }});
  commands.add({.name = "frameView",
                .help = "Moves the camera to where everything is in the picture, and answers with its name.",
                .parameters = {{"nodes", node, "only these have to be in it", true, true}},
                .flags = {{"camera", "which (the one that is looked through)", node},
                          {"azimuth", "from where, in degrees: 0 from +z, 90 from +x", number},
                          {"elevation", "likewise: 0 level, 90 from above", number}},
                .run = [&workspace](Session&, const Arguments& a) { return frame_view(workspace, a); }});
  commands.add(
      {.name = "snapshot",
       .help = "Answers with what a picture would show now: its hash, size, quality, media and lights.",
       .run = [&workspace](Session&, const Arguments&) { return snapshot(workspace); }});
}

}  // namespace plinian::scene
