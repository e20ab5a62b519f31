// A colour of a node: a swatch beside its fields, and what a click on it opens.
#pragma once

#include <string>

#include "host/graph/model/plug.h"
#include "host/window/fields/hsv.h"
#include "host/window/studio.h"

namespace plinian::window {

struct ColourField {
  std::string name;       // "key.colour", as commands spell it
  graph::Plug plug;       // the whole colour
  vec3 linear{0.0f};      // as it is now
  bool enabled = true;    // can be edited
  std::string help = {};  // on the swatch, where it cannot be
};

/// One is enough for a panel: while it is open, the keys and the mouse are its own.
class ColourPicker {
 public:
  /// The swatch, as high and as wide as a field is high, and the picker while it is open. All that is done in
  /// there is one step of undo; Escape takes it back.
  void show(Studio& studio, const ColourField& field);

 private:
  void open(Studio& studio, const ColourField& field);
  void close(Studio& studio, bool takes_back);
  void follow(const ColourField& field);
  void show_hand(Studio& studio, const ColourField& field);
  void show_numbers(Studio& studio, const ColourField& field);
  void show_before(Studio& studio, const ColourField& field);
  void set(Studio& studio, const ColourField& field, const Hsv& hsv);
  void send(Studio& studio, const ColourField& field, const vec3& linear);

  std::string open_;                         // name of the colour it is open on; empty: closed
  vec2 pane_begin_{0.0f}, pane_size_{0.0f};  // [points] of the pane of the swatch
  float row_ = 0.0f;                         // [points] the upper end of its row
  vec2 size_{0.0f};                          // [points] its own, in the picture before
  Hsv hsv_;
  vec3 seen_{0.0f}, sent_{0.0f}, before_{0.0f};  // linear: last seen, last made of hsv_, when it was opened
  float brightest_ = 1.0f;                       // [display] value at the upper end of the square
  std::string merge_key_;
  std::uint64_t steps_ = 0;  // that the history had made when it was opened
};

}  // namespace plinian::window
