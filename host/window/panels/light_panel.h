// The lights at a glance: on, alone, how bright, what colour.
#pragma once

#include <string>

#include "host/window/panels/widgets.h"
#include "host/window/studio.h"

namespace plinian::window {

class LightPanel {
 public:
  void show(Studio& studio, const PaneRect& pane);

 private:
  void show_light(Studio& studio, const graph::Node& node);

  std::string merge_key_;  // of the drag under way
};

}  // namespace plinian::window
