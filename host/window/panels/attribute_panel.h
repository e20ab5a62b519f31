// The attribute editor: everything that the selected node can be set to.
#pragma once

#include <string>
#include <vector>

#include "host/window/fields/attribute_rows.h"
#include "host/window/fields/driven_values.h"
#include "host/window/panels/angle_rows.h"
#include "host/window/panels/colour_picker.h"
#include "host/window/panels/widgets.h"
#include "host/window/studio.h"

namespace plinian::window {

class AttributePanel {
 public:
  void show(Studio& studio, const PaneRect& pane);
  /// Opens the group of an attribute of the node that is shown next, scrolls there, and gives its field the
  /// keys. name: "medium.density_scale".
  void seek(std::string name);

  DrivenValues driven;

 private:
  // As it is now, also where it is driven.
  double number_now(Studio& studio, const AttributeRow& row, const graph::Plug& part);
  void refresh(Studio& studio);
  void begin_seeking();
  bool is_sought(const AttributeGroup& group) const;
  void find_sought(Studio& studio, const AttributeRow& row);
  void show_row(Studio& studio, const AttributeRow& row);
  void show_value(Studio& studio, const AttributeRow& row, float width);
  void show_numbers(Studio& studio, const AttributeRow& row, float width);

  std::uint64_t generation_ = ~std::uint64_t(0);
  graph::NodeId node_;
  std::vector<AttributeGroup> groups_;
  std::string merge_key_;  // of the drag under way
  // An attribute that is sought: brought into sight in one picture, given the keys in the next.
  std::string sought_, marked_;  // marked_: until a hand does something else
  int sought_for_ = 0;           // pictures
  bool is_in_sight_ = false;
  ColourPicker picker_;
  AngleRows angles_;
};

}  // namespace plinian::window
