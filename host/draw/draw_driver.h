// Runs the draw overrides of a scene's nodes: has their draw data made by workers, uploads them in slices,
// draws.
//
// Everything is called on the thread of the session, with the GL context current where that is said. What was
// drawn before goes on being drawn until what replaces it is uploaded.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/draw/draw_lights.h"
#include "host/sdk/plugin_manager.h"

namespace plinian::draw {

/// Where to draw, and what is there. Fields as in PlinianDrawContext.
struct DrawView {
  dmat4 view_from_world{1.0}, clip_from_view{1.0};
  ivec4 viewport{0}, gate{0};                       // [pixels] x, y, width, height
  unsigned framebuffer = 0, colour = 0, depth = 0;  // GL names
  std::vector<DrawLight> lights;
  float pixel_ratio = 1.0f;
};

class DrawDriver : private sdk::DrawOverrideListener {
 public:
  /// The address of a GL function; null where there is none.
  using GlLoader = std::function<void*(const char* name)>;
  /// Where a node stands in the world; none where it is hidden.
  using Place = std::function<std::optional<dmat4>(graph::NodeId)>;

  DrawDriver(graph::Session& session, sdk::PluginManager& plugins, GlLoader loader);
  /// With the context current: releases everything.
  ~DrawDriver() override;
  DrawDriver(const DrawDriver&) = delete;
  DrawDriver& operator=(const DrawDriver&) = delete;

  /// Asks workers for draw data that an edit has made old, and takes over what is ready. No GL. Returns
  /// whether anything is still being prepared.
  bool prepare();
  /// Uploads for about that long. Returns whether anything is left to be uploaded.
  bool upload(std::chrono::microseconds budget);
  /// Nodes of which something would be drawn where they are visible.
  std::vector<graph::NodeId> drawable() const;
  /// Draws everything that is uploaded and visible. Binds the view's framebuffer and viewport for it; what is
  /// nearer hides what is further, nothing is blended or culled until an override asks for it.
  void draw(const DrawView& view, const Place& place);
  /// The nearest node that an override says is at a pixel of the framebuffer (from its lower left), and how
  /// far along the view ray that is [world]. No GL.
  struct Hit {
    graph::NodeId node;
    double distance = 0.0;
  };
  /// Whether hit() asks the override of a node; where not, only drawing it tells.
  bool has_hit(graph::NodeId node) const;
  std::optional<Hit> hit(const DrawView& view, const Place& place, vec2 pixel);

  /// What failed since the last call, one line for each cause: what fails in the same way time after time
  /// is told once, until it was drawn.
  std::vector<std::string> take_reports();

  struct Counters {
    std::uint64_t prepared = 0, uploads = 0, slices = 0, draws = 0, releases = 0;
  };
  const Counters& counters() const { return counters_; }

 private:
  struct Item;
  void goes(const std::string& node_type) override;
  void find_items();
  bool upload_slice(Item& item);
  void release(Item& item, void*& resources);
  void drop(Item& item);
  void report(Item& item, const std::string& what);
  bool guarded_by_state(Item& item, const char* what, const char* doing, const std::function<bool()>& action);
  PlinianDrawContext context_for(const Item& item, const DrawView& view,
                                 const dmat4& world_from_object) const;

  graph::Session& session_;
  sdk::PluginManager& plugins_;
  GlLoader loader_;
  PlinianGl gl_{};
  std::string failure_;  // what the function that runs says of itself
  std::map<graph::NodeId, std::shared_ptr<Item>> items_;
  PlainLights lights_;  // of the view that is drawn
  std::uint64_t generation_ = ~std::uint64_t(0);
  std::vector<std::string> reports_;
  Counters counters_;
};

}  // namespace plinian::draw
