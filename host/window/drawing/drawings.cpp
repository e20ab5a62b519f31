// From the driver to the canvas.
#include "host/window/drawing/drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/graph/graph_error.h"
#include "host/scene/placed.h"

namespace plinian::window {

namespace {

constexpr std::chrono::milliseconds budget(
    4);  // of uploads in a turn; a slice is the plug-in's to keep short

bool is_finite(const dmat4& matrix) {
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite(matrix[i / 4][i % 4])) return false;
  return true;
}

}  // namespace

Drawings::Drawings(Studio& studio, draw::DrawDriver::GlLoader loader)
    : studio_(studio), driver_(studio.session(), studio.workspace.plugins(), std::move(loader)) {}

bool Drawings::update() {
  const draw::DrawDriver::Counters before = driver_.counters();
  const bool was_busy = busy_;
  busy_ = driver_.prepare();
  busy_ = driver_.upload(budget) || busy_;
  find_places();
  const bool is_seen = studio_.overlay.drawings && !places_.empty();
  studio_.wants_light_maps = is_seen;
  const LightMapCopyPtr maps = maps_.shown();
  if (!is_seen) {
    canvas_.clear();
    beneath_ = nullptr;
    drawn_ = {};
  }
  busy_ = maps_.upload(is_seen && beneath_ ? beneath_->light_maps : nullptr, budget) || busy_;
  const std::vector<std::string> reports = driver_.take_reports();
  for (const std::string& line : reports) tell(line);
  const draw::DrawDriver::Counters& now = driver_.counters();
  return !reports.empty() || was_busy != busy_ || maps != maps_.shown() || now.uploads != before.uploads ||
         now.releases != before.releases;
}

void Drawings::tell(const std::string& line) {
  studio_.console.add(LineKind::error, line);
  studio_.trace.note("told " + line);
}

// World matrices of what would be drawn; what is hidden has none.
void Drawings::find_places() {
  graph::Session& session = studio_.session();
  const std::vector<graph::NodeId> drawable = driver_.drawable();
  const Moment now{session.graph().generation(), driver_.counters().uploads,
                   driver_.counters().releases,  drawable.size(),
                   session.evaluator().time(),   studio_.workspace.view().isolated};
  if (now == moment_) return;
  moment_ = now;
  places_.clear();
  const scene::Placed placed(session.graph(), session.evaluator());
  std::set<std::string> unplaced;
  for (const graph::NodeId node : drawable) try {
      if (!placed.is_shown(node, now.isolated)) continue;
      const dmat4 matrix = placed.world_matrix(node);
      if (is_finite(matrix)) places_.emplace(node, matrix);
    } catch (const graph::GraphError& error) {
      unplaced.insert(session.graph().find(node)->name + ": " + error.what());
    }
  for (const std::string& line : unplaced)
    if (!unplaced_.contains(line)) tell(line);
  unplaced_ = std::move(unplaced);
}

std::optional<dmat4> Drawings::place(graph::NodeId node) const {
  const auto found = places_.find(node);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

Canvas* Drawings::over(const DevelopedPtr& picture, float points) {
  if (!studio_.overlay.drawings || places_.empty() || !picture) return nullptr;
  beneath_ = picture->picture;
  const auto now = [&] {
    return Drawn{picture,
                 places_,
                 studio_.session().graph().selection(),
                 maps_.shown(),
                 driver_.counters().uploads,
                 driver_.counters().releases,
                 driver_.drawable().size(),
                 studio_.session().evaluator().time(),
                 points};
  };
  // What an override drew before it failed is not left standing: each time one of them drops out.
  while (canvas_.size() == ivec2(0) || !(now() == drawn_)) {
    drawn_ = now();
    draw(picture, points);
  }
  return &canvas_;
}

void Drawings::draw(const DevelopedPtr& picture, float points) {
  const auto begin = std::chrono::steady_clock::now();
  const SceneSnapshot& scene = beneath_->scene;
  const ViewMatrices matrices = view_matrices(scene, beneath_->extent->all());
  near_depth_ = matrices.near_depth;
  canvas_.begin(picture, matrices);
  view_ = {};
  view_.view_from_world = matrices.view_from_world;
  view_.clip_from_view = matrices.clip_from_view;
  view_.viewport = view_.gate = ivec4(0, 0, canvas_.size().x, canvas_.size().y);
  view_.framebuffer = canvas_.framebuffer();
  view_.colour = canvas_.radiance();
  view_.depth = canvas_.distances();
  view_.pixel_ratio = float(canvas_.size().x) / std::max(points, 1.0f);
  // Until the maps of this picture are there those before it do, as long as they are of as many lights.
  const bool fit = maps_.shown() == beneath_->light_maps || maps_.maps().size() == scene.lights.size();
  view_.lights = draw::lights_of(scene, fit ? maps_.maps() : std::vector<GlLightMap>());
  driver_.draw(view_, [this](graph::NodeId node) { return place(node); });
  if (studio_.trace.is_on())
    studio_.trace.note(fmt::format(
        "drawings {} over picture {} {:.1f} ms", places_.size(), beneath_->number,
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count()));
}

std::optional<Drawings::Hit> Drawings::hit(vec2 at) {
  if (!beneath_ || !studio_.overlay.drawings || canvas_.size() == ivec2(0)) return std::nullopt;
  const vec2 size(canvas_.size());
  const vec2 pixel = vec2(at.x, 1.0f - at.y) * size;
  auto found = driver_.hit(
      view_, [this](graph::NodeId node) { return place(node); }, pixel);
  for (const auto& [node, matrix] : places_) {
    if (driver_.has_hit(node)) continue;
    const auto alone = [this, only = node](graph::NodeId other) {
      return other == only ? place(other) : std::nullopt;
    };
    const auto depth =
        touch_.depth_at(view_, pixel, [&](const draw::DrawView& view) { driver_.draw(view, alone); });
    if (!depth) continue;
    // What writes no depth lies over everything.
    const double along_axis = *depth < 1.0f ? near_depth_ / (1.0 - double(*depth)) : near_depth_;
    const dvec2 film = (dvec2(at.x, 1.0f - at.y) * 2.0 - 1.0 + dvec2(view_.clip_from_view[2])) /
                       dvec2(view_.clip_from_view[0][0], view_.clip_from_view[1][1]);
    const double distance = along_axis * std::sqrt(1.0 + glm::dot(film, film));
    if (!found || distance < found->distance) found = draw::DrawDriver::Hit{node, distance};
  }
  const graph::Node* node = found ? studio_.session().graph().find(found->node) : nullptr;
  if (!node) return std::nullopt;
  const Frame& frame = beneath_->frame;
  const int x = std::clamp(int(at.x * float(frame.width)), 0, frame.width - 1);
  const int y = std::clamp(int(at.y * float(frame.height)), 0, frame.height - 1);
  const double seen = frame.depth[std::size_t(y) * std::size_t(frame.width) + std::size_t(x)];
  constexpr double tolerance = 1e-3;  // where it lies on the medium
  if (found->distance > seen * (1.0 + tolerance)) return std::nullopt;
  return Hit{node->name, found->distance};
}

}  // namespace plinian::window
