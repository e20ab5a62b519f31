// Asks, waits for nobody, builds.
#include "host/window/view/scene_feed.h"

#include "host/graph/graph_error.h"

namespace plinian::window {

SceneFeed::SceneFeed(scene::Workspace& workspace) : workspace_(workspace) {
  workspace_.session().graph().add_observer(this);
}

SceneFeed::~SceneFeed() {
  cancel();
  workspace_.session().graph().remove_observer(this);
}

void SceneFeed::edited(const graph::Edit& edit) {
  if (graph::changes_scene(edit)) changed_ = true;
}

graph::Evaluator::Progress SceneFeed::progress() const {
  const auto running = workspace_.session().evaluator().progress();
  return running.empty() ? graph::Evaluator::Progress() : running.back();
}

void SceneFeed::cancel() {
  if (request_ == 0) return;
  const auto request = request_;
  request_ = 0;
  workspace_.session().evaluator().cancel(request);
  changed_ = false;
}

bool SceneFeed::update() {
  graph::Session& session = workspace_.session();
  session.evaluator().poll();
  const scene::SceneView& view = workspace_.view();
  const Seen now{session.evaluator().time(), view.quality, view.camera, view.isolated};
  if (now != seen_) {
    seen_ = now;
    changed_ = true;
  }
  if (!changed_ || session.history().is_open()) return false;
  // In the middle of a computation that no edit has ended yet, there is nothing new to ask for.
  if (request_ != 0) return false;
  stale_ = true;
  std::vector<graph::Plug> missing;
  try {
    missing = scene::contributing_plugs(session, view);
  } catch (const graph::GraphError& error) {
    problems_ = {error.what()};
    changed_ = false;
    return false;
  }
  std::erase_if(missing, [&](const graph::Plug& plug) { return !session.evaluator().is_dirty(plug); });
  if (missing.empty()) return build();
  changed_ = false;
  request_ = session.evaluator().request(missing, [this](const graph::Evaluator::Outcome&) {
    request_ = 0;
    changed_ = true;
  });
  return false;
}

bool SceneFeed::build() {
  changed_ = false;
  try {
    auto built = std::make_shared<scene::BuiltSnapshot>(
        scene::build_snapshot(workspace_.session(), workspace_.view()));
    problems_ = built->problems;
    // What failed would be missing from the picture: better the one before, marked.
    if (!problems_.empty() && snapshot_) return false;
    snapshot_ = std::move(built);
    time_ = workspace_.session().evaluator().time();
    stale_ = !problems_.empty();
    return true;
  } catch (const graph::GraphError& error) {
    problems_ = {error.what()};
    return false;
  }
}

}  // namespace plinian::window
