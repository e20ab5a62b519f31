// The outliner: all nodes, those with a place as a tree, the rest beneath.
#pragma once

#include <set>
#include <string>

#include "host/window/panels/widgets.h"
#include "host/window/studio.h"

namespace plinian::window {

class OutlinerPanel {
 public:
  void show(Studio& studio, const PaneRect& pane);

 private:
  void show_node(Studio& studio, const graph::Node& node, bool tree);
  void select(Studio& studio, const graph::Node& node);

  char filter_[128] = "";
  graph::NodeId renamed_;
  bool focus_ = false;
  char name_[256] = "";
};

}  // namespace plinian::window
