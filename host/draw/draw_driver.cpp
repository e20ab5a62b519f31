// The life of draw data: asked for, prepared, uploaded, drawn, released.
#include "host/draw/draw_driver.h"

#include <epoxy/gl.h>

#include <unordered_map>
#include <utility>

#include "host/draw/gl_state.h"
#include "host/graph/graph_error.h"
#include "host/sdk/inside_plugin.h"

namespace plinian::draw {

using graph::DataPtr;
using sdk::DrawOverridePtr;

struct DrawDriver::Item {
  graph::NodeId node;
  std::string type;
  DrawOverridePtr override_;
  graph::Plug plug;                         // of its draw data
  graph::Evaluator::RequestId request = 0;  // in flight; 0: none
  DataPtr shown, next;                      // drawn, and being uploaded
  void *resources = nullptr, *next_resources = nullptr;
  bool drawable = false, failed = false;  // failed: with the data that are shown
  std::string told;                       // the failure that was reported last
};

namespace {

void copy(const dmat4& from, double (&to)[16]) {
  for (int i = 0; i < 16; ++i) to[i] = from[i / 4][i % 4];
}

void copy(const ivec4& from, std::int32_t (&to)[4]) {
  for (int i = 0; i < 4; ++i) to[i] = from[i];
}

// A context that was lost reports errors without end.
void forget_errors() {
  for (int i = 0; i < 100 && glGetError() != GL_NO_ERROR; ++i) {
  }
}

}  // namespace

DrawDriver::DrawDriver(graph::Session& session, sdk::PluginManager& plugins, GlLoader loader)
    : session_(session), plugins_(plugins), loader_(std::move(loader)) {
  gl_.size = sizeof(gl_);
  gl_.self = this;
  gl_.function = [](void* self, const char* name) { return static_cast<DrawDriver*>(self)->loader_(name); };
  gl_.fail = [](void* self, const char* message) {
    static_cast<DrawDriver*>(self)->failure_ = message ? message : "";
  };
  plugins_.add_listener(this);
}

DrawDriver::~DrawDriver() {
  plugins_.remove_listener(this);
  for (auto& [node, item] : items_) drop(*item);
}

// Nodes that have an override now, and no others.
void DrawDriver::find_items() {
  std::unordered_map<const graph::NodeType*, graph::AttributeIndex>
      outputs;  // there are fewer types than nodes
  const graph::Graph& graph = session_.graph();
  if (graph.generation() == generation_) return;
  generation_ = graph.generation();
  for (auto at = items_.begin(); at != items_.end();) {
    const graph::Node* node = graph.find(at->first);
    if (node && node->type->name() == at->second->type && !node->type->is_unknown()) {
      ++at;
      continue;
    }
    drop(*at->second);
    at = items_.erase(at);
  }
  for (const graph::Node* node : graph.nodes()) {
    const auto [known, is_new] = outputs.try_emplace(node->type.get(), graph::no_attribute);
    if (is_new) known->second = sdk::draw_data_of(*node->type);
    const graph::AttributeIndex output = known->second;
    if (output == graph::no_attribute || items_.contains(node->id)) continue;
    const DrawOverridePtr found = plugins_.draw_override(node->type->name());
    if (!found) continue;
    auto item = std::make_shared<Item>();
    item->node = node->id;
    item->type = node->type->name();
    item->override_ = found;
    item->plug = {node->id, output};
    items_.emplace(node->id, std::move(item));
  }
}

bool DrawDriver::prepare() {
  graph::Evaluator& evaluator = session_.evaluator();
  evaluator.poll();
  find_items();
  bool busy = false;
  for (auto& [node, item] : items_) {
    if (item->request == 0 && evaluator.is_dirty(item->plug)) {
      const std::weak_ptr<Item> weak = item;
      item->request = evaluator.request({item->plug}, [this, weak](const graph::Evaluator::Outcome& outcome) {
        const std::shared_ptr<Item> item = weak.lock();
        if (!item) return;
        item->request = 0;
        if (outcome.cancelled || outcome.results.empty() || !outcome.results[0]->error) return;
        report(*item, "prepare failed: " + session_.evaluator().error_text(item->plug, *outcome.results[0]));
      });
    }
    if (item->request != 0) {
      busy = true;
      continue;
    }
    const graph::ResultPtr result = evaluator.last_good(item->plug);
    if (!result || evaluator.is_dirty(item->plug)) continue;
    const auto* data = std::get_if<DataPtr>(&result->value);
    if (!data || !*data || *data == (item->next ? item->next : item->shown)) continue;
    ++counters_.prepared;
    release(*item, item->next_resources);
    item->next = *data;
    if (item->next == item->shown) item->next = nullptr;  // taken back before it was uploaded
  }
  return busy;
}

void DrawDriver::report(Item& item, const std::string& what) {
  if (item.told == what) return;
  item.told = what;
  const graph::Node* node = session_.graph().find(item.node);
  reports_.push_back((node ? node->name : item.type) + ": " + what);
}

// Runs a function of the plug-in; the state of GL is what it was before. False where it failed, which is
// told.
bool DrawDriver::guarded_by_state(Item& item, const char* what, const char* doing,
                                  const std::function<bool()>& action) {
  forget_errors();
  failure_.clear();
  bool success = false;
  GLenum error = GL_NO_ERROR;
  {
    const GlState state;
    const graph::Node* node = session_.graph().find(item.node);
    const sdk::InsidePlugin inside(item.override_->owner, doing, (node ? node->name : item.type).c_str());
    try {
      success = action();
    } catch (...) {
      failure_ = "it threw an exception";  // an override that does not use plugin.h
      success = false;
    }
    error = glGetError();
  }
  forget_errors();
  if (success && error == GL_NO_ERROR) return true;
  if (success) {
    static const char* digits = "0123456789abcdef";
    failure_ = std::string("it left the GL error 0x0") + digits[error >> 8 & 15] + digits[error >> 4 & 15] +
               digits[error & 15];
  }
  report(item, std::string(what) + " failed: " + (failure_.empty() ? "no reason is given" : failure_));
  return false;
}

void DrawDriver::release(Item& item, void*& resources) {
  if (!resources) return;
  const PlinianDraw& draw = item.override_->table;
  if (draw.release)
    guarded_by_state(item, "release", "releasing what is drawn of", [&] {
      draw.release(draw.user, &gl_, resources);
      return failure_.empty();
    });
  ++counters_.releases;
  resources = nullptr;
}

void DrawDriver::drop(Item& item) {
  if (item.request != 0) session_.evaluator().cancel(item.request);
  release(item, item.next_resources);
  release(item, item.resources);
  item.shown = item.next = nullptr;
  item.drawable = false;
}

void DrawDriver::goes(const std::string& node_type) {
  for (auto at = items_.begin(); at != items_.end();) {
    if (at->second->type != node_type) {
      ++at;
      continue;
    }
    drop(*at->second);
    at = items_.erase(at);
  }
  generation_ = ~std::uint64_t(0);
}

// Whether the item is done with its upload, well or badly.
bool DrawDriver::upload_slice(Item& item) {
  const PlinianDraw& draw = item.override_->table;
  int done = 1;
  if (draw.upload) {
    ++counters_.slices;
    const bool success = guarded_by_state(item, "upload", "uploading what is drawn of", [&] {
      done = draw.upload(draw.user, &gl_, item.next->object.get(), &item.next_resources);
      return done >= 0;
    });
    if (success && done == 0) return false;
    if (!success) {
      // What was drawn before no longer is what the node says.
      release(item, item.next_resources);
      release(item, item.resources);
      item.shown = std::move(item.next);
      item.next = nullptr;
      item.drawable = false;
      return true;
    }
  }
  release(item, item.resources);
  item.resources = std::exchange(item.next_resources, nullptr);
  item.shown = std::move(item.next);
  item.next = nullptr;
  item.drawable = true;
  item.failed = false;
  ++counters_.uploads;
  return true;
}

bool DrawDriver::upload(std::chrono::microseconds budget) {
  const auto end = std::chrono::steady_clock::now() + budget;
  bool left = false;
  for (auto& [node, item] : items_)
    while (item->next) {
      if (std::chrono::steady_clock::now() >= end) {
        left = true;
        break;
      }
      upload_slice(*item);
    }
  return left;
}

PlinianDrawContext DrawDriver::context_for(const Item& item, const DrawView& view,
                                           const dmat4& world_from_object) const {
  PlinianDrawContext context{};
  context.size = sizeof(context);
  context.gl = &gl_;
  copy(world_from_object, context.world_from_object);
  copy(view.view_from_world, context.view_from_world);
  copy(view.clip_from_view, context.clip_from_view);
  copy(view.viewport, context.viewport);
  copy(view.gate, context.gate);
  context.framebuffer = view.framebuffer;
  context.colour = view.colour;
  context.depth = view.depth;
  lights_.put_into(context);
  const auto& selection = session_.graph().selection();
  for (const graph::NodeId node : selection)
    if (node == item.node) context.selection = node == selection.back() ? 2 : 1;
  context.pixel_ratio = view.pixel_ratio;
  context.frame = session_.evaluator().time();
  return context;
}

std::vector<graph::NodeId> DrawDriver::drawable() const {
  std::vector<graph::NodeId> nodes;
  for (const auto& [node, item] : items_)
    if (item->drawable && !item->failed && session_.graph().find(node)) nodes.push_back(node);
  return nodes;
}

namespace {

// What overrides may rely on.
void begin_state() {
  for (const GLenum off : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD})
    glDisable(off);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace

void DrawDriver::draw(const DrawView& view, const Place& place) {
  const GlState outer;
  begin_state();
  glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
  glViewport(view.viewport.x, view.viewport.y, view.viewport.z, view.viewport.w);
  lights_ = PlainLights(view.lights);
  for (auto& [node, item] : items_) {
    if (!item->drawable || item->failed || !session_.graph().find(node)) continue;
    const std::optional<dmat4> world_from_object = place(node);
    if (!world_from_object) continue;
    const PlinianDrawContext context = context_for(*item, view, *world_from_object);
    const PlinianDraw& draw = item->override_->table;
    ++counters_.draws;
    item->failed = !guarded_by_state(*item, "draw", "drawing", [&] {
      return draw.draw(draw.user, &context, item->shown->object.get(), item->resources) != 0;
    });
    if (!item->failed) item->told.clear();
  }
}

bool DrawDriver::has_hit(graph::NodeId node) const {
  const auto found = items_.find(node);
  return found != items_.end() && found->second->override_->table.hit;
}

std::optional<DrawDriver::Hit> DrawDriver::hit(const DrawView& view, const Place& place, vec2 pixel) {
  std::optional<Hit> nearest;
  for (auto& [node, item] : items_) {
    const PlinianDraw& draw = item->override_->table;
    if (!draw.hit || !item->drawable || item->failed || !session_.graph().find(node)) continue;
    const std::optional<dmat4> world_from_object = place(node);
    if (!world_from_object) continue;
    const PlinianDrawContext context = context_for(*item, view, *world_from_object);
    double distance = 0.0;
    bool is_hit = false;
    failure_.clear();
    {
      const sdk::InsidePlugin inside(item->override_->owner, "asked what is hit of",
                                     session_.graph().find(node)->name.c_str());
      try {
        is_hit = draw.hit(draw.user, &context, item->shown->object.get(), pixel.x, pixel.y, &distance) != 0;
      } catch (...) {
        failure_ = "it threw an exception";  // an override that does not use plugin.h
        is_hit = false;
      }
    }
    if (!failure_.empty()) report(*item, "hit failed: " + failure_);
    if (is_hit && (!nearest || distance < nearest->distance)) nearest = Hit{node, distance};
  }
  return nearest;
}

std::vector<std::string> DrawDriver::take_reports() {
  return std::exchange(reports_, {});
}

}  // namespace plinian::draw
