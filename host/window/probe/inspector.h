// Looks into a pixel of the picture: what its ray meets, and how a light fades on its way to a point of it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/integrate/ray_probe.h"
#include "host/window/panels/layout.h"
#include "host/window/platform/newest_worker.h"
#include "host/window/view/view_renderer.h"

namespace plinian::window {

/// What is asked of a picture.
struct Inspected {
  ViewPicturePtr picture;
  ivec2 pixel{0};           // of the picture at rest, from the upper left corner
  std::optional<double> t;  // [world] on the ray where the light is probed; none: see ViewRayProbe::middle
  std::string light;        // its name; the first where there is none of it
};

/// What was found. It holds nothing of the picture, whose volumes are large.
struct Inspection {
  ivec2 pixel{0};          // that was asked for
  float threshold = 0.0f;  // [-] transmittance at which light counts as dead in the picture's maps
  ViewRayProbe view;
  double t = 0.0;  // [world] where the light was probed
  std::vector<std::string> lights;
  std::optional<LightRayProbe> light;  // none: the ray meets no medium, or there is no light
  std::string error;                   // one line; empty where all is well
};
using InspectionPtr = std::shared_ptr<const Inspection>;

class Inspector {
 public:
  /// wake: as ViewRenderer's.
  explicit Inspector(std::function<void()> wake);

  bool on = false;                // the panel is open, and the mouse chooses a pixel
  std::optional<vec2> place;      // [-] of the picture, from its upper left corner
  std::optional<double> t;        // [world] that was chosen on the ray
  std::string light;              // that was chosen
  std::optional<ProbeSpot> spot;  // where the card was dragged to; none: it lies where it hides least
  bool is_docked = false;         // ... which is beneath the picture, in place of the console
  bool is_behind = false;         // there, while something else is looked at
  bool is_beneath() const { return on && is_docked && !is_behind; }

  /// Asks for what is chosen in the picture, where that is another question than the last. To be called once
  /// a turn.
  void update(const ViewPicturePtr& picture);
  /// The newest, or null.
  InspectionPtr inspection() const { return worker_.answer(); }

 private:
  std::uint64_t asked_number_ = 0;
  ivec2 asked_pixel_{-1};
  std::optional<double> asked_t_;
  std::string asked_light_;
  NewestWorker<Inspected, Inspection> worker_;
};

}  // namespace plinian::window
