// The lights at a glance: on, alone, how bright, what colour.
#pragma once

#include <string>

#include "host/window/fields/driven_values.h"
#include "host/window/panels/colour_picker.h"
#include "host/window/panels/widgets.h"
#include "host/window/studio.h"

namespace plinian::window {

class LightPanel {
 public:
  void show(Studio& studio, const PaneRect& pane, DrivenValues& driven);

 private:
  void show_light(Studio& studio, const graph::Node& node, DrivenValues& driven);
  void show_colour(Studio& studio, const graph::Node& node, DrivenValues& driven);

  std::string merge_key_;  // of the drag under way
  ColourPicker picker_;
};

}  // namespace plinian::window
