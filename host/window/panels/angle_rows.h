// Where in the sky a light stands, as two rows of the attribute editor: set through its rotation.
#pragma once

#include <string>

#include "host/window/fields/driven_values.h"
#include "host/window/fields/number_drag.h"
#include "host/window/studio.h"

namespace plinian::window {

class AngleRows {
 public:
  /// The rows of a light that shines one way; of any other node nothing. Other selected lights follow.
  void show(Studio& studio, const graph::Node& node, DrivenValues& driven);

 private:
  void show_angle(Studio& studio, const graph::Node& node, DrivenValues& driven, bool is_azimuth);

  std::string merge_key_;  // of the drag under way
};

}  // namespace plinian::window
