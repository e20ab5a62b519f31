// What plug-ins draw over the picture: made ready a little in each turn, drawn when there is something new,
// asked where the mouse hits.
#pragma once

#include <map>
#include <set>

#include "host/draw/draw_driver.h"
#include "host/window/drawing/canvas.h"
#include "host/window/drawing/touch.h"
#include "host/window/studio.h"
#include "viewport/light_map_upload.h"

namespace plinian::window {

/// Everything on the interface's thread, with the window's context current, the destruction too.
class Drawings {
 public:
  /// loader: as DrawDriver's.
  Drawings(Studio& studio, draw::DrawDriver::GlLoader loader);

  /// Asks for what is missing and uploads for some milliseconds; failures go to the console. To be called
  /// once a turn. Returns whether something else is to be seen.
  bool update();
  /// Whether more is to come without anybody doing anything.
  bool is_busy() const { return busy_; }

  /// The picture with what is drawn over it, as large as it is at rest; null where nothing is. points: how
  /// wide it is shown.
  Canvas* over(const DevelopedPtr& picture, float points);

  struct Hit {
    std::string node;
    double distance = 0.0;  // [world] along the line of sight
  };
  /// The nearest node that says it is there or, where it does not know, is drawn there, and is not behind a
  /// medium. at: [-] of the picture that was
  /// drawn over last, from its upper left.
  std::optional<Hit> hit(vec2 at);

 private:
  // What places depend on.
  struct Moment {
    std::uint64_t generation = ~std::uint64_t(0), uploads = 0, releases = 0;
    std::size_t drawable = 0;
    double time = 0.0;
    std::set<graph::NodeId> isolated;
    bool operator==(const Moment&) const = default;
  };
  // What a drawing depends on.
  struct Drawn {
    DevelopedPtr picture;
    std::map<graph::NodeId, dmat4> places;
    std::vector<graph::NodeId> selection;
    LightMapCopyPtr maps;
    std::uint64_t uploads = 0, releases = 0;
    std::size_t drawable = 0;
    double time = 0.0;
    float points = 0.0f;
    bool operator==(const Drawn&) const = default;
  };
  void find_places();
  void tell(const std::string& line);
  void draw(const DevelopedPtr& picture, float points);
  std::optional<dmat4> place(graph::NodeId node) const;

  Studio& studio_;
  draw::DrawDriver driver_;
  Canvas canvas_;
  Touch touch_;
  LightMapUpload maps_;
  Moment moment_;
  std::map<graph::NodeId, dmat4> places_;  // world_from_object of what is visible
  std::set<std::string> unplaced_;         // why nodes have no place, as it was told
  ViewPicturePtr beneath_;                 // that was drawn over last
  Drawn drawn_;
  draw::DrawView view_;      // of that
  double near_depth_ = 0.0;  // [world] likewise
  bool busy_ = false;
};

}  // namespace plinian::window
